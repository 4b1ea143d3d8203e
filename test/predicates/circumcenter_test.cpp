// SPDX-License-Identifier: MIT
//
// The circumcenter against exact rationals: rounded once, to nearest even, whichever way it was computed.
#include "predicates/circumcenter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "predicates/detail/circumcenter_stages.h"
#include "predicates/input_gate.h"
#include "test/support/clouds.h"
#include "test/support/exact_center.h"

namespace sinkmesh {
namespace {

using namespace detail;
using namespace test;

template <int Dim>
Corners<Dim> corners(const std::vector<Point<Dim>>& points) {
  Corners<Dim> s;
  for (std::size_t i = 0; i <= Dim; ++i) s[i] = &points[i];
  return s;
}

template <int Dim>
std::vector<Point<Dim>> gated(std::vector<Point<Dim>> points) {
  const InputGate<Dim> gate(points);
  for (auto& p : points) p = gate.in(p);
  return points;
}

/// Adds to `certified` if the fast way answered.
template <int Dim>
void expect_exact_center(const std::vector<Point<Dim>>& points, long& certified, long& inside) {
  const auto s = corners<Dim>(points);
  const std::optional<Point<Dim>> expected = exact_center<Dim>(points);
  const auto check = [&](CenterResult r, const Point<Dim>& center) {
    ASSERT_EQ(r == CenterResult::kInside, expected.has_value());
    if (expected.has_value()) {
      ASSERT_EQ(center, *expected);
      for (const double x : center) ASSERT_FALSE(x == 0 && std::signbit(x));
    }
  };
  Point<Dim> center{};
  check(exact_circumcenter<Dim>(s, center), center);
  center = {};
  const CenterResult fast = certified_circumcenter<Dim>(s, center);
  if (fast != CenterResult::kUnknown) {
    ++certified;
    check(fast, center);
  }
  center = {};
  check(circumcenter(s, center) ? CenterResult::kInside : CenterResult::kOutside, center);
  inside += expected.has_value();
}

template <int Dim>
void expect_exact_centers() {
  Random random(16);
  long total = 0;
  long certified = 0;
  long inside = 0;
  for (const Cloud kind : kAllClouds) {
    for (int sample = 0; sample < 1500; ++sample) {
      const auto points = gated<Dim>(make_cloud<Dim>(kind, Dim + 1, random));
      if (exact_volume<Dim>(ExactPoints<Dim>(points), 0) == 0) continue;
      ++total;
      expect_exact_center<Dim>(points, certified, inside);
      if (::testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GE(total, 10000);
  EXPECT_GE(inside, total / 3);
  EXPECT_GE(certified, total / 3);
}

TEST(Circumcenter, IsCorrectlyRoundedInThePlane) { expect_exact_centers<2>(); }
TEST(Circumcenter, IsCorrectlyRoundedInSpace) { expect_exact_centers<3>(); }

TEST(Circumcenter, OfUniformPointsNeedsNoLongDivision) {
  Random random(17);
  long certified = 0;
  constexpr int kSamples = 5000;
  for (int i = 0; i < kSamples; ++i) {
    const auto points = gated<3>(make_cloud<3>(Cloud::kUniform, 4, random));
    Point3 center;
    certified += certified_circumcenter<3>(corners<3>(points), center) != CenterResult::kUnknown;
  }
  EXPECT_EQ(certified, kSamples);
}

// Around points of the coarsest grid that doubles can halve: exact ties and their neighbours.
TEST(Circumcenter, RoundsTiesToEven) {
  long certified = 0;
  long inside = 0;
  Random random(18);
  for (int sample = 0; sample < 4000; ++sample) {
    // The center of (x,.), (y,.) on a horizontal edge is (x+y)/2: a tie if x+y is odd in units of the last
    // place.
    const double x = 1 + 0x1p-52 * uniform_int(random, 0, 1000);
    const double y = x + 0x1p-52 * uniform_int(random, 1, 9);
    const double h = std::ldexp(1.0, uniform_int(random, -60, 0));
    expect_exact_center<2>({{x, 0}, {y, 0}, {x, h}}, certified, inside);
    // Below the precision of doubles: units of the grid.
    const double u = std::ldexp(uniform_int(random, -9, 9), -kGridBits);
    expect_exact_center<2>({{u, 0}, {u + std::ldexp(uniform_int(random, 1, 9), -kGridBits), 0}, {u, 1}},
                           certified, inside);
    if (HasFailure()) return;
  }
  EXPECT_EQ(inside, 8000);
}

// Tiny simplices around the origin: the fast way has its integers, but the doubles are finer than the grid.
TEST(Circumcenter, LiesOnTheGridWhereDoublesAreFiner) {
  long certified = 0;
  long inside = 0;
  long below = 0;
  Random random(20);
  for (int sample = 0; sample < 4000; ++sample) {
    const int bits = uniform_int(random, 45, 58);
    std::vector<Point2> points(3);
    for (Point2& p : points) {
      for (double& x : p) x = std::ldexp(std::floor(std::ldexp(uniform(random, -1, 1), bits)), -kGridBits);
    }
    if (exact_volume<2>(ExactPoints<2>(points), 0) == 0) continue;
    expect_exact_center<2>(points, certified, inside);
    if (HasFailure()) return;
    Point2 center;
    if (circumcenter(corners<2>(points), center)) below += std::abs(center[0]) < 0x1p-69;
  }
  EXPECT_GE(below, 1000);
}

// The center is 2^-107 beyond the middle of two doubles, the even one before it, and 2^-53 from the first
// corner: one rounding of the sum of the small parts loses what decides.
TEST(Circumcenter, IsNotCertifiedWhereTheRestIsLostInATie) {
  long certified = 0;
  long inside = 0;
  const std::vector<Point2> points{{1, 0}, {1 + 0x1p-52, -0x1p-108}, {1, 0x1p-50}};
  expect_exact_center<2>(points, certified, inside);
  Point2 center{};
  EXPECT_TRUE(circumcenter(corners<2>(points), center));
  EXPECT_EQ(center[0], 1 + 0x1p-52);
}

TEST(Circumcenter, DoesNotDependOnTheOrderOfTheCorners) {
  Random random(19);
  for (const Cloud kind : kAllClouds) {
    for (int sample = 0; sample < 60; ++sample) {
      const auto points = gated<3>(make_cloud<3>(kind, 4, random));
      if (exact_volume<3>(ExactPoints<3>(points), 0) == 0) continue;
      Corners<3> s = corners<3>(points);
      Point3 first{7, 7, 7};
      const bool inside = circumcenter(s, first);
      std::sort(s.begin(), s.end());
      do {
        Point3 center{7, 7, 7};
        ASSERT_EQ(circumcenter(s, center), inside);
        ASSERT_EQ(center, first);
      } while (std::next_permutation(s.begin(), s.end()));
    }
  }
}

TEST(Circumcenter, IsSetOnlyWithinTheBox) {
  const Point2 a{0, 0}, b{1, 0};
  const auto center_above = [&](double y) {
    // Apex (0.5, h): the center is (0.5, (h^2 - 0.25) / (2 h)); for h = -1/16 it is at 1.96875.
    const Point2 c{0.5, y};
    Point2 center{9, 9};
    const bool inside = circumcenter({&a, &b, &c}, center);
    EXPECT_EQ(inside, center[0] != 9);
    return inside;
  };
  EXPECT_TRUE(center_above(-0.0625));
  EXPECT_FALSE(center_above(-0.0615));
  EXPECT_FALSE(center_above(0x1p-121));
  // Exactly at 2: (4,0)-like corners of a right angle, scaled into the gate.
  const Point2 p{2, 1}, q{2, -1}, r{1, 0};
  Point2 center;
  EXPECT_TRUE(circumcenter({&p, &q, &r}, center));
  EXPECT_EQ(center, (Point2{2, 0}));
  // One unit of the last place beyond.
  const Point2 s{1 + 0x1p-52, 0};
  EXPECT_FALSE(circumcenter({&p, &q, &s}, center));
  // Beyond by less than half a unit of the grid: with 0 in place of 2^-121 the center is (2, 1/4).
  long certified = 0;
  long inside = 0;
  expect_exact_center<2>({{0, 0}, {0.25, 1.25}, {1, -1.5}}, certified, inside);
  EXPECT_EQ(inside, 1);
  expect_exact_center<2>({{0, 0x1p-121}, {0.25, 1.25}, {1, -1.5}}, certified, inside);
  EXPECT_EQ(inside, 1);
}

}  // namespace
}  // namespace sinkmesh
