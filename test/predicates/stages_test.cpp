// SPDX-License-Identifier: MIT
//
// Each stage forced alone: what it answers must be right, and it must know when it cannot answer.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "predicates/detail/stages.h"
#include "predicates/lanes.h"
#include "predicates/staged.h"
#include "test/support/clouds.h"
#include "test/support/polynomial_oracle.h"

namespace sinkmesh {
namespace {

using namespace detail;
using namespace test;

template <class P>
class StagesTest : public ::testing::Test {};
using AllPolynomials =
    ::testing::Types<Orientation<2>, Orientation<3>, InSphere<2>, InSphere<3>, Diametral<2>, Diametral<3>,
                     FacetNormals<2>, FacetNormals<3>, Orthogonality<2>, Orthogonality<3>>;
TYPED_TEST_SUITE(StagesTest, AllPolynomials);

TYPED_TEST(StagesTest, AgreeWhereverTwoOfThemDecide) {
  using P = TypeParam;
  Random random(5);
  long by64 = 0;
  long first_order_decided = 0;
  for (const Cloud kind : kAllClouds) {
    for (int sample = 0; sample < 150; ++sample) {
      const auto points = make_cloud<P::kDim>(kind, P::kPoints, random);
      const auto p = pointers<P>(points);
      const int exact = by_expansions<P>(p);
      const int s64 = by_integers<P, kBits64>(p);
      const int first_order = by_first_order<P>(p);
      ASSERT_EQ((by_integers<P, kBits128>(p)), exact);
      ASSERT_TRUE(s64 == exact || s64 == kUndecided);
      ASSERT_TRUE(first_order == exact || first_order == kUndecided);
      by64 += s64 != kUndecided;
      first_order_decided += first_order != kUndecided;
      ASSERT_TRUE(by_box<P>(p) == kUndecided || exact == 0);
      const auto v = rounded_vectors<P>(p);
      for (const double error : {local_error<P>(v), permanent_error<P>(v)}) {
        const int s = by_error(P::value(v), error);
        ASSERT_TRUE(s == exact || s == kUndecided);
      }
      ASSERT_LE(permanent_of<P>(v) * P::kErrorBound, local_error<P>(v));
    }
  }
  EXPECT_GE(by64, 1000);
  EXPECT_GE(first_order_decided, 1000);
}

// The error bounds, against the exact value: by far more than a sign can tell.
TYPED_TEST(StagesTest, RoundedValuesAreWithinTheirErrors) {
  using P = TypeParam;
  Random random(6);
  for (const Cloud kind : kAllClouds) {
    for (int sample = 0; sample < 150; ++sample) {
      const auto points = make_cloud<P::kDim>(kind, P::kPoints, random);
      const auto p = pointers<P>(points);
      const auto exact_differences = exact_vectors<P>(p);
      Vectors<P, Expansion> exact;
      for (std::size_t i = 0; i < exact.size(); ++i) {
        for (std::size_t k = 0; k < P::kDim; ++k) exact[i][k] = Expansion(exact_differences[i][k]);
      }
      const auto v = rounded_vectors<P>(p);
      // Two by two or one by one: the same sums and products, to the bit.
      ASSERT_EQ(std::bit_cast<std::uint64_t>(rounded_value<P>(p) + 0.0),
                std::bit_cast<std::uint64_t>(P::value(v) + 0.0));
      const Expansion deviation = P::value(exact) - Expansion(P::value(v));
      const Expansion error(permanent_error<P>(v));
      ASSERT_GE((error - deviation).sign(), 0);
      ASSERT_GE((error + deviation).sign(), 0);
    }
  }
}

// Any finite doubles, far outside the range in which expansions are exact: an integer stage answers right or
// not at all.
TYPED_TEST(StagesTest, IntegersAreSoundForDoublesThatPassedNoGate) {
  using P = TypeParam;
  if constexpr (!std::is_same_v<P, FacetNormals<P::kDim>>) {
    Random random(7);
    long decided64 = 0;
    long decided128 = 0;
    for (int sample = 0; sample < 3000; ++sample) {
      auto points = sample % 3 == 0 ? make_wide_cloud<P::kDim>(-1074, 1022, P::kPoints, random)
                                    : make_cloud<P::kDim>(Cloud::kIntegerGrid, P::kPoints, random);
      if (sample % 3 != 0) {
        const int e = uniform_int(random, -1074, 1018);
        for (auto& p : points) {
          for (double& x : p) x = std::ldexp(x, e);
        }
        // A trace far below: it must not vanish.
        if (sample % 3 == 2)
          points[random() % P::kPoints][random() % P::kDim] += std::ldexp(1.0, uniform_int(random, -1074, e));
      }
      const auto p = pointers<P>(points);
      const int s64 = by_integers<P, kBits64>(p);
      const int s128 = by_integers<P, kBits128>(p);
      if ((s64 == kUndecided && s128 == kUndecided) || !in_domain<P>(points)) continue;
      const int exact = exact_value<P>(points).sign;
      ASSERT_TRUE(s64 == exact || s64 == kUndecided) << sample;
      ASSERT_TRUE(s128 == exact || s128 == kUndecided) << sample;
      decided64 += s64 != kUndecided;
      decided128 += s128 != kUndecided;
    }
    EXPECT_GE(decided64, 100);
    EXPECT_GE(decided128, 100);
  }
}

TEST(Integers, RefuseATraceThatVanishesUnderTheScale) {
  // The third point leaves the line by 2^-1074, which no scale for coordinates near 2^1000 keeps.
  const double big = 0x1p1000;
  const std::vector<Point2> points{{0, 0}, {big, big}, {big / 2, big / 2}};
  auto moved = points;
  moved[0][1] = 0x1p-1074;
  using P = Orientation<2>;
  EXPECT_EQ((by_integers<P, kBits64>(pointers<P>(points))), 0);
  EXPECT_EQ((by_integers<P, kBits64>(pointers<P>(moved))), kUndecided);
  EXPECT_EQ((by_integers<P, kBits128>(pointers<P>(moved))), kUndecided);
}

TEST(Integers, RefuseDifferencesThatOverflow) {
  const double max = std::numeric_limits<double>::max();
  const std::vector<Point2> points{{-max, 0}, {max, 1}, {0, 3}};
  EXPECT_EQ((by_integers<Orientation<2>, kBits64>(pointers<Orientation<2>>(points))), kUndecided);
  EXPECT_EQ((by_integers<Orientation<2>, kBits128>(pointers<Orientation<2>>(points))), kUndecided);
}

TEST(Integers, TakeEqualPointsForZero) {
  const std::vector<Point3> points(5, Point3{0.1, 0.2, 0.3});
  EXPECT_EQ((by_integers<InSphere<3>, kBits64>(pointers<InSphere<3>>(points))), 0);
  EXPECT_EQ((by_integers<InSphere<3>, kBits128>(pointers<InSphere<3>>(points))), 0);
}

TEST(Filter, DecidesNothingForNaNAndInfinity) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {nan, 0.0, infinity}) {
    EXPECT_EQ(by_error(value, nan), kUndecided);
    EXPECT_EQ(by_error(value, infinity), kUndecided);
    EXPECT_EQ(by_granularity(value, nan, 1), kUndecided);
  }
  EXPECT_EQ(by_error(nan, 0), kUndecided);
  EXPECT_EQ(by_granularity(nan, 0, 1), kUndecided);
  EXPECT_EQ(by_error(1, 1), kUndecided);
  EXPECT_EQ(by_error(2, 1), 1);
  EXPECT_EQ(by_error(-2, 1), -1);
}

