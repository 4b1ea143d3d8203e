// SPDX-License-Identifier: MIT
//
// The gate: exact scaling, the grid, and what it refuses.
#include "predicates/input_gate.h"

#include <gmock/gmock.h>
#include <gmpxx.h>
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

// By the definition, in the integers of GMP: x 2^121 = whole + rest.
double expected_on_grid(double x) {
  mpq_class units(x);
  mpq_mul_2exp(units.get_mpq_t(), units.get_mpq_t(), kGridBits);
  mpz_class whole;
  mpz_fdiv_q(whole.get_mpz_t(), units.get_num_mpz_t(), units.get_den_mpz_t());
  const mpq_class rest = units - whole;
  if (rest > mpq_class(1, 2) || (rest == mpq_class(1, 2) && mpz_odd_p(whole.get_mpz_t()))) ++whole;
  mpq_class result(whole);
  mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), kGridBits);
  return result.get_d();  // exact: at most 53 bits
}

template <std::size_t N>
void expect_on_grid(const std::array<double, N>& p) {
  const std::array<double, N> rounded = on_grid<static_cast<int>(N)>(p);
  for (std::size_t k = 0; k < N; ++k) {
    ASSERT_EQ(rounded[k], expected_on_grid(p[k])) << p[k];
    ASSERT_FALSE(rounded[k] == 0 && std::signbit(rounded[k])) << p[k];
    if (std::abs(p[k]) >= 0x1p-69) {
      ASSERT_EQ(rounded[k], p[k]);
    }
  }
}

TEST(OnGrid, IsTheNearestMultipleByGmp) {
  Random random(16);
  const auto any = [&](int low, int high) {
    const double m = uniform(random, 1, 2);
    return std::ldexp(random() % 2 != 0 ? m : -m, uniform_int(random, low, high));
  };
  for (int i = 0; i < 5000; ++i) {
    expect_on_grid(Point3{any(-125, -119), any(-122, -60), any(-300, 0)});
    expect_on_grid(Point2{any(-71, -68), any(-1074, 0)});
    // Ties, and next to them, over the whole range in which there are any.
    const double half = std::ldexp(1.0, -kGridBits - 1);
    const double bits = std::ldexp(1.0, uniform_int(random, 0, 51));
    const double tie = (2 * std::floor(uniform(random, -bits, bits)) + 1) * half;
    expect_on_grid(Point3{tie, std::nextafter(tie, HUGE_VAL), std::nextafter(tie, -HUGE_VAL)});
  }
  for (const double x :
       {0.0, -0.0, 0x1p-122, -0x1p-122, 0x3p-122, -0x3p-122, 0x1p-69, -0x1p-69, std::nextafter(0x1p-69, 0.0),
        -std::nextafter(0x1p-69, 0.0), 0x1p-1074, -0x1p-1074, 1.0, std::nextafter(2.0, 0.0)}) {
    expect_on_grid(Point2{x, -x});
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
