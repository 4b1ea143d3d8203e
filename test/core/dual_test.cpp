// SPDX-License-Identifier: MIT
//
// The Voronoi diagram against its definition: points nearest to given vertices, in rationals [EG01, 2.2, 2.3].
#include "core/dual.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "test/support/dimensions.h"
#include "test/support/point_sets.h"
#include "test/support/rational_geometry.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class T>
class DualTest : public testing::Test {};
TYPED_TEST_SUITE(DualTest, PlaneAndSpace, DimensionName);

template <int Dim>
std::vector<PointSet<Dim>> small_sets() {
  std::vector<PointSet<Dim>> sets = point_sets<Dim>(30, 21);
  sets.push_back({"grid", grid_points<Dim>(Dim == 2 ? 6 : 3)});
  sets.push_back({"large", uniform_points<Dim>(60, 3)});
  for (auto& p : sets.back().points) {
    for (double& x : p) x = 3e6 * x - 1e6;
  }
  return sets;
}

/// In the units of the input, whatever the gate did.
template <int Dim>
std::array<RationalPoint<Dim>, Dim + 1> input_corners(const Triangulation<Dim>& triangulation, Simplex s) {
  std::array<RationalPoint<Dim>, Dim + 1> corners;
  for (int i = 0; i <= Dim; ++i) {
    corners[static_cast<std::size_t>(i)] =
        rational<Dim>(triangulation.point(triangulation.complex().corner(s, i)));
  }
  return corners;
}
template <int Dim>
RationalPoint<Dim> center(const Triangulation<Dim>& triangulation, Simplex s) {
  return orthosphere<Dim>(input_corners(triangulation, s)).center;
}

/// The exact outer normal of a facet: minus the gradient of the barycentric coordinate of its apex.
template <int Dim>
RationalPoint<Dim> outer_normal(const Triangulation<Dim>& triangulation, HalfFacet h) {
  const auto corners = input_corners(triangulation, Complex<Dim>::simplex_of(h));
  const auto i = static_cast<std::size_t>(Complex<Dim>::corner_of(h));
  RationalPoint<Dim> normal;
  for (std::size_t k = 0; k < Dim; ++k) {
    RationalPoint<Dim> moved = corners[i];
    moved[k] += 1;
    normal[k] = 1 - barycentric<Dim>(corners, moved)[i];
  }
  return normal;
}

/// The vertices nearest to x.
template <int Dim>
std::set<std::uint32_t> nearest(const std::vector<RationalPoint<Dim>>& points, const RationalPoint<Dim>& x) {
  std::set<std::uint32_t> result;
  Rational smallest;
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    const Rational d = squared_distance(points[v], x);
    if (result.empty() || d < smallest) {
      result.clear();
      smallest = d;
    }
    if (d == smallest) result.insert(v);
  }
  return result;
}

TYPED_TEST(DualTest, VertexIsTheCircumcenter) {
  constexpr int kDim = TypeParam::value;
  std::size_t far = 0;
  for (const PointSet<kDim>& set : small_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    const double unit = std::ldexp(1.0, -triangulation.gate().exponent());
    for (const Simplex s : solid_simplices(triangulation.complex())) {
      const auto exact = center(triangulation, s);
      const Point<kDim> z = dual_vertex(triangulation, s);
      bool is_far = false;
      for (std::size_t k = 0; k < kDim; ++k) is_far |= abs(exact[k]) > 2 * unit;
      far += is_far ? 1 : 0;
      for (std::size_t k = 0; k < kDim; ++k) {
        const Rational error = Rational(z[k]) - exact[k];
        ASSERT_LE(std::abs(error.get_d()),
                  (is_far ? 0x1p-52 : 0x1p-53) * std::abs(exact[k].get_d()) + unit * 0x1p-122);
      }
    }
  }
  EXPECT_GT(far, 20U);
}

