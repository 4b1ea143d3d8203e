// SPDX-License-Identifier: MIT
//
// Minimum separation and packing [EG01, 4.4]: why every schedule ends, seen in its result.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "refine/domain.h"
#include "refine/independence.h"
#include "refine/refiner.h"
#include "test/support/dimensions.h"
#include "test/support/point_sets.h"
#include "test/support/rational_geometry.h"
#include "test/support/surfaces.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class T>
class SeparationTest : public testing::Test {};
TYPED_TEST_SUITE(SeparationTest, PlaneAndSpace, DimensionName);

/// Closed surfaces whose facets are Delaunay, with boundaries that leave low quality inside: thin, wavy, with a
/// hole; and one of a grid, where everything ties.
template <int Dim>
std::vector<Surface<Dim>> surfaces();

Surface2 polygon(const std::vector<Point2>& points) {
  Surface2 surface{points, {}};
  const auto n = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i < n; ++i) surface.facets.push_back({i, (i + 1) % n});
  return surface;
}

template <>
std::vector<Surface2> surfaces<2>() {
  std::vector<Surface2> result;
  Random random(1);
  const auto curve = [&](std::size_t n, double waves, double height) {
    std::vector<Point2> points;
    for (std::size_t i = 0; i < n; ++i) {
      const double angle =
          2 * std::numbers::pi * (static_cast<double>(i) + uniform(random, 0, 0.6)) / static_cast<double>(n);
      const double radius = 1 + 0.2 * std::sin(waves * angle);
      points.push_back({radius * std::cos(angle), height * radius * std::sin(angle)});
    }
    return polygon(points);
  };
  result.push_back(curve(60, 0, 0.3));
  result.push_back(curve(150, 5, 1));
  Surface2 square = polygon(square_outline());
  result.push_back(square);
  // A ring: parity makes the hole.
  Surface2 ring = curve(80, 0, 1);
  Surface2 hole = curve(60, 0, 1);
  for (Point2& p : hole.points) {
    for (double& x : p) x *= 0.4;
  }
  for (auto& [a, b] : hole.facets) ring.facets.push_back({a + 80, b + 80});
  ring.points.insert(ring.points.end(), hole.points.begin(), hole.points.end());
  result.push_back(ring);
  return result;
}

template <>
std::vector<Surface3> surfaces<3>() {
  return {ellipsoid_surface(2, {1, 0.9, 0.8}, 1e-2), ellipsoid_surface(3, {1, 0.9, 0.35}, 5e-3),
          ellipsoid_surface(2, {1, 1, 1}),
          join(ellipsoid_surface(3, {1, 1.1, 0.9}, 1e-3), ellipsoid_surface(2, {0.5, 0.45, 0.4}, 1e-3))};
}

/// An upper bound on the volume of the h-neighbourhood of the domain: a point outside at most h away has its
/// nearest point in the interior of a facet, hence is in a prism of height h over it; in an edge (space), hence
/// in a cylinder around it; or at a vertex, in a ball.
template <int Dim>
double expanded_volume(const Triangulation<Dim>& triangulation, const Domain<Dim>& domain, double h) {
  constexpr double kPi = std::numbers::pi;
  double volume = 0;
  const Complex<Dim>& complex = triangulation.complex();
  const auto point = [&](Vertex v) { return triangulation.point(v); };
  const auto difference = [](const Point<Dim>& a, const Point<Dim>& b) {
    Point<Dim> d;
    for (std::size_t k = 0; k < Dim; ++k) d[k] = a[k] - b[k];
    return d;
  };
  const auto length = [](const Point<Dim>& d) {
    double sum = 0;
    for (const double x : d) sum += x * x;
    return std::sqrt(sum);
  };
  if constexpr (Dim == 2) {
    for (const Simplex s : domain.simplices()) {
      const Point2 u = difference(point(complex.corner(s, 1)), point(complex.corner(s, 0)));
      const Point2 v = difference(point(complex.corner(s, 2)), point(complex.corner(s, 0)));
      volume += (u[0] * v[1] - u[1] * v[0]) / 2;
    }
    for (const HalfFacet f : domain.boundary()) {
      const auto [a, b] = complex.facet(f);
      // Each corner of a closed polygon belongs to two edges.
      volume += length(difference(point(a), point(b))) * h + kPi * h * h;
    }
  } else {
    const auto cross = [](const Point3& u, const Point3& v) {
      return Point3{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    };
    for (const Simplex s : domain.simplices()) {
      std::array<Point3, 3> d;
      for (int i = 0; i < 3; ++i) {
        d[static_cast<std::size_t>(i)] =
            difference(point(complex.corner(s, i + 1)), point(complex.corner(s, 0)));
      }
      const Point3 n = cross(d[0], d[1]);
      volume += (n[0] * d[2][0] + n[1] * d[2][1] + n[2] * d[2][2]) / 6;
    }
    std::map<Vertex, int> vertices;
    for (const HalfFacet f : domain.boundary()) {
      const auto [a, b, c] = complex.facet(f);
      volume += length(cross(difference(point(b), point(a)), difference(point(c), point(a)))) / 2 * h;
      for (const auto& [v, w] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        ++vertices[v];
        volume += length(difference(point(v), point(w))) * kPi * h * h / 2;  // half: two facets have the edge
      }
    }
    volume += static_cast<double>(vertices.size()) * 4 * kPi / 3 * h * h * h;
  }
  return volume * (1 + 1e-9);
}

/// Of all pairs, exactly.
template <int Dim>
Rational shortest_distance2(std::vector<Point<Dim>> points) {
  std::sort(points.begin(), points.end());
  double nearly = HUGE_VAL;
  Rational shortest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      double square = 0;
      for (std::size_t k = 0; k < Dim; ++k)
        square += (points[j][k] - points[i][k]) * (points[j][k] - points[i][k]);
      if (square > nearly * (1 + 1e-12)) continue;
      const Rational exact = squared_distance(rational<Dim>(points[i]), rational<Dim>(points[j]));
      if (nearly == HUGE_VAL || exact < shortest) shortest = exact;
      nearly = std::min(nearly, square);
    }
  }
  return shortest;
}

