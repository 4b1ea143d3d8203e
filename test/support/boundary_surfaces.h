// SPDX-License-Identifier: MIT
//
// Surfaces with small angles, coplanar facets, several regions: what boundary refinement has to cope with.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "refine/surface.h"
#include "test/support/clouds.h"
#include "test/support/surfaces.h"

namespace sinkmesh::test {

template <int Dim>
struct NamedSurface {
  std::string name;
  Surface<Dim> surface;
  double measure;  ///< volume or area of what is inside
  bool is_exact;   ///< axis-parallel: divided without rounding
};

/// The surface of the cube [0,n]^3 cut into unit squares of two triangles, outward. The diagonals of squares
/// run one way where `seed` says so at random; 0: all alike.
inline Surface3 grid_cube(int n, std::uint64_t seed = 0) {
  Surface3 s;
  Random random(seed);
  std::map<Point3, std::uint32_t> ids;
  const auto id = [&](const Point3& p) {
    const auto [known, is_new] = ids.try_emplace(p, static_cast<std::uint32_t>(s.points.size()));
    if (is_new) s.points.push_back(p);
    return known->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int level : {0, n}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          std::array<std::uint32_t, 4> v;
          for (std::size_t k = 0; k < 4; ++k) {
            Point3 p;
            p[axis] = level;
            p[(axis + 1) % 3] = i + (k == 1 || k == 2 ? 1 : 0);
            p[(axis + 2) % 3] = j + (k >= 2 ? 1 : 0);
            v[k] = id(p);
          }
          if (level == 0) std::swap(v[1], v[3]);
          if (seed != 0 && random() % 2 != 0) std::rotate(v.begin(), v.begin() + 1, v.end());
          s.facets.push_back({v[0], v[1], v[2]});
          s.facets.push_back({v[0], v[2], v[3]});
        }
      }
    }
  }
  return s;
}

/// A prism over a triangulated polygon: counterclockwise boundary 0, 1, ..., and triangles over it.
inline Surface3 prism(const std::vector<Point2>& polygon,
                      const std::vector<std::array<std::uint32_t, 3>>& triangles, double height) {
  Surface3 s;
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (const double z : {0.0, height}) {
    for (const Point2& p : polygon) s.points.push_back({p[0], p[1], z});
  }
  for (const auto& [a, b, c] : triangles) {
    s.facets.push_back({a, c, b});
    s.facets.push_back({a + n, b + n, c + n});
  }
  for (std::uint32_t a = 0; a < n; ++a) {
    const std::uint32_t b = (a + 1) % n;
    s.facets.push_back({a, b, b + n});
    s.facets.push_back({a, b + n, a + n});
  }
  return s;
}

/// A prism over an isosceles triangle with this angle, of leg 1.
inline Surface3 wedge(double degrees) {
  const double a = degrees * std::numbers::pi / 180;
  return prism({{0, 0}, {1, 0}, {std::cos(a), std::sin(a)}}, {{0, 1, 2}}, 1);
}

/// Schoenhardt's polyhedron: a twisted prism that no tetrahedra without further points fill.
inline Surface3 schoenhardt(double twist = 30) {
  Surface3 s;
  for (int k = 0; k < 6; ++k) {
    const double angle = (k % 3 * 120 + (k < 3 ? 0 : -twist)) * std::numbers::pi / 180;
    s.points.push_back({std::cos(angle), std::sin(angle), k < 3 ? 0.0 : 1.0});
  }
  s.facets = {{0, 2, 1}, {3, 4, 5}};
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t l = (k + 1) % 3;
    s.facets.push_back({k, l, k + 3});  // the edge from l to k+3 bends inward
    s.facets.push_back({l, l + 3, k + 3});
  }
  return s;
}

inline Surface3 star_polyhedron(std::uint64_t seed) {
  Surface3 s = ellipsoid_surface(1, {1, 1, 1});
  Random random(seed);
  for (Point3& p : s.points) {
    const double radius = uniform(random, 0.4, 1);
    for (double& x : p) x *= radius;
  }
  return s;
}

