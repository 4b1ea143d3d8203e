// SPDX-License-Identifier: MIT
#include "refine/sliver_cost.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "refine/angles.h"
#include "refine/quality.h"
#include "test/support/dimensions.h"
#include "test/support/point_sets.h"

namespace sinkmesh {
namespace {

using namespace test;

// Isosceles, with this angle in degrees at its apex.
std::int64_t cost_of_angle(const SliverCost<2>& cost, double degrees) {
  const double half = degrees / 2 * kDegree;
  return cost(pointers<2>({{{0, 0}, {std::cos(half), std::sin(half)}, {std::cos(half), -std::sin(half)}}}));
}

TEST(SliverCost, GrowsByStepsAsTheAngleFalls) {
  const SliverCost<2> cost(15, 100);
  EXPECT_EQ(cost_of_angle(cost, 20.01), 0);
  EXPECT_EQ(cost_of_angle(cost, 19.99), 1);
  EXPECT_LT(cost_of_angle(cost, 15.01), SliverCost<2>::kSliver);
  EXPECT_GE(cost_of_angle(cost, 14.99), SliverCost<2>::kSliver);
  EXPECT_LT(cost_of_angle(cost, 10.01), 200);
  EXPECT_GE(cost_of_angle(cost, 9.99), 200);
  EXPECT_LT(cost_of_angle(cost, 5.01), 1000);
  EXPECT_GE(cost_of_angle(cost, 4.99), 1000);
  EXPECT_LE(cost_of_angle(cost, 0.4), 1030);
  std::int64_t before = 0;
  for (double degrees = 30; degrees > 0.4; degrees -= 0.1) {
    EXPECT_GE(cost_of_angle(cost, degrees), before);
    before = cost_of_angle(cost, degrees);
  }
}

TEST(SliverCost, SimplexWithoutVolumeCostsMost) {
  const std::array<Point3, 4> flat = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
  EXPECT_EQ(SliverCost<3>(15, 2)(pointers<3>(flat)), SliverCost<3>::kLow + 2030);
}

TEST(SliverCost, GrowsWithTheRatioAboveTheBound) {
  const auto cost_of_ratio = [](double ratio) {
    const double half = std::asin(1 / (2 * ratio));  // of the circle of radius ratio, over an edge of length 1
    const Point2 apex{0, -ratio * std::cos(half) - ratio};
    return SliverCost<2>(0.01, 2)(pointers<2>({{{-0.5, 0}, {0.5, 0}, apex}}));
  };
  EXPECT_EQ(cost_of_ratio(1.99), 0);
  EXPECT_EQ(cost_of_ratio(2.01), SliverCost<2>::kLow + 1);
  EXPECT_EQ(cost_of_ratio(2.99), SliverCost<2>::kLow + 25);
  EXPECT_EQ(cost_of_ratio(7.99), SliverCost<2>::kLow + 150);
  EXPECT_EQ(cost_of_ratio(100), SliverCost<2>::kLow + 1000);
}

template <class T>
class SliverCostTest : public testing::Test {};
TYPED_TEST_SUITE(SliverCostTest, PlaneAndSpace, DimensionName);

TYPED_TEST(SliverCostTest, AgreesWithAnglesAndRatioInAnyOrderOfCorners) {
  constexpr int kDim = TypeParam::value;
  using Cost = SliverCost<kDim>;
  const auto points = uniform_points<kDim>(1000 * (kDim + 1), 5);
  const Cost cost(15, 2);
  std::size_t slivers = 0;
  std::size_t low = 0;
  for (std::size_t n = 0; n < 1000; ++n) {
    std::array<Point<kDim>, kDim + 1> simplex;
    std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(n * (kDim + 1)), kDim + 1, simplex.begin());
    std::sort(simplex.begin(), simplex.end());
    const std::int64_t expected = cost(pointers<kDim>(simplex));
    const bool is_low = shape<kDim>(pointers<kDim>(simplex)).ratio2() > 4;
    const bool is_sliver = angles<kDim>(pointers<kDim>(simplex)).min < 15;
    EXPECT_EQ(expected >= Cost::kLow, is_low);
    EXPECT_TRUE(is_low || (expected >= Cost::kSliver) == is_sliver);
    low += is_low ? 1 : 0;
    slivers += is_sliver ? 1 : 0;
    while (std::next_permutation(simplex.begin(), simplex.end())) {
      ASSERT_EQ(cost(pointers<kDim>(simplex)), expected);
    }
  }
  EXPECT_GT(slivers, 200U);
  EXPECT_GT(low, 200U);
  EXPECT_LT(low, 900U);
}

}  // namespace
}  // namespace sinkmesh
