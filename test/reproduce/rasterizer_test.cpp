// SPDX-License-Identifier: MIT
#include "tools/reproduce/rasterizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "predicates/error.h"

namespace sinkmesh::reproduce {
namespace {

std::size_t samples_of(const VisibilityBuffer& buffer, std::uint32_t id) {
  std::size_t count = 0;
  for (int row = 0; row < buffer.rows(); ++row) {
    for (int column = 0; column < buffer.columns(); ++column) {
      count += buffer.at(column, row).triangle == id ? 1 : 0;
    }
  }
  return count;
}

TEST(Projection, FitsThePointsIntoTheMargin) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-3, 5);
  std::vector<Point3> points(200);
  for (Point3& p : points) p = {coordinate(random), coordinate(random), 7 + coordinate(random)};
  for (const double angle : {0.0, 20.0, 60.0}) {
    const Projection projection({{1, 2, 3}, {0, 0, 1}, angle}, points, 300, 200, 10);
    Box<2> box;
    for (const Point3& p : points) box.include({projection.project(p).x, projection.project(p).y});
    EXPECT_GE(box.low[0], 10 - 1e-9);
    EXPECT_LE(box.high[0], 290 + 1e-9);
    EXPECT_GE(box.low[1], 10 - 1e-9);
    EXPECT_LE(box.high[1], 190 + 1e-9);
    EXPECT_NEAR(std::max((box.high[0] - box.low[0]) / 280, (box.high[1] - box.low[1]) / 180), 1, 1e-9);
  }
}

TEST(Projection, ShowsUpUpwardsAndTellsNearFromFar) {
  const std::vector<Point3> points{{-1, -1, -1}, {1, 1, 1}, {1, -1, 1}};
  for (const double angle : {0.0, 40.0}) {
    const Projection projection({{0, -1, 0}, {0, 0, 1}, angle}, points, 100, 100);
    EXPECT_LT(projection.project({0, 0, 1}).y, projection.project({0, 0, 0}).y);
    EXPECT_LT(projection.project({0, 0, 0}).x, projection.project({1, 0, 0}).x);
    const double near = projection.project({0, -1, 0}).nearness;
    const double far = projection.project({0, 1, 0}).nearness;
    EXPECT_GT(near, far);
    EXPECT_NEAR(projection.depth(far) - projection.depth(near), 2 / std::sqrt(3.0), 1e-12);
  }
}

TEST(Projection, RefusesWhatItCannotShow) {
  const std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}};
  EXPECT_THROW(Projection({{0, 0, 1}, {0, 0, 2}}, points, 10, 10), InputError);
  EXPECT_THROW(Projection({{0, 0, 0}, {0, 0, 2}}, points, 10, 10), InputError);
  EXPECT_THROW(Projection({}, {}, 10, 10), InputError);
}

TEST(Rasterizer, CoversTheAreaOfATriangle) {
  const ScreenTriangle triangle{{{10.3, 12.1, 0}, {90.7, 30.2, 0}, {35.5, 88.8, 0}}};
  VisibilityBuffer buffer(100, 100, 4);
  buffer.draw(triangle, 5);
  const double area = std::abs(signed_area(triangle)) / 2;
  EXPECT_NEAR(static_cast<double>(samples_of(buffer, 5)) / 16, area, 0.005 * area);
}

TEST(Rasterizer, KnowsTheSideThatIsSeen) {
  // y points down: this one goes round counterclockwise as seen.
  const ScreenTriangle triangle{{{0, 10, 0}, {10, 10, 0}, {0, 0, 0}}};
  EXPECT_EQ(signed_area(triangle), 100);
  EXPECT_EQ(signed_area({triangle[1], triangle[0], triangle[2]}), -100);
}

TEST(Rasterizer, NearerTriangleHidesFartherOne) {
  const ScreenTriangle far{{{0, 0, 1}, {100, 0, 1}, {0, 100, 1}}};
  const ScreenTriangle near{{{20, 20, 2}, {40, 20, 2}, {20, 40, 2}}};
  VisibilityBuffer far_first(100, 100, 2);
  far_first.draw(far, 0);
  far_first.draw(near, 1);
  VisibilityBuffer near_first(100, 100, 2);
  near_first.draw(near, 1);
  near_first.draw(far, 0);
  EXPECT_EQ(far_first.at(50, 50).triangle, 1u);
  EXPECT_EQ(far_first.at(10, 10).triangle, 0u);
  EXPECT_EQ(far_first.at(199, 199).triangle, VisibilityBuffer::kNothing);
  for (int row = 0; row < 200; ++row) {
    for (int column = 0; column < 200; ++column) {
      EXPECT_EQ(far_first.at(column, row).triangle, near_first.at(column, row).triangle);
    }
  }
}

TEST(Rasterizer, TrianglesThatPierceEachOtherMeetWhereTheyAreEquallyNear) {
  const ScreenTriangle rising{{{0, 0, 0}, {100, 0, 1}, {0, 100, 0}}};
  const ScreenTriangle level{{{0, 0, 0.25}, {100, 0, 0.25}, {0, 100, 0.25}}};
  VisibilityBuffer buffer(100, 100, 1);
  buffer.draw(rising, 0);
  buffer.draw(level, 1);
  for (int column = 0; column < 90; ++column) EXPECT_EQ(buffer.at(column, 3).triangle, column < 25 ? 1u : 0u);
}

// Neither gaps along common edges, nor double cover that is more than a tie.
TEST(Rasterizer, FanAroundAPointLeavesNoGap) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> inside(1, 63);
  for (int round = 0; round < 50; ++round) {
    // Every other center is on a sample, and on the diagonals.
    const ScreenPoint center =
        round % 2 == 0 ? ScreenPoint{inside(random), inside(random), 0} : ScreenPoint{20.5, 20.5, 0};
    const std::array<ScreenPoint, 4> corners{{{0, 0, 0}, {64, 0, 0}, {64, 64, 0}, {0, 64, 0}}};
    VisibilityBuffer buffer(64, 64, 1);
    for (std::uint32_t i = 0; i < 4; ++i) buffer.draw({center, corners[i], corners[(i + 1) % 4]}, i);
    EXPECT_EQ(samples_of(buffer, VisibilityBuffer::kNothing), 0u);
  }
}

TEST(Rasterizer, CutsOffWhatLiesOutsideThePicture) {
  VisibilityBuffer buffer(10, 10, 2);
  buffer.draw({{{-1e6, -1e6, 0}, {3e6, -1e6, 0}, {-1e6, 3e6, 0}}}, 0);
  EXPECT_EQ(samples_of(buffer, 0), 400u);
  VisibilityBuffer empty(10, 10, 2);
  for (const double shift : {-1e12, -30.0, 30.0, 1e12}) {
    empty.draw({{{shift, 0, 0}, {shift + 9, 0, 0}, {shift, 9, 0}}}, 1);
    empty.draw({{{0, shift, 0}, {9, shift, 0}, {0, shift + 9, 0}}}, 1);
  }
  empty.draw({{{1, 1, 0}, {5, 5, 0}, {9, 9, 0}}}, 2);
  EXPECT_EQ(samples_of(empty, VisibilityBuffer::kNothing), 400u);
}

}  // namespace
}  // namespace sinkmesh::reproduce