TYPED_TEST(DualTest, EdgeJoinsTheCentersAndIsNearestToTheVerticesOfItsFacet) {
  constexpr int kDim = TypeParam::value;
  std::size_t rays = 0;
  std::size_t segments = 0;
  for (const PointSet<kDim>& set : small_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    const Complex<kDim>& complex = triangulation.complex();
    std::vector<RationalPoint<kDim>> points;
    for (const Point<kDim>& p : set.points) points.push_back(rational<kDim>(p));
    for (const Simplex s : solid_simplices(complex)) {
      for (int i = 0; i <= kDim; ++i) {
        const HalfFacet h = Complex<kDim>::half_facet(s, i);
        const DualEdge<kDim> edge = dual_edge(triangulation, h);
        ASSERT_EQ(edge.from, s);
        ASSERT_EQ(edge.to, complex.neighbor(s, i));
        ASSERT_EQ(edge.start, dual_vertex(triangulation, s));
        ASSERT_EQ(edge.is_ray, complex.is_ghost(edge.to));
        // A point of the edge, exactly.
        RationalPoint<kDim> on_edge = center(triangulation, s);
        if (edge.is_ray) {
          ++rays;
          const auto normal = outer_normal(triangulation, h);
          // The same direction: one positive factor for all coordinates.
          Rational factor = 0;
          for (std::size_t k = 0; k < kDim; ++k) {
            ASSERT_EQ(edge.direction[k] == 0, normal[k] == 0);
            if (normal[k] == 0) continue;
            const Rational ratio = Rational(edge.direction[k]) / normal[k];
            ASSERT_GT(ratio, 0);
            if (factor == 0) factor = ratio;
            const Rational relative = ratio / factor;
            ASSERT_NEAR(relative.get_d(), 1, 0x1p-51);
            on_edge[k] += normal[k];
          }
          const DualEdge<kDim> same = dual_edge(triangulation, complex.mate(h));
          ASSERT_TRUE(same.is_ray && same.from == edge.from && same.direction == edge.direction);
        } else {
          ++segments;
          ASSERT_EQ(edge.end, dual_vertex(triangulation, edge.to));
          ASSERT_EQ(edge.direction, Point<kDim>{});
          const DualEdge<kDim> back = dual_edge(triangulation, complex.mate(h));
          ASSERT_TRUE(back.start == edge.end && back.end == edge.start);
          const auto other = center(triangulation, edge.to);
          for (std::size_t k = 0; k < kDim; ++k) on_edge[k] = (2 * on_edge[k] + other[k]) / 3;
        }
        const std::set<std::uint32_t> near = nearest<kDim>(points, on_edge);
        for (const Vertex v : complex.facet(h)) ASSERT_TRUE(near.contains(v.index()));
        // On an edge of positive length only these, unless more of them lie on one circle in the facet's plane.
        if (set.name == "uniform") {
          ASSERT_EQ(near.size(), static_cast<std::size_t>(kDim));
        }
      }
    }
  }
  EXPECT_GT(rays, 100U);
  EXPECT_GT(segments, 300U);
}