TEST(Granularity, IsStrict) {
  EXPECT_EQ(by_granularity(0.25, 0.5, 1), 0);
  EXPECT_EQ(by_granularity(-0.25, 0.5, 1), 0);
  EXPECT_EQ(by_granularity(0.5, 0.5, 1), kUndecided);
  EXPECT_EQ(by_granularity(-0.5, 0.5, 1), kUndecided);
  EXPECT_EQ(by_granularity(-1, 1.5, 1), kUndecided);
  EXPECT_EQ(by_granularity(0, 0, 0), kUndecided);
}

// The permanent is largest where all differences along an axis are as large as any, and there the majorant is
// attained; the bound on the error covers the roundings of both.
TYPED_TEST(StagesTest, MajorantsAreThePermanentsOfTheLargestDifferences) {
  using P = TypeParam;
  Random random(12);
  for (int sample = 0; sample < 2000; ++sample) {
    Point<P::kDim> extents;
    for (double& x : extents) x = std::ldexp(uniform(random, 1, 2), uniform_int(random, -10, 0));
    Vectors<P, double> v;
    for (auto& vector : v) vector = extents;
    const double permanent = permanent_of<P>(v);
    ASSERT_LE(P::kErrorBound * permanent, error_within<P>(extents));
    ASSERT_NEAR(P::majorant(extents) / permanent, 1, 0x1p-40);
  }
}

TYPED_TEST(StagesTest, PolynomialsHaveTheirDegrees) {
  using P = TypeParam;
  Random random(10);
  for (int sample = 0; sample < 20; ++sample) {
    auto points = make_cloud<P::kDim>(Cloud::kUniform, P::kPoints, random);
    const double value = P::value(rounded_vectors<P>(pointers<P>(points)));
    ASSERT_NE(value, 0);
    for (auto& p : points) {
      for (double& x : p) x *= 2;
    }
    ASSERT_EQ(P::value(rounded_vectors<P>(pointers<P>(points))), std::ldexp(value, P::kDegree));
  }
}

