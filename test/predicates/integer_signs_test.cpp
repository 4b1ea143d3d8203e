// SPDX-License-Identifier: MIT
//
// The fast oracle of the stress tests against the slow one.
#include "test/support/integer_signs.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "test/support/clouds.h"
#include "test/support/polynomial_oracle.h"

namespace sinkmesh {
namespace {

using namespace detail;
using namespace test;

template <class P>
class IntegerSignsTest : public ::testing::Test {};
using Polynomials = ::testing::Types<Orientation<2>, Orientation<3>, InSphere<2>, InSphere<3>, Diametral<2>,
                                     Diametral<3>, Orthogonality<2>, Orthogonality<3>>;
TYPED_TEST_SUITE(IntegerSignsTest, Polynomials);

TYPED_TEST(IntegerSignsTest, AreThoseOfTheSlowOracle) {
  using P = TypeParam;
  Random random(21);
  std::array<int, 3> met{};
  const auto expect_same = [&](const std::vector<Point<P::kDim>>& points) {
    const int sign = in_domain<P>(points) ? exact_value<P>(points).sign : 0;
    ASSERT_EQ(integer_sign<P>(pointers<P>(points)), sign);
    ++met[static_cast<std::size_t>(sign + 1)];
  };
  for (const Cloud kind : kAllClouds) {
    for (int sample = 0; sample < 200; ++sample) expect_same(make_cloud<P::kDim>(kind, P::kPoints, random));
  }
  for (int sample = 0; sample < 300; ++sample) {
    expect_same(make_wide_cloud<P::kDim>(-82, 124, P::kPoints, random));
  }
  for (const int times : met) EXPECT_GE(times, 200);
}

// No oracle for these: the normals of the unit simplex, of a flatter one, and of one with an obtuse angle.
TEST(IntegerSigns, OfFacetNormalsAreThoseOfTheirAngles) {
  const auto space = [](const std::vector<Point3>& p) {
    return integer_sign<FacetNormals<3>>(pointers<FacetNormals<3>>(p));
  };
  EXPECT_EQ(space({{0, 0, 1}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}}), 0);    // a right angle at the edge 1 2
  EXPECT_EQ(space({{1, 0, 1}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}}), -1);   // an acute one
  EXPECT_EQ(space({{-1, 0, 1}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}}), 1);   // an obtuse one
  EXPECT_EQ(space({{-1, 0, 1}, {0, 0, 0}, {0, -1, 0}, {1, 0, 0}}), 1);  // mirrored
  const auto plane = [](const std::vector<Point2>& p) {
    return integer_sign<FacetNormals<2>>(pointers<FacetNormals<2>>(p));
  };
  EXPECT_EQ(plane({{0, 1}, {0, 0}, {1, 0}}), 0);
  EXPECT_EQ(plane({{1, 1}, {0, 0}, {1, 0}}), -1);
  EXPECT_EQ(plane({{-1, 1}, {0, 0}, {1, 0}}), 1);
}

}  // namespace
}  // namespace sinkmesh
