// SPDX-License-Identifier: MIT
#include "refine/angles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/vector.h"
#include "test/support/dimensions.h"
#include "test/support/point_sets.h"

namespace sinkmesh {
namespace {

using namespace test;

// The angle at a between b and c; of the edge ab between the facets with c and d.
double angle_at(const Point2& a, const Point2& b, const Point2& c) {
  return std::atan2(std::abs(cross(b - a, c - a)), dot(b - a, c - a)) / kDegree;
}
double angle_at(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Point3 m = cross(b - a, c - a);
  const Point3 n = cross(b - a, d - a);
  const Point3 mn = cross(m, n);
  return std::atan2(std::sqrt(dot(mn, mn)), dot(m, n)) / kDegree;
}

std::vector<double> all_angles(const std::array<Point2, 3>& p) {
  return {angle_at(p[0], p[1], p[2]), angle_at(p[1], p[2], p[0]), angle_at(p[2], p[0], p[1])};
}
std::vector<double> all_angles(const std::array<Point3, 4>& p) {
  return {angle_at(p[0], p[1], p[2], p[3]), angle_at(p[0], p[2], p[1], p[3]), angle_at(p[0], p[3], p[1], p[2]),
          angle_at(p[1], p[2], p[0], p[3]), angle_at(p[1], p[3], p[0], p[2]), angle_at(p[2], p[3], p[0], p[1])};
}

template <class T>
class AngleCensusTest : public testing::Test {};
TYPED_TEST_SUITE(AngleCensusTest, PlaneAndSpace, DimensionName);

TYPED_TEST(AngleCensusTest, CountsWhatTheDefinitionCounts) {
  constexpr int kDim = TypeParam::value;
  constexpr std::size_t kSimplices = 3000;
  const auto points = uniform_points<kDim>(kSimplices * (kDim + 1), 7);
  AngleCensus census;
  std::vector<std::uint64_t> histogram(census.histogram().size(), 0);
  std::array<std::size_t, 3> below{};
  std::array<std::size_t, 3> inner_below{};
  for (std::size_t n = 0; n < kSimplices; ++n) {
    std::array<Point<kDim>, kDim + 1> simplex;
    std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(n * (kDim + 1)), kDim + 1, simplex.begin());
    const bool is_inner = n % 3 == 0;
    census.add<kDim>(pointers<kDim>(simplex), is_inner);
    const std::vector<double> angles = all_angles(simplex);
    for (const double a : angles) ++histogram[static_cast<std::size_t>(a / AngleCensus::kBinWidth)];
    const double least = *std::min_element(angles.begin(), angles.end());
    for (std::size_t i = 0; i < 3; ++i) {
      below[i] += least < AngleCensus::kSmall[i] ? 1 : 0;
      inner_below[i] += is_inner && least < AngleCensus::kSmall[i] ? 1 : 0;
    }
  }
  EXPECT_TRUE(std::equal(histogram.begin(), histogram.end(), census.histogram().begin()));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(census.below(i), below[i]);
    EXPECT_EQ(census.inner_below(i), inner_below[i]);
  }
  EXPECT_GT(below[0], 100U);
  EXPECT_GT(inner_below[0], 30U);
}

TEST(AngleCensus, AngleAtTheEndOfABinBelongsToTheNextOne) {
  const std::array<Point2, 3> right = {{{0, 0}, {1, 0}, {0, 1}}};
  AngleCensus census;
  census.add<2>(pointers<2>(right), true);
  EXPECT_EQ(
      census.histogram()[45 / AngleCensus::kBinWidth] + census.histogram()[45 / AngleCensus::kBinWidth - 1],
      2U);
  EXPECT_EQ(
      census.histogram()[90 / AngleCensus::kBinWidth] + census.histogram()[90 / AngleCensus::kBinWidth - 1],
      1U);
  EXPECT_EQ(census.below(2), 0U);
}

// No angle is larger or smaller than one of 0 degrees, nor is it lost.
TEST(AngleCensus, FlatSimplexHasItsAnglesInTheFirstBin) {
  const std::array<Point3, 4> flat = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}};
  AngleCensus census;
  census.add<3>(pointers<3>(flat), false);
  EXPECT_EQ(census.histogram()[0], 6U);
  EXPECT_EQ(census.below(0), 1U);
  EXPECT_EQ(census.inner_below(0), 0U);
}

}  // namespace
}  // namespace sinkmesh