// Zeros of multiples of 1/8, magnified until the error of the rounded value is near 8^-degree, of which every
// value is a multiple: the stage decides up to there, and no further.
TYPED_TEST(StagesTest, GranularityDecidesTheZerosWhoseErrorIsBelowTheUnit) {
  using P = TypeParam;
  constexpr int kBits = 3;
  const double unit = std::ldexp(1.0, -kBits * P::kDegree);
  Random random(11);
  int by_local = 0;
  int by_permanent = 0;
  int beyond = 0;
  for (int sample = 0; sample < 20000; ++sample) {
    const Cloud kind = std::array{Cloud::kIntegerSphere, Cloud::kIntegerGrid, Cloud::kFlatInteger}[sample % 3];
    auto points = make_cloud<P::kDim>(kind, P::kPoints, random);
    const auto p = pointers<P>(points);
    if (by_integers<P, kBits64>(p) != 0) continue;
    // What the error would be were the unit 1, to the power that makes it a factor of the coordinates.
    const double factor = std::pow(1 / local_error<P>(rounded_vectors<P>(p)), 1.0 / P::kDegree);
    const double magnified = std::floor(factor * uniform(random, 0.8, 1.6));
    if (!(magnified >= 1 && magnified < 0x1p40)) continue;  // infinite where an axis has no extent
    Box<P::kDim> box;
    for (auto& point : points) {
      for (double& x : point) x *= std::ldexp(magnified, -kBits);
      box.include(point);
    }
    const auto v = rounded_vectors<P>(p);
    const double value = std::abs(P::value(v));
    const Verdict verdict = Predicates<P::kDim>(box, kBits).template verdict<P>(p);
    ASSERT_EQ(verdict.sign, 0);
    const double local = local_error<P>(v);
    const double permanent = permanent_error<P>(v);
    if (value + local < unit) {
      ASSERT_EQ(verdict.stage, Stage::kGranularity);
      by_local += 2 * local >= unit;
    } else if (by_box<P>(p) == 0) {
      ASSERT_EQ(verdict.stage, Stage::kBox);
    } else if (value + permanent < unit) {
      ASSERT_EQ(verdict.stage, Stage::kGranularity);
      ++by_permanent;
    } else {
      ASSERT_NE(verdict.stage, Stage::kGranularity);
      beyond += permanent < 2 * unit;
    }
  }
  EXPECT_GE(by_local, 10);
  EXPECT_GE(by_permanent, 10);
  EXPECT_GE(beyond, 10);
}

// A point finer than the set's grid must end the certificate, whichever of its coordinates is finer: here a
// volume of 2^-50, which the rounding errors hide, would be taken for zero.
TEST(PredicatesOfASet, FollowAPointFinerThanTheGranularity) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto turned = [&](const Point3& p) {
      Point3 q;
      for (std::size_t k = 0; k < 3; ++k) q[(k + axis) % 3] = p[k];
      return q;
    };
    Box<3> box;
    box.include({-2, -2, -2});
    box.include({2, 2, 2});
    Predicates<3> predicates(box, 0);
    const Point3 a = turned({0, 0, 0}), b = turned({1, 0, 1}), c = turned({0, 1, 0}), d = turned({1, 1, 1});
    const Point3 x = turned({1, 1, 1 + 0x1p-50});
    EXPECT_EQ(predicates.orient({&a, &b, &c, &d}), 0);
    predicates.include(x);
    EXPECT_EQ(predicates.orient({&a, &b, &c, &x}), 1);
    EXPECT_EQ(predicates.orient({&a, &b, &c, &d}), 0);
  }
}

TEST(PredicatesOfASet, FollowAPointOutsideTheBox) {
  // With the small box the static bound is far below the rounding errors of these coordinates.
  Random random(8);
  for (int sample = 0; sample < 2000; ++sample) {
    Box<3> box;
    box.include({0, 0, 0});
    box.include({0x1p-30, 0x1p-30, 0x1p-30});
    Predicates<3> predicates(box, 60);
    auto points = make_cloud<3>(Cloud::kScaledSphere, 5, random);
    for (auto& p : points) {
      for (double& x : p) x *= 0.25;
      predicates.include(p);
    }
    ASSERT_EQ(predicates.verdict<InSphere<3>>(pointers<InSphere<3>>(points)).sign,
              exact_value<InSphere<3>>(points).sign);
  }
}

// Behind the gate the wide integers always answer: the corners of the grid's range.
TEST(Integers128, AlwaysAnswerOnTheGridOfTheGate) {
  Random random(9);
  for (int sample = 0; sample < 3000; ++sample) {
    std::vector<Point3> points(8);
    for (auto& p : points) {
      for (double& x : p) {
        switch (random() % 3) {
          case 0:
            x = std::ldexp(uniform_int(random, -5, 5), -121);
            break;
          case 1:
            x = (random() % 2 != 0 ? 1 : -1) * (2 - 0x1p-52 * uniform_int(random, 1, 5));
            break;
          default:
            x = uniform(random, -2, 2);
            x = std::ldexp(std::nearbyint(std::ldexp(x, 121)), -121);
        }
      }
    }
    ASSERT_EQ((by_integers<Orthogonality<3>, kBits128>(pointers<Orthogonality<3>>(points))),
              exact_value<Orthogonality<3>>(points).sign);
    ASSERT_EQ((by_integers<InSphere<3>, kBits128>(pointers<InSphere<3>>(points))),
              exact_value<InSphere<3>>(points).sign);
    ASSERT_EQ((by_integers<Diametral<3>, kBits128>(pointers<Diametral<3>>(points))),
              exact_value<Diametral<3>>(points).sign);
  }
}

}  // namespace
}  // namespace sinkmesh
