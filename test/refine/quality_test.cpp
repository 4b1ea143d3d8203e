// SPDX-License-Identifier: MIT
#include "refine/quality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "test/support/point_sets.h"

namespace sinkmesh {
namespace {

using test::pointers;

const std::array<Point3, 4> kRegular = {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};

TEST(Quality, RegularTetrahedronHasTheSmallestRatio) {
  const Shape s = shape<3>(pointers<3>(kRegular));
  EXPECT_DOUBLE_EQ(s.radius2, 3);
  EXPECT_DOUBLE_EQ(s.shortest2, 8);
  EXPECT_DOUBLE_EQ(s.ratio2(), 3.0 / 8);
}

TEST(Quality, RightTriangleHasItsHypotenuseAsDiameter) {
  const std::array<Point2, 3> t = {{{0, 0}, {3, 0}, {0, 4}}};
  const Shape s = shape<2>(pointers<2>(t));
  EXPECT_DOUBLE_EQ(s.radius2, 6.25);
  EXPECT_DOUBLE_EQ(s.shortest2, 9);
}

TEST(Quality, FacetInSpaceIsMeasuredAsATriangle) {
  const std::array<Point3, 3> t = {{{0, 0, 7}, {3, 0, 7}, {0, 4, 7}}};
  const Shape s = facet_shape<3>({&t[0], &t[1], &t[2]});
  EXPECT_DOUBLE_EQ(s.radius2, 6.25);
  EXPECT_DOUBLE_EQ(s.shortest2, 9);
}

TEST(Quality, FlatSimplexHasInfiniteRadius) {
  const std::array<Point3, 4> square = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
  EXPECT_TRUE(std::isinf(shape<3>(pointers<3>(square)).ratio2()));
  const std::array<Point3, 4> line = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}};
  EXPECT_TRUE(std::isinf(shape<3>(pointers<3>(line)).ratio2()));
}

// Four points of a circle, one of them lifted by h: as h goes to 0, rounding takes the volume away, not the
// circle.
TEST(Quality, NearlyFlatSimplexHasTheRadiusOfItsCircle) {
  for (const double h : {0x1p-20, 0x1p-40, 0x1p-60, 0x1p-100}) {
    // The center (0,0,z) is as far from (5,0,h) as from the others: 25 + (z-h)^2 = 25 + z^2, so z = h/2.
    const std::array<Point3, 4> t = {{{3, 4, 0}, {-4, 3, 0}, {0, -5, 0}, {5, 0, h}}};
    EXPECT_NEAR(shape<3>(pointers<3>(t)).radius2, 25 + h * h / 4, 1e-9) << h;
    const std::array<Point2, 3> needle = {{{0, 0}, {1, h}, {2, 0}}};
    const double radius = (1 + h * h) / (2 * h);
    EXPECT_NEAR(shape<2>(pointers<2>(needle)).radius2 / (radius * radius), 1, 1e-9) << h;
  }
}

TEST(Quality, DoesNotDependOnTheOrderOfCorners) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int n = 0; n < 200; ++n) {
    std::array<Point3, 4> t;
    for (Point3& p : t) p = {uniform(random), uniform(random), 1e-7 * uniform(random)};
    const Shape first = shape<3>(pointers<3>(t));
    std::array<int, 4> order = {0, 1, 2, 3};
    while (std::next_permutation(order.begin(), order.end())) {
      const Shape other = shape<3>({&t[order[0]], &t[order[1]], &t[order[2]], &t[order[3]]});
      ASSERT_EQ(first.radius2, other.radius2);
      ASSERT_EQ(first.shortest2, other.shortest2);
    }
  }
}

TEST(Quality, AnglesOfKnownSimplices) {
  const double regular = std::acos(1.0 / 3) * 180 / M_PI;
  EXPECT_NEAR(angles<3>(pointers<3>(kRegular)).min, regular, 1e-12);
  EXPECT_NEAR(angles<3>(pointers<3>(kRegular)).max, regular, 1e-12);
  const std::array<Point3, 4> corner = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  EXPECT_NEAR(angles<3>(pointers<3>(corner)).max, 90, 1e-12);
  EXPECT_NEAR(angles<3>(pointers<3>(corner)).min, std::acos(1 / std::sqrt(3.0)) * 180 / M_PI, 1e-12);
  // A sliver: the corners of a square, two of them lifted by h, two lowered. Its facets have slopes of 2h, in
  // directions at right angles, so they meet at 2 sqrt(2) h along the sides.
  const double h = 1e-9;
  const std::array<Point3, 4> sliver = {{{1, 0, h}, {-1, 0, h}, {0, 1, -h}, {0, -1, -h}}};
  EXPECT_NEAR(angles<3>(pointers<3>(sliver)).min / (2 * std::sqrt(2.0) * h * 180 / M_PI), 1, 1e-6);
  EXPECT_GT(angles<3>(pointers<3>(sliver)).max, 179.99);
  const std::array<Point2, 3> half_square = {{{0, 0}, {1, 0}, {0, 1}}};
  EXPECT_NEAR(angles<2>(pointers<2>(half_square)).min, 45, 1e-12);
  EXPECT_NEAR(angles<2>(pointers<2>(half_square)).max, 90, 1e-12);
}

TEST(Quality, StatisticsCountLowQualityAndFillTheHistogram) {
  QualityStatistics statistics(1.0);
  statistics.add<3>(pointers<3>(kRegular));
  const std::array<Point3, 4> needle = {{{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 1}}};
  statistics.add<3>(pointers<3>(needle));
  EXPECT_EQ(statistics.simplices(), 2U);
  EXPECT_EQ(statistics.low_quality(), 1U);
  EXPECT_NEAR(statistics.min_ratio(), std::sqrt(3.0 / 8), 1e-12);
  const double needle_ratio = std::sqrt(1 + 2e-4) / 2 / 0.01;
  EXPECT_NEAR(statistics.max_ratio(), needle_ratio, 1e-9);
  EXPECT_NEAR(statistics.average_ratio(), (needle_ratio + std::sqrt(3.0 / 8)) / 2, 1e-9);
  EXPECT_EQ(statistics.histogram().front(), 1U);
  EXPECT_EQ(statistics.histogram().back(), 1U);
}

}  // namespace
}  // namespace sinkmesh