TYPED_TEST(SeparationTest, HoldsAfterEveryScheduleAndBoundsTheNumberOfVertices) {
  constexpr int kDim = TypeParam::value;
  std::size_t inserted = 0;
  for (const Surface<kDim>& surface : surfaces<kDim>()) {
    const Rational delta2 = shortest_distance2<kDim>(surface.points);
    for (const Insert insert : {Insert::off_sink, Insert::sink, Insert::circumcenter}) {
      for (const Schedule schedule : {Schedule::incremental, Schedule::block, Schedule::parallel}) {
        for (const double ratio : {1.0, 1.3}) {
          SCOPED_TRACE(testing::Message()
                       << surface.points.size() << " points, insert " << static_cast<int>(insert)
                       << ", schedule " << static_cast<int>(schedule) << ", ratio " << ratio);
          Triangulation<kDim> triangulation(surface.points);
          Domain<kDim> domain(triangulation);
          Flow<kDim> flow(triangulation);
          std::vector<typename Domain<kDim>::Facet> facets(surface.facets.size());
          for (std::size_t f = 0; f < facets.size(); ++f) {
            for (std::size_t k = 0; k < kDim; ++k) facets[f][k] = Vertex(surface.facets[f][k]);
          }
          ASSERT_TRUE(domain.label_facets(facets).empty());
          domain.peel(flow);
          ASSERT_FALSE(domain.simplices().empty());
          const double delta = std::sqrt(delta2.get_d());
          const double bound =
              expanded_volume<kDim>(triangulation, domain, delta / 2) /
              (kDim == 2 ? std::numbers::pi / 4 * delta * delta : std::numbers::pi / 6 * delta * delta * delta);

          RefineOptions options;
          options.insert = insert;
          options.schedule = schedule;
          options.max_ratio = ratio;
          options.fallback = ratio == 1.0 ? Fallback::none : Fallback::circumcenter;
          // Were separation lost, the run would not end by itself.
          options.max_vertices = static_cast<std::size_t>(bound) + 1;
          const RefineResult result = Refiner<kDim>(triangulation, domain, flow, options).run();
          ASSERT_EQ(result.stop, Stop::no_candidate);
          inserted += result.inserted;
          std::vector<Point<kDim>> points;
          for (std::uint32_t v = 0; v < triangulation.complex().num_vertices(); ++v) {
            points.push_back(triangulation.point(Vertex(v)));
          }
          ASSERT_EQ(points.size(), surface.points.size() + result.inserted);
          // delta is fixed once, from below: its square is wrong by at most 2^-50.
          const Rational kept = shortest_distance2<kDim>(points) / delta2;
          ASSERT_GE(kept.get_d(), 1 - 0x1p-49);
          ASSERT_LE(static_cast<double>(points.size()), bound);
          ASSERT_TRUE(triangulation.validate().ok());
        }
      }
    }
  }
  EXPECT_GT(inserted, 2000U);
}

// [EG01, 4.4] The center of a Delaunay simplex with r/l > 1 is further than l, hence than delta, from all
// vertices; and spheres that are orthogonal or further have centers at least the larger radius apart.
TYPED_TEST(SeparationTest, OrthogonalSpheresHaveCentersTheLargerRadiusApart) {
  constexpr int kDim = TypeParam::value;
  std::size_t further = 0;
  std::size_t orthogonal = 0;
  std::size_t closer = 0;
  Random random(8);
  std::vector<PointSet<kDim>> sets = point_sets<kDim>(40, 13);
  // Centers of unit cubes and squares at (1,1,0) of each other: orthogonal spheres of radius^2 3/4 and 1/2 need
  // distance^2 3/2 and 1; cuboids of sides 2, 2, 1 and the like give more.
  sets.push_back({"grid", grid_points<kDim>(kDim == 2 ? 7 : 4)});
  for (const PointSet<kDim>& set : sets) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    const Complex<kDim>& complex = triangulation.complex();
    const std::vector<Simplex> solid = solid_simplices(complex);
    std::vector<RationalSphere<kDim>> spheres;
    for (const Simplex s : solid) spheres.push_back(circumsphere<kDim>(complex, s));
    for (int trial = 0; trial < 300; ++trial) {
      const std::size_t i = random() % solid.size();
      const std::size_t j = random() % solid.size();
      const Rational distance2 = squared_distance(spheres[i].center, spheres[j].center);
      const int side = sgn(Rational(distance2 - spheres[i].radius2 - spheres[j].radius2));
      ASSERT_EQ(are_orthogonal_or_further(triangulation, solid[i], solid[j]), side >= 0);
      further += side > 0 ? 1 : 0;
      orthogonal += side == 0 ? 1 : 0;
      closer += side < 0 ? 1 : 0;
      if (side >= 0) {
        ASSERT_GE(distance2, std::max(spheres[i].radius2, spheres[j].radius2));
      }
    }
  }
  EXPECT_GT(further, 100U);
  EXPECT_GT(closer, 100U);
  EXPECT_GT(orthogonal, 10U);
}

}  // namespace
}  // namespace sinkmesh