/// Two unit boxes along x; the side between them is given once, or not at all.
inline Surface3 two_boxes(bool with_wall) {
  Surface3 s;
  for (int i = 0; i < 12; ++i) {
    s.points.push_back(
        {static_cast<double>(i / 4), static_cast<double>(i / 2 % 2), static_cast<double>(i % 2)});
  }
  const auto add = [&s](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    s.facets.push_back({a, b, c});
    s.facets.push_back({a, c, d});
  };
  add(0, 1, 3, 2);
  add(8, 10, 11, 9);
  for (const std::uint32_t x : {0U, 4U}) {
    add(x, x + 4, x + 5, x + 1);
    add(x + 2, x + 3, x + 7, x + 6);
    add(x, x + 2, x + 6, x + 4);
    add(x + 1, x + 5, x + 7, x + 3);
  }
  if (with_wall) add(4, 6, 7, 5);
  return s;
}

/// Of an outward surface, rounded.
inline double enclosed(const Surface3& s) {
  long double sum = 0;
  for (const auto& [a, b, c] : s.facets) {
    const Point3& p = s.points[a];
    const Point3& q = s.points[b];
    const Point3& r = s.points[c];
    sum += static_cast<long double>(p[0]) * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
           p[2] * (q[0] * r[1] - q[1] * r[0]);
  }
  return static_cast<double>(sum / 6);
}

inline std::vector<NamedSurface<3>> boundary_solids() {
  std::vector<NamedSurface<3>> solids;
  const auto add = [&solids](const std::string& name, const Surface3& s, bool is_exact) {
    solids.push_back({name, s, enclosed(s), is_exact});
  };
  add("cube", box_surface({0, 0, 0}, {1, 1, 1}), true);
  add("grid cube", grid_cube(12), true);
  add("grid cube, diagonals at random", grid_cube(5, 1), true);
  Surface3 tetrahedron;
  tetrahedron.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.facets = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  add("tetrahedron", tetrahedron, false);
  add("schoenhardt", schoenhardt(), false);
  for (const int degrees : {1, 5, 10, 20, 30, 45, 60}) {
    add("wedge of " + std::to_string(degrees), wedge(degrees), false);
  }
  for (const int k : {4, 10}) {
    add("plate 1:" + std::to_string(k), box_surface({0, 0, 0}, {1.0 * k, 1.0 * k, 1}), true);
  }
  for (const int k : {3, 5, 7}) {
    Surface3 skew = box_surface({0, 0, 0}, {1.0 * k, 1.0 * k + 1, 1});
    for (Point3& p : skew.points) p = {p[0] + 0.3 * p[2], p[1] - 0.2 * p[0], p[2] + 0.1 * p[1] + 0.2 * p[0]};
    add("skew plate 1:" + std::to_string(k), skew, false);
  }
  add("L",
      prism({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, 1),
      true);
  add("nested cubes", join(box_surface({0, 0, 0}, {3, 3, 3}), reversed(box_surface({1, 1, 1}, {2, 2, 2}))),
      true);
  solids.push_back({"two boxes", two_boxes(true), 2, true});
  for (const std::uint64_t seed : {1, 2, 3}) {
    add("star polyhedron " + std::to_string(seed), star_polyhedron(seed), false);
  }
  return solids;
}

inline void add_polygon(Surface2& s, const std::vector<Point2>& polygon) {
  const auto first = static_cast<std::uint32_t>(s.points.size());
  const auto n = static_cast<std::uint32_t>(polygon.size());
  s.points.insert(s.points.end(), polygon.begin(), polygon.end());
  for (std::uint32_t i = 0; i < n; ++i) s.facets.push_back({first + i, first + (i + 1) % n});
}

inline double enclosed(const std::vector<Point2>& polygon) {
  long double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& p = polygon[i];
    const Point2& q = polygon[(i + 1) % polygon.size()];
    sum += static_cast<long double>(p[0]) * q[1] - static_cast<long double>(p[1]) * q[0];
  }
  return static_cast<double>(sum / 2);
}