TYPED_TEST(DualTest, PolygonOfARidgeIsConvexPlanarAndComplete) {
  constexpr int kDim = TypeParam::value;
  std::size_t bounded = 0;
  std::size_t unbounded = 0;
  for (const PointSet<kDim>& set : small_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    const Complex<kDim>& complex = triangulation.complex();
    for (const Simplex s : solid_simplices(complex)) {
      for (int i = 0; i <= kDim; ++i) {
        for (int j = 0; j <= kDim; ++j) {
          if (i == j) continue;
          std::vector<Vertex> ridge;
          for (int k = 0; k <= kDim; ++k) {
            if (k != i && k != j) ridge.push_back(complex.corner(s, k));
          }
          const std::vector<Simplex> around = simplices_around(complex, Ridge{s, i, j});
          ASSERT_EQ(around.front(), s);
          ASSERT_EQ(around[1], complex.neighbor(s, i));
          ASSERT_EQ(around.back(), complex.neighbor(s, j));
          // All of the star of the ridge, each once, each beside the next.
          std::vector<Simplex> sorted = around;
          std::sort(sorted.begin(), sorted.end());
          std::vector<Simplex> expected;
          for (const Simplex t : complex.simplices()) {
            if (std::all_of(ridge.begin(), ridge.end(),
                            [&](Vertex v) { return complex.index_of(t, v) >= 0; })) {
              expected.push_back(t);
            }
          }
          ASSERT_EQ(sorted, expected);
          std::vector<Simplex> same = star<kDim>(complex, ridge, s);
          std::sort(same.begin(), same.end());
          ASSERT_EQ(same, expected);
          bool has_ghost = false;
          for (std::size_t n = 0; n < around.size(); ++n) {
            const Simplex next = around[(n + 1) % around.size()];
            bool is_neighbor = false;
            for (int k = 0; k <= kDim; ++k) is_neighbor |= complex.neighbor(around[n], k) == next;
            ASSERT_TRUE(is_neighbor);
            has_ghost |= complex.is_ghost(around[n]);
          }
          ++(has_ghost ? unbounded : bounded);
          if (has_ghost || i > j) continue;
          // Turns one way only, as seen along the ridge (in the plane: as it is), and lies orthogonal to it.
          std::vector<RationalPoint<kDim>> z;
          for (const Simplex t : around) z.push_back(center(triangulation, t));
          RationalPoint<kDim> axis{};
          if constexpr (kDim == 3) {
            const auto a = rational<3>(triangulation.point(ridge[0]));
            const auto b = rational<3>(triangulation.point(ridge[1]));
            for (std::size_t k = 0; k < 3; ++k) axis[k] = b[k] - a[k];
          }
          int turn = 0;
          for (std::size_t n = 0; n < z.size(); ++n) {
            std::array<RationalPoint<kDim>, 2> d;
            for (std::size_t k = 0; k < kDim; ++k) {
              d[0][k] = z[(n + 1) % z.size()][k] - z[n][k];
              d[1][k] = z[(n + 2) % z.size()][k] - z[(n + 1) % z.size()][k];
            }
            Rational side;
            if constexpr (kDim == 2) {
              side = d[0][0] * d[1][1] - d[0][1] * d[1][0];
            } else {
              ASSERT_EQ(Rational(d[0][0] * axis[0] + d[0][1] * axis[1] + d[0][2] * axis[2]), 0);
              side = axis[0] * (d[0][1] * d[1][2] - d[0][2] * d[1][1]) +
                     axis[1] * (d[0][2] * d[1][0] - d[0][0] * d[1][2]) +
                     axis[2] * (d[0][0] * d[1][1] - d[0][1] * d[1][0]);
            }
            if (side == 0) continue;
            if (turn == 0) turn = sgn(side);
            ASSERT_EQ(sgn(side), turn);
          }
        }
      }
    }
  }
  EXPECT_GT(bounded, 100U);
  EXPECT_GT(unbounded, 100U);
}

TYPED_TEST(DualTest, StarOfAVertexIsAllSimplicesThatHaveIt) {
  constexpr int kDim = TypeParam::value;
  for (const PointSet<kDim>& set : small_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    const Complex<kDim>& complex = triangulation.complex();
    for (std::uint32_t slot = 0; slot <= set.points.size(); ++slot) {
      const Vertex v = Vertex::at_slot(slot);
      std::vector<Simplex> expected;
      for (const Simplex s : complex.simplices()) {
        if (complex.index_of(s, v) >= 0) expected.push_back(s);
      }
      std::vector<Simplex> found = star(complex, v);
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected) << v;
    }
  }
}

// By hand: the triangle (0,0), (4,0), (0,2) has its center at (2,1), on the hypotenuse.
TEST(Dual, OfOneTriangle) {
  const Triangulation2 triangulation(std::vector<Point2>{{0, 0}, {4, 0}, {0, 2}});
  const Simplex s = solid_simplices(triangulation.complex())[0];
  EXPECT_EQ(dual_vertex(triangulation, s), (Point2{2, 1}));
  std::set<Point2> directions;
  for (int i = 0; i < 3; ++i) {
    const DualEdge<2> ray = dual_edge(triangulation, Complex<2>::half_facet(s, i));
    EXPECT_TRUE(ray.is_ray);
    EXPECT_EQ(ray.start, (Point2{2, 1}));
    const double scale = std::max(std::abs(ray.direction[0]), std::abs(ray.direction[1]));
    directions.insert({ray.direction[0] / scale, ray.direction[1] / scale});
  }
  EXPECT_EQ(directions, (std::set<Point2>{{0, -1}, {-1, 0}, {0.5, 1}}));
}

}  // namespace
}  // namespace sinkmesh
