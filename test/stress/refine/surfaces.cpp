// SPDX-License-Identifier: MIT
#include "test/stress/refine/surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "refine/refine.h"
#include "refine/surface_check.h"
#include "test/stress/positions/positions.h"
#include "test/stress/positions/similarity.h"
#include "test/stress/refine/surface_case.h"
#include "test/support/boundary_surfaces.h"
#include "test/support/point_sets.h"

namespace sinkmesh::stress {
namespace {

using test::uniform;
using test::uniform_int;

double turn(double i, double n) { return 2 * std::numbers::pi * i / n; }

/// Sides of very different lengths, or of small integers.
template <int Dim>
Point<Dim> random_sides(Random& random) {
  Point<Dim> sides;
  const bool integers = random() % 2 == 0;
  for (double& x : sides) x = integers ? uniform_int(random, 1, 5) : std::exp2(uniform(random, -2, 2));
  return sides;
}

template <int Dim>
void stretch(Surface<Dim>& s, const Point<Dim>& factors) {
  for (auto& p : s.points) {
    for (std::size_t k = 0; k < Dim; ++k) p[k] *= factors[k];
  }
}

template <int Dim>
void shake(Surface<Dim>& s, double size, Random& random) {
  for (auto& p : s.points) {
    for (double& x : p) x += uniform(random, -size, size);
  }
}

/// Only what facets use. Throws DegenerateInput if the points do not span the space.
template <int Dim>
Surface<Dim> hull_of(const std::vector<Point<Dim>>& points) {
  const Mesh<Dim> hull = hull_mesh(Triangulation<Dim>(points));
  Surface<Dim> s;
  std::map<std::uint32_t, std::uint32_t> ids;
  for (auto facet : hull.boundary) {
    for (std::uint32_t& id : facet) {
      const auto [known, is_new] = ids.try_emplace(id, static_cast<std::uint32_t>(s.points.size()));
      if (is_new) s.points.push_back(hull.points[id]);
      id = known->second;
    }
    s.facets.push_back(facet);
  }
  return s;
}

template <int Dim>
Surface<Dim> random_hull(Random& random) {
  const auto n = static_cast<std::size_t>(uniform_int(random, Dim + 1, Dim == 2 ? 20 : 16));
  std::vector<Point<Dim>> points;
  switch (random() % 4) {
    case 0:
      for (std::size_t i = 0; i < n; ++i) {
        for (double& x : points.emplace_back()) x = uniform_int(random, 0, 3);
      }
      break;
    case 1:
      for (std::size_t i = 0; i < n; ++i) points.push_back(test::integer_sphere_point<Dim>(random));
      break;
    default:
      points = test::uniform_points<Dim>(n, random());
  }
  return hull_of<Dim>(points);
}

/// A pyramid over a polygon; high ones are spires.
Surface3 pyramid(Random& random) {
  const int n = uniform_int(random, 3, 7);
  const double height = std::exp2(uniform(random, -2, 4));
  std::vector<Point3> points{{uniform(random, -0.5, 0.5), uniform(random, -0.5, 0.5), height}};
  for (int i = 0; i < n; ++i) points.push_back({std::cos(turn(i, n)), std::sin(turn(i, n)), 0});
  return hull_of<3>(points);
}

Surface3 noisy_tetrahedron(Random& random) {
  Surface3 s;
  s.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  s.facets = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (int level = uniform_int(random, 0, 2); level > 0; --level) {
    s = test::divided_in_four(s, [](const Point3& middle) { return middle; });
  }
  if (random() % 4 != 0) shake<3>(s, std::exp2(uniform(random, -12, -1.5)), random);
  return s;
}

/// A box in a box, or beside it, at a random distance.
Surface3 boxes(bool nested, Random& random) {
  const double gap = std::exp2(uniform(random, -4, 0));
  const Surface3 big = test::box_surface({0, 0, 0}, {3, 3, 3});
  if (nested) {
    return test::join(big, test::reversed(test::box_surface({gap, 1, 1}, {2, 2, 3 - gap})));
  }
  return test::join(big, test::box_surface({3 + gap, 0.5, 1}, {5, 2, uniform(random, 1.5, 3)}));
}

Surface3 draw_solid(Random& random) {
  Surface3 s;
  switch (random() % 13) {
    case 0:
      return test::box_surface({0, 0, 0}, random_sides<3>(random));
    case 1:
      s = test::wedge(std::exp2(uniform(random, 2.5, 6.5)));
      stretch<3>(s, {1, 1, std::exp2(uniform(random, -2, 1))});
      return s;
    case 2:
      return pyramid(random);
    case 3:
      return test::box_surface({0, 0, 0}, {1, uniform(random, 0.5, 1), std::exp2(uniform(random, -4, -1))});
    case 4:
      return boxes(true, random);
    case 5:
      return boxes(false, random);
    case 6:
      s = test::two_boxes(random() % 4 != 0);
      stretch<3>(s, random_sides<3>(random));
      return s;
    case 7:
    case 8:
      return random_hull<3>(random);
    case 9:
      return noisy_tetrahedron(random);
    case 10:
      return test::schoenhardt(uniform(random, 5, 50));
    case 11:
      s = test::grid_cube(uniform_int(random, 1, 3), random() % 2);
      if (random() % 2 == 0) shake<3>(s, std::exp2(uniform(random, -10, -3)), random);
      return s;
    default:
      s = test::ellipsoid_surface(uniform_int(random, 0, 2),
                                  {1, uniform(random, 0.5, 1), uniform(random, 0.3, 1)},
                                  uniform(random, 0, 0.2));
      if (random() % 2 == 0) {
        for (Point3& p : s.points) {
          const double radius = uniform(random, 0.6, 1);
          for (double& x : p) x *= radius;
        }
      }
      return s;
  }
}

/// A tour through random points, uncrossed by reversing parts of it.
std::vector<Point2> simple_polygon(Random& random) {
  auto p = test::uniform_points<2>(static_cast<std::size_t>(uniform_int(random, 4, 14)), random());
  const auto side = [](const Point2& a, const Point2& b, const Point2& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0;
  };
  const std::size_t n = p.size();
  for (bool crossed = true; crossed;) {
    crossed = false;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 2; j < n; ++j) {
        const Point2& q = p[(j + 1) % n];
        if (side(p[i], p[i + 1], p[j]) == side(p[i], p[i + 1], q) ||
            side(p[j], q, p[i]) == side(p[j], q, p[i + 1]))
          continue;
        if (i == (j + 1) % n) continue;
        std::reverse(p.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     p.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        crossed = true;
      }
    }
  }
  return p;
}

std::vector<Point2> round_polygon(int n, double low, double high, Random& random) {
  std::vector<Point2> polygon;
  for (int i = 0; i < n; ++i) {
    const double radius = uniform(random, low, high);
    polygon.push_back({radius * std::cos(turn(i, n)), radius * std::sin(turn(i, n))});
  }
  return polygon;
}

/// The hull of random points and some of the edges between them: regions, membranes, free segments.
Surface2 planar_graph(Random& random) {
  const auto n = static_cast<std::size_t>(uniform_int(random, 5, 16));
  std::vector<Point2> points;
  if (random() % 2 == 0) {
    points = test::uniform_points<2>(n, random());
  } else {
    std::set<Point2> met;
    for (std::size_t i = 0; i < n; ++i) {
      met.insert({double(uniform_int(random, 0, 5)), double(uniform_int(random, 0, 5))});
    }
    points.assign(met.begin(), met.end());
  }
  const Mesh2 mesh = hull_mesh(Triangulation<2>(points));
  std::set<std::array<std::uint32_t, 2>> edges;
  for (auto [a, b] : mesh.boundary) edges.insert({std::min(a, b), std::max(a, b)});
  const auto share = random() % 4;
  for (const auto& triangle : mesh.simplices) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
      if (random() % 4 < share) edges.insert({a, b});
    }
  }
  Surface2 s;
  std::map<std::uint32_t, std::uint32_t> ids;
  for (auto edge : edges) {
    for (std::uint32_t& id : edge) {
      const auto [known, is_new] = ids.try_emplace(id, static_cast<std::uint32_t>(s.points.size()));
      if (is_new) s.points.push_back(mesh.points[id]);
      id = known->second;
    }
    s.facets.push_back(edge);
  }
  return s;
}

