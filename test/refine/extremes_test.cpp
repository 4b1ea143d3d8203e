// SPDX-License-Identifier: MIT
//
// Where pi and phi have their local minima and maxima [EG01, 3.2].
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/star.h"
#include "refine/flow.h"
#include "test/support/dimensions.h"
#include "test/support/distance_oracle.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class T>
class ExtremesTest : public testing::Test {};
TYPED_TEST_SUITE(ExtremesTest, PlaneAndSpace, DimensionName);

// [EG01, 3.2] The local maxima of pi are the sinks. Let z be the center of a simplex, and C its cell: the
// simplices around it with the same center. The vertices at distance r from z are the corners of C, and pi near
// z is |z-p|^2 for the nearest of them. If z is in the interior of conv C, every step away from z gets nearer
// to a corner; if not, a step along the outer normal of a facet of C that z does not lie strictly inside of
// gets nearer to none. In general position C is one simplex: a sink, or not. In a degenerate set the flow from
// a simplex of C can leave C only across a facet that z is not strictly inside of, so if z is in the interior,
// one simplex of C is a sink.
TYPED_TEST(ExtremesTest, LocalMaximaOfPiAreTheSinks) {
  constexpr int kDim = TypeParam::value;
  std::size_t maxima = 0;
  std::size_t others = 0;
  Random random(9);
  for (const PointSet<kDim>& set : distance_test_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    const Complex<kDim>& complex = triangulation.complex();
    const Oracle<kDim> oracle(set.points, triangulation);
    Flow<kDim> flow(triangulation);
    std::map<RationalPoint<kDim>, std::vector<Simplex>> cells;
    for (const auto& [s, sphere] : oracle.spheres()) cells[sphere.center].push_back(s);
    for (const auto& [center, cell] : cells) {
      const RationalPoint<kDim>& z = center;
      // Where z lies with respect to the facets that bound the cell.
      RationalPoint<kDim> uphill{};
      bool is_interior = true;
      bool is_outside = false;
      for (const HalfFacet h : boundary<kDim>(complex, cell)) {
        const auto i = static_cast<std::size_t>(Complex<kDim>::corner_of(h));
        const auto corners = oracle.corners(Complex<kDim>::simplex_of(h));
        const Rational side = barycentric<kDim>(corners, z)[i];
        if (side > 0) continue;
        is_interior = false;
        is_outside = is_outside || side < 0;
        // The outer normal: the barycentric coordinate falls along it.
        for (std::size_t k = 0; k < kDim; ++k) {
          RationalPoint<kDim> moved = z;
          moved[k] += 1;
          uphill[k] = side - barycentric<kDim>(corners, moved)[i];
        }
      }
      const bool has_sink = std::any_of(cell.begin(), cell.end(), [&](Simplex s) { return flow.is_sink(s); });
      if (is_interior) {
        ASSERT_TRUE(has_sink);
      }
      if (is_outside) {
        ASSERT_FALSE(has_sink);
      }

      // The same from pi alone, next to z.
      const Rational here = oracle.pi(z);
      ASSERT_EQ(here, oracle.sphere(cell[0]).radius2);
      if (is_interior) {
        ++maxima;
        for (int trial = 0; trial < 3; ++trial) {
          ASSERT_LT(oracle.pi(beside<kDim>(z, some_direction<kDim>(random))), here);
        }
      } else {
        ++others;
        ASSERT_GT(oracle.pi(beside<kDim>(z, uphill)), here);
      }
    }
  }
  EXPECT_GT(maxima, 100U);
  EXPECT_GT(others, 100U);
}

// [EG01, 3.2] The minima of phi are the centers that lie in their simplices, its maxima the vertices. Elsewhere
// the gradient leads down, as shown above, and phi is strictly convex along the face that holds y, so that it
// rises one way or the other.
TYPED_TEST(ExtremesTest, LocalExtremesOfPhiAreSinksAndVertices) {
  constexpr int kDim = TypeParam::value;
  std::size_t minima = 0;
  std::size_t maxima = 0;
  std::size_t others = 0;
  Random random(10);
  for (const PointSet<kDim>& set : distance_test_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    const Complex<kDim>& complex = triangulation.complex();
    const Oracle<kDim> oracle(set.points, triangulation);
    for (const auto& [s, sphere] : oracle.spheres()) {
      const auto weights = barycentric<kDim>(oracle.corners(s), sphere.center);
      if (!std::all_of(weights.begin(), weights.end(), [](const Rational& w) { return w > 0; })) continue;
      ++minima;
      ASSERT_EQ(oracle.phi(sphere.center), -sphere.radius2);
      for (int trial = 0; trial < 3; ++trial) {
        ASSERT_GT(oracle.phi(beside<kDim>(sphere.center, some_direction<kDim>(random))), -sphere.radius2);
      }
    }
    for (std::uint32_t v = 0; v < set.points.size(); ++v) {
      const std::vector<Simplex> around = star(complex, Vertex(v));
      if (std::any_of(around.begin(), around.end(), [&](Simplex s) { return complex.is_ghost(s); })) continue;
      ++maxima;
      const auto p = rational<kDim>(set.points[v]);
      for (int trial = 0; trial < 3; ++trial) {
        ASSERT_LT(oracle.phi(beside<kDim>(p, some_direction<kDim>(random))), 0);
      }
    }
    for (const Point<kDim>& sample : samples<kDim>(set.points, 20, 4)) {
      const auto y = rational<kDim>(sample);
      for (const auto& [s, sphere] : oracle.spheres()) {
        if (!oracle.holds(s, y)) continue;
        // Two corners of the face that holds y, if it is no vertex.
        std::vector<RationalPoint<kDim>> face;
        const auto weights = barycentric<kDim>(oracle.corners(s), y);
        for (std::size_t i = 0; i <= kDim; ++i) {
          if (weights[i] != 0) face.push_back(oracle.corners(s)[i]);
        }
        if (face.size() < 2) break;
        RationalPoint<kDim> along;
        RationalPoint<kDim> back;
        for (std::size_t k = 0; k < kDim; ++k) {
          along[k] = face[1][k] - face[0][k];
          back[k] = -along[k];
        }
        ++others;
        const Rational here = oracle.phi(y);
        ASSERT_TRUE(oracle.phi(beside<kDim>(y, along)) > here || oracle.phi(beside<kDim>(y, back)) > here);
        break;
      }
    }
  }
  EXPECT_GT(minima, 80U);
  EXPECT_GT(maxima, 100U);
  EXPECT_GT(others, 100U);
}

}  // namespace
}  // namespace sinkmesh
