// SPDX-License-Identifier: MIT
//
// What is particular to single models: symmetry, the surface they lie on, what they share.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "test/models/model_facts.h"
#include "tools/models/models.h"

namespace sinkmesh::test {
namespace {

// A facet by its coordinates, turned so that the smallest corner is first: equal for equal orientation.
std::array<Point3, 3> canonical(std::array<Point3, 3> corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

std::set<std::array<Point3, 3>> facets_of(const Surface3& surface) {
  std::set<std::array<Point3, 3>> facets;
  for (const auto& [a, b, c] : surface.facets) {
    facets.insert(canonical({surface.points[a], surface.points[b], surface.points[c]}));
  }
  return facets;
}

Point3 opposite(const Point3& p) { return {-p[0], -p[1], -p[2]}; }

TEST(Cuboctahedron, IsCentrallySymmetric) {
  for (const std::size_t triangles : {751, 7496}) {
    const Surface3 surface = models::make_cuboctahedron(triangles);
    const std::set<Point3> points(surface.points.begin(), surface.points.end());
    for (const Point3& p : surface.points) ASSERT_TRUE(points.contains(opposite(p)));
    const auto facets = facets_of(surface);
    for (const auto& [a, b, c] : facets) {
      // A point reflection keeps none of the orientations: it turns the normal around, and so the facet.
      ASSERT_TRUE(facets.contains(canonical({opposite(a), opposite(c), opposite(b)})));
    }
  }
}

TEST(Paraboloid, LiesOnItsSurfaceWithAFlatLidAndARoundRim) {
  const Surface3 surface = models::make_paraboloid(6272);
  std::size_t rim = 0;
  for (const Point3& p : surface.points) {
    const double r2 = p[0] * p[0] + p[1] * p[1];
    if (p[2] != 1) {
      EXPECT_NEAR(p[2], r2, 1e-12);
    } else {
      EXPECT_LE(r2, 1 + 1e-12);
      if (r2 > 1 - 1e-9) ++rim;
    }
  }
  EXPECT_EQ(rim, 110U);
}

TEST(Star, FillsItsBox) {
  const Surface3 surface = models::make_star(53508);
  Box<3> box;
  for (const Point3& p : surface.points) box.include(p);
  EXPECT_EQ(box.low[2], 0);
  EXPECT_EQ(box.high[2], 4);
  const double tip = std::sqrt(0.25 - 0.07 * 0.07) + 1.2;
  EXPECT_NEAR(box.high[0], tip, 1e-3);
  // Core and fins, without the chords' error.
  const double fins = 11 * 0.14 * 1.2;
  EXPECT_NEAR(summarize_surface(surface).signed_volume, 4 * (0.25 * std::numbers::pi + fins), 0.05);
}

TEST(Head, HasTheCavityOfTheStar) {
  for (const auto& [head_triangles, star_triangles] : {std::pair{67940, 53508}, std::pair{6800, 5356}}) {
    const auto head = facets_of(models::make_head(static_cast<std::size_t>(head_triangles)));
    const Surface3 star = models::make_star(static_cast<std::size_t>(star_triangles));
    std::size_t caps = 0;
    for (const auto& [i, j, k] : star.facets) {
      const Point3& a = star.points[i];
      const Point3& b = star.points[j];
      const Point3& c = star.points[k];
      if (a[2] == b[2] && b[2] == c[2] && (a[2] == 0 || a[2] == 4)) {
        ++caps;
      } else {
        ASSERT_TRUE(head.contains(canonical({a, c, b})));
      }
    }
    EXPECT_LT(caps, star.facets.size() / 5);
  }
}

TEST(Usa, RunsCounterclockwiseAndIsAsLargeAsTheCountry) {
  for (const std::size_t triangles : {23, 229, 2290}) {
    const Surface2 outline = models::make_usa(triangles);
    EXPECT_EQ(outline.points.size(), triangles + 2);
    // 7.8 million square kilometres with the waters enclosed.
    EXPECT_NEAR(summarize_surface(outline).signed_volume, 7.8, 0.2);
  }
}

// The outline that the reference figures of the tests were made with.
TEST(Usa, BeginsWhereItAlwaysDid) {
  const Surface2 outline = models::make_usa(229);
  EXPECT_NEAR(outline.points[0][0], -2.1129022677744045, 1e-12);
  EXPECT_NEAR(outline.points[0][1], 1.3796460634594805, 1e-12);
  EXPECT_NEAR(outline.points[1][0], -2.09931358020108, 1e-12);
  EXPECT_NEAR(outline.points[1][1], 1.3404343421206242, 1e-12);
}

}  // namespace
}  // namespace sinkmesh::test