/// Spikes of this angle around a circle.
inline std::vector<Point2> spiked_star(int spikes, double degrees) {
  std::vector<Point2> polygon;
  for (int i = 0; i < spikes; ++i) {
    const double turn = 2 * std::numbers::pi * i / spikes;
    const double half = degrees * std::numbers::pi / 360;
    // The spike with its tip at distance 3; its base lies on the unit circle.
    const double base = std::asin(3 * std::sin(half)) - half;
    polygon.push_back({3 * std::cos(turn), 3 * std::sin(turn)});
    polygon.push_back({std::cos(turn + base), std::sin(turn + base)});
    polygon.push_back({std::cos(turn + 2 * std::numbers::pi / spikes - base),
                       std::sin(turn + 2 * std::numbers::pi / spikes - base)});
  }
  return polygon;
}

inline std::vector<Point2> comb(int teeth) {
  std::vector<Point2> polygon = {{0, 0}, {2.0 * teeth - 1, 0}};
  for (int i = teeth - 1; i >= 0; --i) {
    polygon.push_back({2.0 * i + 1, 5});
    polygon.push_back({2.0 * i, 5});
    if (i > 0) {
      polygon.push_back({2.0 * i, 1});
      polygon.push_back({2.0 * i - 1, 1});
    }
  }
  return polygon;
}

inline std::vector<NamedSurface<2>> boundary_plans() {
  std::vector<NamedSurface<2>> plans;
  const auto add = [&plans](const std::string& name, const std::vector<std::vector<Point2>>& polygons,
                            bool is_exact) {
    NamedSurface<2> plan{name, {}, 0, is_exact};
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      add_polygon(plan.surface, polygons[i]);
      plan.measure += (i % 2 == 0 ? 1 : -1) * enclosed(polygons[i]);
    }
    plans.push_back(plan);
  };
  add("triangle", {{{0, 0}, {1, 0}, {0, 1}}}, false);
  add("needle", {{{0, 0}, {1, 0}, {1, 0.01}}}, false);
  add("rectangle", {{{0, 0}, {20, 0}, {20, 1}, {0, 1}}}, true);
  add("comb", {comb(6)}, true);
  add("L", {{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}}, true);
  for (const int degrees : {1, 5, 20, 35}) {
    add("star of " + std::to_string(degrees), {spiked_star(degrees > 20 ? 3 : 7, degrees)}, false);
  }
  add("nested squares",
      {{{0, 0}, {10, 0}, {10, 10}, {0, 10}},
       {{1, 1}, {9, 1}, {9, 9}, {1, 9}},
       {{4, 4}, {6, 4}, {6, 6}, {4, 6}}},
      true);
  for (const std::uint64_t seed : {1, 2, 3}) {
    Random random(seed);
    std::vector<Point2> polygon;
    for (int i = 0; i < 25; ++i) {
      const double radius = uniform(random, 0.3, 1);
      polygon.push_back(
          {radius * std::cos(2 * std::numbers::pi * i / 25), radius * std::sin(2 * std::numbers::pi * i / 25)});
    }
    add("random polygon " + std::to_string(seed), {polygon}, false);
  }
  // A square cut in two regions, with a free segment in one of them, and one that ends at a corner at a small
  // angle.
  NamedSurface<2> cut{"cut square", {}, 100, false};
  add_polygon(cut.surface, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  cut.surface.points.insert(cut.surface.points.end(), {{7, 2}, {8, 4}, {9, 0.5}});
  cut.surface.facets.insert(cut.surface.facets.end(), {{0, 2}, {4, 5}, {0, 6}});
  plans.push_back(cut);
  return plans;
}

template <int Dim>
std::vector<NamedSurface<Dim>> boundary_surfaces() {
  if constexpr (Dim == 2) {
    return boundary_plans();
  } else {
    return boundary_solids();
  }
}

}  // namespace sinkmesh::test
