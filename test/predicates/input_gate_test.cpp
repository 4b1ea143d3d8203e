// SPDX-License-Identifier: MIT
//
// The gate: exact scaling, the grid, and what it refuses.
#include "predicates/input_gate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "predicates/error.h"
#include "test/support/clouds.h"

namespace sinkmesh {
namespace {

using namespace test;
using ::testing::HasSubstr;

constexpr double kGrid = 0x1p-121;

std::string refusal(const std::vector<Point3>& points) {
  try {
    const InputGate<3> gate(points);
  } catch (const InputError& e) {
    return e.what();
  }
  return {};
}

TEST(InputGate, ScalesTheLargestCoordinateIntoOneToTwo) {
  Random random(14);
  for (int i = 0; i < 2000; ++i) {
    const int e = uniform_int(random, -799, 1020);
    std::vector<Point3> points(3);
    for (auto& p : points) {
      for (double& x : p) x = std::ldexp(uniform(random, -1, 1), e);
    }
    points[1][2] = std::ldexp(-1.5, e);
    const InputGate<3> gate(points);
    ASSERT_EQ(gate.exponent(), -e);
    ASSERT_EQ(gate.rounded_points(), 0u);
    ASSERT_EQ(gate.in(points[1])[2], -1.5);
    ASSERT_EQ(gate.box().low[2], -1.5);
    for (const auto& p : points) {
      ASSERT_EQ(gate.out(gate.in(p)), p);
      ASSERT_TRUE(gate.box().contains(gate.in(p)));
    }
  }
}

TEST(InputGate, KeepsTheWholeRangeOfDoubles) {
  const double max = std::numeric_limits<double>::max();
  const InputGate<2> large(std::vector<Point2>{{max, -max}, {0x1p1000, 0}});
  EXPECT_EQ(large.exponent(), -1023);
  EXPECT_EQ(large.rounded_points(), 0u);
  EXPECT_EQ(large.out(large.in({max, -max})), (Point2{max, -max}));
  const InputGate<2> small(std::vector<Point2>{{0x1p-800, 0}});
  EXPECT_EQ(small.exponent(), 800);
  EXPECT_EQ(small.in({0x1p-800, 0}), (Point2{1, 0}));
}

TEST(InputGate, RoundsToNearestEvenOnTheGridAndCountsThePoints) {
  const std::vector<Point2> points{{1, 0},
                                   {0.5 * kGrid, 1.5 * kGrid},                 // ties
                                   {0.75 * kGrid, -0.25 * kGrid},              // nearest
                                   {-2.5 * kGrid, 3 * kGrid},                  // tie, exact
                                   {0x1p-300, 1},                              // far below
                                   {0x1p-69, -0x1p-70 - 0x1p-121},             // exact
                                   {0x1p-70 - 0x1p-122, 0x1p-1074},            // tie, far below
                                   {0x1p-69 + 0x1p-121, 0x1p-70 + 0x3p-122}};  // exact, tie
  const InputGate<2> gate(points);
  EXPECT_EQ(gate.in(points[1]), (Point2{0, 2 * kGrid}));
  EXPECT_EQ(gate.in(points[2]), (Point2{kGrid, 0}));
  EXPECT_EQ(gate.in(points[3]), (Point2{-2 * kGrid, 3 * kGrid}));
  EXPECT_EQ(gate.in(points[4]), (Point2{0, 1}));
  EXPECT_EQ(gate.in(points[5]), points[5]);
  EXPECT_EQ(gate.in(points[6]), (Point2{0x1p-70, 0}));
  EXPECT_EQ(gate.in(points[7]), (Point2{0x1p-69 + kGrid, 0x1p-70 + 2 * kGrid}));
  EXPECT_EQ(gate.rounded_points(), 6u);
  EXPECT_EQ(gate.granularity(), kGridBits);
}

TEST(InputGate, RoundsAfterScaling) {
  // The grid is relative to the largest coordinate: 2^-21 here.
  const InputGate<2> gate(std::vector<Point2>{{0x1p100, 0x1.8p-21}});
  EXPECT_EQ(gate.in({0x1p100, 0x1.8p-21}), (Point2{1, 2 * kGrid}));
  EXPECT_EQ(gate.rounded_points(), 1u);
  EXPECT_EQ(gate.out({1, 2 * kGrid}), (Point2{0x1p100, 0x1p-20}));
}

TEST(InputGate, RoundsAgainstGmp) {
  Random random(15);
  const InputGate<2> gate(std::vector<Point2>{{1, 1}});
  for (int i = 0; i < 20000; ++i) {
    // All 53 bits, so that there is something to round up to 2^-69.
    const double m = random() % 2 != 0 ? uniform(random, 1, 2) : uniform(random, -2, -1);
    const double x = std::ldexp(m, uniform_int(random, -130, -60));
    const double y = gate.in({x, 0})[0];
    if (std::abs(x) >= 0x1p-69) {
      ASSERT_EQ(y, x);
    }
    const double units = std::ldexp(y, kGridBits);
    ASSERT_EQ(std::trunc(units), units);
    const double error = std::abs(std::ldexp(x, kGridBits) - units);  // exact: x 2^121 has few bits above 2^-62
    ASSERT_LE(error, 0.5);
    if (error == 0.5) {
      ASSERT_EQ(std::remainder(units, 2), 0);
    }
  }
}

TEST(InputGate, TurnsNegativeZeroIntoPositiveZero) {
  const InputGate<3> gate(std::vector<Point3>{{-0.0, 1, -0x1p-200}});
  const Point3 p = gate.in({-0.0, 1, -0x1p-200});
  EXPECT_FALSE(std::signbit(p[0]));
  EXPECT_FALSE(std::signbit(p[2]));
}

TEST(InputGate, KnowsTheGranularity) {
  EXPECT_EQ(InputGate<2>(std::vector<Point2>{{3, 1}, {2, 0}}).granularity(), 1);  // scaled by 1/2
  EXPECT_EQ(InputGate<2>(std::vector<Point2>{{1, 1}, {0, 0}}).granularity(), 0);
  EXPECT_EQ(InputGate<2>(std::vector<Point2>{{1, 0.375}}).granularity(), 3);
  EXPECT_EQ(InputGate<2>(std::vector<Point2>{{1, 0.1}}).granularity(), 55);
}

TEST(InputGate, PassesNoPointsAndTheOrigin) {
  const InputGate<3> none(std::vector<Point3>{});
  EXPECT_EQ(none.exponent(), 0);
  EXPECT_EQ(none.granularity(), 0);
  const InputGate<3> origin(std::vector<Point3>{{0, -0.0, 0}});
  EXPECT_EQ(origin.exponent(), 0);
  EXPECT_EQ(origin.box().high, (Point3{0, 0, 0}));
  EXPECT_EQ(origin.rounded_points(), 0u);
}

TEST(InputGate, NamesTheFirstCoordinateThatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string first = refusal({{0, 0, 0}, {1, nan, 0}, {nan, 0, 0}});
  EXPECT_THAT(first, HasSubstr("point 1"));
  EXPECT_THAT(first, HasSubstr("coordinate y"));
  EXPECT_THAT(first, HasSubstr("nan"));
  EXPECT_THAT(first, HasSubstr("remove or repair"));
  const std::string second = refusal({{0, 0, 0}, {1, 2, -std::numeric_limits<double>::infinity()}});
  EXPECT_THAT(second, HasSubstr("coordinate z"));
  EXPECT_THAT(second, HasSubstr("-inf"));
}

TEST(InputGate, RefusesASetThatIsTooSmall) {
  const std::string message = refusal({{0, 0, 0}, {0, 0x1p-801, 0}});
  EXPECT_THAT(message, HasSubstr("point 1: coordinate y"));
  EXPECT_THAT(message, HasSubstr("0x1p-801"));
  EXPECT_THAT(message, HasSubstr("multiply"));
  EXPECT_EQ(refusal({{0, 0, 0}, {0, 0x1p-800, 0}}), "");
}

}  // namespace
}  // namespace sinkmesh
