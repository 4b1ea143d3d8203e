// SPDX-License-Identifier: MIT
#include "refine/patch_triangulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "test/support/boundary_surfaces.h"
#include "test/support/conformed.h"

namespace sinkmesh {
namespace {

using Kind = Feature::Kind;
using test::Conforming;
using test::Random;

// Boxes with sides of 256, a prism over an L, two boxes with a wall between them: all points are integers.
std::vector<std::pair<std::string, Surface3>> integer_solids() {
  std::vector<std::pair<std::string, Surface3>> solids;
  solids.emplace_back("box", test::box_surface({0, 0, 0}, {256, 128, 64}));
  solids.emplace_back("grid", test::grid_cube(3, 5));
  solids.emplace_back("L", test::prism({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}},
                                       {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, 1));
  solids.emplace_back("two boxes", test::two_boxes(true));
  for (std::size_t i = 1; i < solids.size(); ++i) {
    for (Point3& p : solids[i].second.points) {
      for (double& x : p) x *= 64;
    }
  }
  return solids;
}

// The sub-facets of a patch that hold a point of its projection, brute force.
std::vector<SubFacet> holders(const Conforming<3>& c, std::uint32_t patch, const Point2& x) {
  const Plane& plane = c.boundary.features().patches()[patch].plane;
  std::vector<SubFacet> result;
  for (const SubFacet f : c.sub_facets()) {
    const auto& record = c.boundary.sub_facets()[f];
    if (record.owner != patch) continue;
    std::array<Point2, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = plane.project(c.complex().point(record.corners[k]));
    bool is_in = true;
    for (std::size_t k = 0; k < 3; ++k) is_in = is_in && test::exact_area2(p[k], p[(k + 1) % 3], x) >= 0;
    if (is_in) result.push_back(f);
  }
  return result;
}

SubFacet random_sub_facet(const Conforming<3>& c, Random& random) {
  const auto all = c.sub_facets();
  return all[random() % all.size()];
}

// A point of the projection with integer coordinates, within the box of a sub-facet, or anywhere around the
// whole solid.
Point2 random_target(const Conforming<3>& c, SubFacet f, Random& random, bool is_far) {
  const Plane& plane = c.boundary.features().patches()[c.boundary.sub_facets()[f].owner].plane;
  Point2 low = plane.project(*c.boundary.corner_points(f)[0]);
  Point2 high = low;
  for (std::uint32_t v = 0; v < c.surface.points.size(); ++v) {
    const Point2 p = plane.project(c.complex().point(Vertex(v)));
    const auto corners = c.boundary.corner_points(f);
    const bool is_corner = std::any_of(corners.begin(), corners.end(),
                                       [&](const Point3* q) { return *q == c.complex().point(Vertex(v)); });
    if (!is_far && !is_corner) continue;
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  const double unit = std::ldexp(1.0, c.triangulation.gate().exponent());
  Point2 x;
  for (std::size_t k = 0; k < 2; ++k) {
    const double margin = is_far ? (high[k] - low[k]) / 4 : 0;
    x[k] = std::round(test::uniform(random, low[k] - margin, high[k] + margin) / unit) * unit;
  }
  return x;
}

void expect_invariants(const Conforming<3>& c) {
  test::expect_walls(c);
  test::expect_pieces(c, true);
}

TEST(PatchTriangulation, StaysATriangulationUnderRandomDivisionsAndFlips) {
  for (const auto& [name, surface] : integer_solids()) {
    SCOPED_TRACE(name);
    Conforming<3> c(surface);
    PatchTriangulation patches(c.boundary);
    expect_invariants(c);
    Random random(21);
    std::size_t divided = 0;
    std::size_t on_segments = 0;
    std::size_t flipped = 0;
    for (int step = 0; step < 120 && !testing::Test::HasFailure(); ++step) {
      SCOPED_TRACE(step);
      const SubFacet f = random_sub_facet(c, random);
      const std::uint32_t owner = c.boundary.sub_facets()[f].owner;
      std::vector<SubFacet> created;
      if (step % 3 == 0) {
        const std::size_t before = c.sub_facets().size();
        flipped += patches.flip(f, random() % 3, created) ? 1 : 0;
        ASSERT_EQ(c.sub_facets().size(), before);
      } else if (step % 3 == 1) {
        const Point2 x = random_target(c, f, random, false);
        const auto at = patches.walk(f, x);
        if (!at || at->barrier) continue;
        const Plane& plane = c.boundary.features().patches()[owner].plane;
        const Vertex v = c.insert(plane.lift(x), {{Kind::patch, owner}, 0, 1, 0});
        patches.divide(at->facet, at->side, v, created);
        ++divided;
      } else {
        const auto sub_segments = c.boundary.sub_segments(f);
        if (sub_segments.empty()) continue;
        const SubSegment s = sub_segments[random() % sub_segments.size()];
        const auto& features = c.boundary.features();
        const double t = (features.position(s.u, s.segment) + features.position(s.v, s.segment)) / 2;
        const std::size_t around = c.boundary.sub_facets().around(s.u, s.v).size();
        const std::size_t before = c.sub_facets().size();
        const Vertex v = c.insert(features.point_at(s.segment, t), {{Kind::segment, s.segment}, t, 1, 0});
        patches.divide(s, v, created);
        ASSERT_EQ(c.sub_facets().size(), before + around);
        ASSERT_EQ(c.boundary.sub_facets().segment_of(s.u, v), s.segment);
        ASSERT_EQ(c.boundary.sub_facets().segment_of(v, s.v), s.segment);
        ASSERT_TRUE(c.boundary.sub_facets().find_edge(s.u, s.v).is_null());
        ++on_segments;
      }
      for (const SubFacet made : created) {
        if (!c.boundary.sub_facets().is_alive(made)) continue;
        ASSERT_LT(c.boundary.sub_facets()[made].parent, surface.facets.size());
      }
      expect_invariants(c);
    }
    EXPECT_GT(divided, 3U);
    EXPECT_GT(on_segments, 5U);
    EXPECT_GT(flipped, 3U);
    ASSERT_TRUE(c.triangulation.validate().ok());
  }
}

TEST(PatchTriangulation, WalksEndWhereThePointIsOrAtASegmentThatBarsTheWay) {
  for (const auto& [name, surface] : integer_solids()) {
    SCOPED_TRACE(name);
    Conforming<3> c(surface);
    c.conformer.start();
    ASSERT_TRUE(c.conform());
    const PatchTriangulation patches(c.boundary);
    Random random(22);
    std::size_t found = 0;
    std::size_t barred = 0;
    for (int step = 0; step < 400; ++step) {
      const SubFacet f = random_sub_facet(c, random);
      const std::uint32_t owner = c.boundary.sub_facets()[f].owner;
      const Plane& plane = c.boundary.features().patches()[owner].plane;
      const Point2 x = random_target(c, f, random, step % 2 == 0);
      const auto at = patches.walk(f, x);
      const auto hold = holders(c, owner, x);
      const auto signs = [&](SubFacet g) {
        const auto& record = c.boundary.sub_facets()[g];
        std::array<Point2, 3> p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = plane.project(c.complex().point(record.corners[k]));
        std::array<int, 3> result;
        for (std::size_t k = 0; k < 3; ++k) {
          result[k] = sgn(test::exact_area2(p[(k + 1) % 3], p[(k + 2) % 3], x));
        }
        return result;
      };
      if (!at) {
        // A vertex of the patch.
        ASSERT_GT(hold.size(), 1U);
        const auto at_corner = signs(hold[0]);
        ASSERT_EQ(std::count(at_corner.begin(), at_corner.end(), 0), 2);
        continue;
      }
      ASSERT_EQ(c.boundary.sub_facets()[at->facet].owner, owner);
      const auto side = signs(at->facet);
      if (at->barrier) {
        ++barred;
        bool is_side = false;
        for (std::size_t k = 0; k < 3; ++k) {
          const auto& record = c.boundary.sub_facets()[at->facet];
          if (std::minmax(record.corners[(k + 1) % 3], record.corners[(k + 2) % 3]) !=
              std::minmax(at->barrier->u, at->barrier->v)) {
            continue;
          }
          is_side = true;
          ASSERT_EQ(record.segment[k], at->barrier->segment);
          ASSERT_LE(side[k], 0);
          // On the line of this side it must be on the side itself.
          if (side[k] == 0) {
            ASSERT_EQ(std::count(side.begin(), side.end(), -1), 0) << name;
          }
        }
        ASSERT_TRUE(is_side);
        continue;
      }
      ++found;
      ASSERT_NE(std::find(hold.begin(), hold.end(), at->facet), hold.end());
      ASSERT_EQ(std::count(side.begin(), side.end(), -1), 0);
      if (at->side == 3) {
        ASSERT_EQ(std::count(side.begin(), side.end(), 1), 3);
      } else {
        ASSERT_EQ(side[at->side], 0);
      }
    }
    EXPECT_GT(found, 50U);
    EXPECT_GT(barred, 10U);
  }
}

// A prism over a kite with the longer diagonal, which flips would take away.
TEST(PatchTriangulation, LeavesAloneWhatWasInTheListBefore) {
  Conforming<3> c(test::prism({{0, 0}, {3, -1}, {8, 0}, {3, 1}}, {{0, 1, 2}, {0, 2, 3}}, 1));
  PatchTriangulation patches(c.boundary);
  const Vertex bottom(0);
  const Vertex top(4);
  const std::uint32_t upright = c.boundary.sub_facets().segment_of(bottom, top);
  std::vector<SubFacet> created = c.sub_facets();
  const SubFacet kite = c.boundary.sub_facets().find_edge(bottom, Vertex(2));
  ASSERT_FALSE(kite.is_null());
  const Vertex v =
      c.insert(c.boundary.features().point_at(upright, 0.5), {{Kind::segment, upright}, 0.5, 1, 0});
  patches.divide({bottom, top, upright}, v, created);
  EXPECT_TRUE(c.boundary.sub_facets().is_alive(kite));
  EXPECT_FALSE(c.boundary.sub_facets().find_edge(bottom, Vertex(2)).is_null());
  EXPECT_TRUE(patches.flip_around(kite, created));
  EXPECT_TRUE(c.boundary.sub_facets().find_edge(bottom, Vertex(2)).is_null());
  EXPECT_FALSE(c.boundary.sub_facets().find_edge(Vertex(1), Vertex(3)).is_null());
  expect_invariants(c);
}

// The diagonals of a gridded cube run at random, those of the triangulation as ties are broken: flips alone
// bring all together.
TEST(PatchTriangulation, FlipsTurnTheDiagonalsOfAGridWithoutAPoint) {
  for (const int n : {1, 2, 3, 5, 8}) {
    for (const std::uint64_t seed : {1, 2}) {
      SCOPED_TRACE(n);
      const Surface3 surface = test::grid_cube(n, seed);
      Conforming<3> c(surface);
      std::size_t missing = 0;
      for (const SubFacet f : c.sub_facets()) missing += c.boundary.is_missing(f) ? 1 : 0;
      EXPECT_GT(missing, n > 2 ? 10U : 0U);
      PatchTriangulation(c.boundary).flip_all();
      for (const SubFacet f : c.sub_facets()) ASSERT_FALSE(c.boundary.is_missing(f));
      EXPECT_EQ(c.complex().num_vertices(), surface.points.size());
      expect_invariants(c);
      test::expect_conforming(c);
    }
  }
}

// Lawson: after flips from everywhere no side within a patch has the apex of one sub-facet in the sphere of the
// other.
TEST(PatchTriangulation, FlipsMakeEachPatchDelaunay) {
  for (const auto& [name, surface] : integer_solids()) {
    SCOPED_TRACE(name);
    Conforming<3> c(surface);
    PatchTriangulation patches(c.boundary);
    Random random(23);
    std::vector<SubFacet> created;
    for (int step = 0; step < 60; ++step) {
      const SubFacet f = random_sub_facet(c, random);
      const std::uint32_t owner = c.boundary.sub_facets()[f].owner;
      const Point2 x = random_target(c, f, random, false);
      const auto at = patches.walk(f, x);
      if (!at || at->barrier) continue;
      const Vertex v =
          c.insert(c.boundary.features().patches()[owner].plane.lift(x), {{Kind::patch, owner}, 0, 1, 0});
      patches.divide(at->facet, at->side, v, created);
    }
    for (int step = 0; step < 60; ++step) patches.flip(random_sub_facet(c, random), random() % 3, created);
    patches.flip_all();
    expect_invariants(c);
    for (const SubFacet f : c.sub_facets()) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (c.boundary.sub_facets()[f].segment[k] != SubFacets<3>::kNone) continue;
        const auto other = c.boundary.sub_facets().across(f, k);
        const Vertex apex = c.boundary.sub_facets()[other.facet].corners[other.k];
        EXPECT_GE(test::exact_diametral_side<3>(c.complex(), c.boundary.sub_facets()[f].corners, apex), 0);
      }
    }
  }
}

}  // namespace
}  // namespace sinkmesh
