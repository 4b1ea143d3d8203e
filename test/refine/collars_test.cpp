// SPDX-License-Identifier: MIT
#include "refine/collars.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "core/vector.h"
#include "refine/refine.h"
#include "test/support/boundary_surfaces.h"
#include "test/support/conformed.h"

namespace sinkmesh {
namespace {

using test::Conforming;

// Convex, and flat: dihedral angles from 15 degrees, at three corners facets of 3 to 11 degrees and more above
// others.
Surface3 flat_hull() {
  Surface3 s;
  s.points = {{2.338166736175902, -0.6628539080668208, 0.03948596212311631},
              {0.14652144723938165, 0.8351485796673621, -0.14021097884728553},
              {-3.1978061868959, 1.1906843579031263, -0.03918831118834686},
              {-1.5374389198677687, 1.443480009479158, -0.12655455805135932},
              {-0.24658705093195132, 0.48288180143420295, -0.3634693171279535},
              {1.400662707244371, -1.1067423692040472, -0.0213070814092119},
              {-2.167070078193451, 0.14282568399758033, -0.17602540472230666},
              {-1.7083245614809905, 2.2373634749176485, 0.057599221269454076},
              {0.14265583363929268, -1.8872811895008552, -0.0009973529112351702},
              {-1.2581780509656655, 1.6448720018058314, 0.08982433009625171},
              {-0.6551973196213488, -2.048902962505933, -0.09282952260579677}};
  s.facets = {{0, 4, 1}, {0, 1, 7},  {0, 5, 4}, {0, 8, 5},  {0, 7, 9},  {0, 9, 8},
              {1, 4, 7}, {2, 3, 4},  {2, 7, 3}, {2, 4, 6},  {2, 6, 10}, {2, 9, 7},
              {2, 8, 9}, {2, 10, 8}, {3, 7, 4}, {4, 5, 10}, {4, 10, 6}, {5, 8, 10}};
  return s;
}

// All points of a grid on a triangle, those of a given corner left out.
template <class Visit>
void sample(const std::array<Point3, 3>& t, int n, Visit&& visit) {
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; i + j <= n; ++j) {
      Point3 x{};
      for (std::size_t k = 0; k < 3; ++k) x[k] = (i * t[0][k] + j * t[1][k] + (n - i - j) * t[2][k]) / n;
      visit(x);
    }
  }
}

// Of features without the corner, as far as samples tell; and how far they may be wrong.
std::pair<double, double> nearest_other(const Conforming<3>& c, Vertex corner) {
  constexpr int kPieces = 400;
  const Point3& p = c.complex().point(corner);
  double least = HUGE_VAL;
  double spacing = 0;
  for (const auto& facet : c.facets) {
    const auto at = std::find(facet.begin(), facet.end(), corner);
    std::array<Point3, 3> t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = c.complex().point(facet[k]);
    if (at != facet.end()) t[static_cast<std::size_t>(at - facet.begin())] = t[at == facet.begin() ? 1 : 0];
    for (std::size_t k = 0; k < 3; ++k) {
      spacing = std::max(spacing, std::sqrt(squared_distance(t[k], t[(k + 1) % 3])) / kPieces);
    }
    sample(t, kPieces, [&](const Point3& x) { least = std::min(least, std::sqrt(squared_distance(x, p))); });
  }
  return {least, spacing};
}

class FlatHull : public testing::Test {
 protected:
  Conforming<3> without{flat_hull()};
  Collars collars;

  FlatHull() {
    without.conformer.start();
    EXPECT_FALSE(without.conform());
    EXPECT_FALSE(without.conformer.unconformed().empty());
    EXPECT_TRUE(collars.add_crowded<3>(without.boundary, without.facets));
  }
};

TEST_F(FlatHull, CollarsStayAwayFromFeaturesOfOthers) {
  EXPECT_FALSE(collars.add_crowded<3>(without.boundary, without.facets)) << "all have theirs by now";
  std::size_t count = 0;
  for (const auto& [corner, radius] : collars) {
    const auto [distance, spacing] = nearest_other(without, corner);
    EXPECT_LE(radius, 0.4 * distance * (1 + 1e-12)) << corner.index();
    EXPECT_GE(radius, 0.4 * (distance - spacing)) << corner.index();
    ++count;
  }
  EXPECT_GE(count, 1U);
  EXPECT_LT(count, without.surface.points.size());
}

TEST_F(FlatHull, ConformsWithNothingInsideCollars) {
  while (true) {
    Conforming<3> c(flat_hull(), false, collars);
    c.conformer.start();
    if (!c.conform()) {
      ASSERT_TRUE(collars.add_crowded<3>(c.boundary, c.facets)) << "no corner is left";
      continue;
    }
    test::expect_conforming(c);
    test::expect_walls(c);
    test::expect_pieces(c, false);
    test::expect_places(c);
    for (const auto& [corner, radius] : collars) {
      std::size_t on = 0;
      for (std::uint32_t v = 0; v < c.complex().num_vertices(); ++v) {
        if (Vertex(v) == corner) continue;
        const double distance =
            std::sqrt(squared_distance(c.complex().point(Vertex(v)), c.complex().point(corner)));
        EXPECT_GE(distance, radius * (1 - 1e-14)) << v;
        on += distance < radius * (1 + 2e-6) ? 1 : 0;
      }
      EXPECT_GT(on, 3U) << corner.index();
    }
    return;
  }
}

TEST_F(FlatHull, IsRefinedByTheUsualCall) {
  SurfaceMesher<3> mesher(flat_hull());
  RefineOptions options;
  ASSERT_TRUE(mesher.find_domain(options).ok());
  const RefineResult result = mesher.refine(options);
  EXPECT_EQ(result.stop, Stop::no_candidate);
  EXPECT_EQ(result.centers_beyond, 0U);
}

TEST(Collars, DoNotDependOnNumbers) {
  const Surface3 given = flat_hull();
  std::set<std::uint64_t> hashes;
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 5; ++trial) {
    std::vector<std::uint32_t> number(given.points.size());
    std::iota(number.begin(), number.end(), 0);
    std::shuffle(number.begin(), number.end(), random);
    Surface3 s = given;
    for (std::size_t v = 0; v < number.size(); ++v) s.points[number[v]] = given.points[v];
    for (auto& facet : s.facets) {
      for (std::uint32_t& v : facet) v = number[v];
      std::rotate(facet.begin(), facet.begin() + static_cast<std::ptrdiff_t>(random() % 3), facet.end());
    }
    std::shuffle(s.facets.begin(), s.facets.end(), random);
    SurfaceMesher<3> mesher(s);
    RefineOptions options;
    ASSERT_TRUE(mesher.find_domain(options).ok());
    mesher.refine(options);
    hashes.insert(mesher.hash());
  }
  EXPECT_EQ(hashes.size(), 1U);
}

TEST(Collars, NoneWhereNothingIsCrowded) {
  Conforming<3> c(test::box_surface({0, 0, 0}, {1, 2, 3}));
  c.conformer.start();
  ASSERT_TRUE(c.conform());
  Collars collars;
  EXPECT_FALSE(collars.add_crowded<3>(c.boundary, c.facets));
  EXPECT_TRUE(collars.empty());
}

}  // namespace
}  // namespace sinkmesh