Surface2 draw_plan(Random& random) {
  Surface2 s;
  std::vector<Point2> inner;
  const int n = uniform_int(random, 3, 20);
  switch (random() % 9) {
    case 0: {
      const Point2 sides = random_sides<2>(random);
      test::add_polygon(s, {{0, 0}, {sides[0], 0}, sides, {0, sides[1]}});
      break;
    }
    case 1:
      test::add_polygon(s, {{0, 0}, {1, 0}, {uniform(random, -1, 2), std::exp2(uniform(random, -7, 1))}});
      break;
    case 2:
      test::add_polygon(s, test::comb(uniform_int(random, 1, 6)));
      stretch<2>(s, random_sides<2>(random));
      break;
    case 3:
      test::add_polygon(s, test::spiked_star(uniform_int(random, 3, 7), std::exp2(uniform(random, 1, 5))));
      break;
    case 4:
      test::add_polygon(s, round_polygon(n, 0.3, 1, random));
      break;
    case 5:
      test::add_polygon(s, simple_polygon(random));
      break;
    case 6:
      // Rings: outward and inward.
      test::add_polygon(s, round_polygon(n, 1, 1, random));
      inner = round_polygon(uniform_int(random, 3, 20), 0.1, 0.45, random);
      std::reverse(inner.begin(), inner.end());
      test::add_polygon(s, inner);
      break;
    case 7:
      return random_hull<2>(random);
    default:
      return planar_graph(random);
  }
  return s;
}

template <int Dim>
void place_surface(Surface<Dim>& s, Random& random) {
  switch (random() % 5) {
    case 0: {
      std::array<double, 4> q;
      for (double& x : q) x = uniform_int(random, -3, 3);
      q[0] += q[0] == 0 ? 4 : 0;
      const Similarity<Dim> similarity(q);
      for (auto& p : s.points) p = similarity(p);
      break;
    }
    case 1: {
      const double factor = uniform(random, 0.1, 10);
      Point<Dim> shift;
      for (double& x : shift) x = uniform(random, -10, 10);
      for (auto& p : s.points) {
        for (std::size_t k = 0; k < Dim; ++k) p[k] = factor * p[k] + shift[k];
      }
      break;
    }
    case 2: {
      const double factor = std::ldexp(1.0, uniform_int(random, -60, 60));
      for (auto& p : s.points) {
        for (double& x : p) x *= factor;
      }
      break;
    }
    default:
      break;
  }
}

}  // namespace

template <int Dim>
Surface<Dim> random_surface(Random& random) {
  for (int trial = 0; trial < 30; ++trial) {
    Surface<Dim> s;
    try {
      if constexpr (Dim == 2) {
        s = draw_plan(random);
      } else {
        s = draw_solid(random);
      }
    } catch (const DegenerateInput&) {
      continue;
    }
    place_surface<Dim>(s, random);
    if (is_meshable(s)) return s;
  }
  return test::boundary_surfaces<Dim>().front().surface;
}

template Surface<2> random_surface<2>(Random&);
template Surface<3> random_surface<3>(Random&);

}  // namespace sinkmesh::stress
