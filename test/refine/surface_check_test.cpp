// SPDX-License-Identifier: MIT
#include "refine/surface_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "refine/self_intersections.h"
#include "test/support/surfaces.h"

namespace sinkmesh::test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using Kind = SurfaceDefectKind;

template <int Dim>
std::vector<Kind> kinds(const Surface<Dim>& surface, SurfaceChecks checks = SurfaceChecks::all) {
  std::vector<Kind> result;
  for (const SurfaceDefect& defect : check_surface(surface, checks)) result.push_back(defect.kind);
  return result;
}

Surface3 unit_box() { return box_surface({0, 0, 0}, {1, 1, 1}); }

// Points of a square, and segments.
Surface2 segments(std::vector<Surface2::Facet> facets) {
  return {{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {8, 8}}, std::move(facets)};
}

TEST(CheckSurface, FindsNothingInABox) { EXPECT_THAT(check_surface(unit_box()), IsEmpty()); }

TEST(CheckSurface, FindsEveryErrorOfSpace) {
  Surface3 box = unit_box();
  box.facets.pop_back();
  EXPECT_THAT(kinds(box), AllOf(SizeIs(3), Each(Kind::open_edge)));

  box = unit_box();
  box.facets.push_back(box.facets.front());
  EXPECT_THAT(kinds(box), ElementsAre(Kind::duplicate_facet, Kind::nonmanifold_edge, Kind::nonmanifold_edge,
                                      Kind::nonmanifold_edge));

  box = unit_box();
  std::swap(box.facets[5][0], box.facets[5][1]);
  EXPECT_THAT(kinds(box), AllOf(SizeIs(3), Each(Kind::inconsistent_orientation)));

  box = unit_box();
  box.points[0][2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(kinds(box), ElementsAre(Kind::not_finite));

  box = unit_box();
  box.points[0] = box.points[1];
  EXPECT_EQ(kinds(box)[0], Kind::degenerate_facet);
  EXPECT_EQ(kinds(box)[2], Kind::duplicate_vertex);
}

TEST(CheckSurface, FindsSelfIntersectionsUnlessToldNotTo) {
  const Surface3 crossing = join(unit_box(), box_surface({0.5, 0.5, 0.5}, {2, 2, 2}));
  const auto pairs = self_intersections(crossing);
  const auto defects = check_surface(crossing);
  ASSERT_FALSE(pairs.empty());
  ASSERT_EQ(defects.size(), pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(defects[i].kind, Kind::self_intersection);
    EXPECT_THAT(defects[i].facets, ElementsAre(pairs[i].first, pairs[i].second));
    EXPECT_TRUE(std::is_sorted(defects[i].vertices.begin(), defects[i].vertices.end()));
    EXPECT_THAT(defects[i].message, AllOf(HasSubstr(" intersect: vertex "), HasSubstr("(0.5, ")));
  }
  EXPECT_EQ(severity(Kind::self_intersection), SurfaceSeverity::error);
  EXPECT_EQ(name_of(Kind::self_intersection), "self-intersection");
  EXPECT_THAT(check_surface(crossing, SurfaceChecks::without_intersections), IsEmpty());
}

// Two boxes that share a side: three facets at each of its edges.
TEST(CheckSurface, TakesAWallBetweenRegionsForNoError) {
  Surface3 box = unit_box();
  const Surface3 second = box_surface({1, 0, 0}, {2, 1, 1});
  for (std::uint32_t v = 4; v < 8; ++v) box.points.push_back(second.points[v]);
  for (std::size_t f = 0; f < second.facets.size(); ++f) {
    if (f < 2) continue;  // the common side, of the corners that both have
    auto facet = second.facets[f];
    for (std::uint32_t& v : facet) v += 4;
    box.facets.push_back(facet);
  }
  const auto defects = check_surface(box);
  EXPECT_THAT(defects, SizeIs(4));
  for (const SurfaceDefect& defect : defects) {
    EXPECT_EQ(defect.kind, Kind::nonmanifold_edge);
    EXPECT_THAT(defect.facets, SizeIs(3));
  }
  EXPECT_EQ(severity(Kind::nonmanifold_edge), SurfaceSeverity::note);
}

TEST(CheckSurface, TakesPartsThatTouchForNoError) {
  Surface3 touching = join(unit_box(), box_surface({1, 1, 1}, {2, 2, 2}));
  EXPECT_THAT(kinds(touching), ElementsAre(Kind::duplicate_vertex));
  for (auto& facet : touching.facets) {
    for (std::uint32_t& v : facet) v = v == 8 ? 7 : v;
  }
  // Where the unused one lies does not matter.
  EXPECT_THAT(kinds(touching), ElementsAre(Kind::nonmanifold_vertex, Kind::unused_vertex));
  touching.points[8] = {3, 3, 3};
  EXPECT_THAT(kinds(touching), ElementsAre(Kind::nonmanifold_vertex, Kind::unused_vertex));
  EXPECT_EQ(severity(Kind::nonmanifold_vertex), SurfaceSeverity::note);
  EXPECT_THAT(kinds(reversed(touching)),
              ElementsAre(Kind::nonmanifold_vertex, Kind::unused_vertex, Kind::inside_out));
}

TEST(CheckSurface, TellsInsideOutWhereverThereIsAVolume) {
  EXPECT_THAT(kinds(reversed(unit_box())), ElementsAre(Kind::inside_out));
  const Surface3 crossing = join(unit_box(), box_surface({0.5, 0.5, 0.5}, {2, 2, 2}));
  EXPECT_EQ(kinds(reversed(crossing)).back(), Kind::inside_out);
  EXPECT_THAT(kinds(reversed(crossing), SurfaceChecks::without_intersections), ElementsAre(Kind::inside_out));
  Surface3 open = reversed(unit_box());
  open.facets.pop_back();
  EXPECT_THAT(kinds(open), Not(Contains(Kind::inside_out)));
}

TEST(CheckSurface, AcceptsPlanarGraphs) {
  const auto square = segments({{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  EXPECT_THAT(kinds(square), ElementsAre(Kind::unused_vertex, Kind::unused_vertex));
  const auto diagonal = segments({{0, 1}, {1, 2}, {2, 3}, {3, 0}, {1, 3}, {0, 4}, {2, 5}});
  EXPECT_THAT(kinds(diagonal),
              ElementsAre(Kind::nonmanifold_edge, Kind::nonmanifold_edge, Kind::nonmanifold_edge,
                          Kind::nonmanifold_edge, Kind::dangling_end, Kind::dangling_end));
  for (const SurfaceDefect& defect : check_surface(diagonal)) {
    EXPECT_EQ(severity(defect.kind), SurfaceSeverity::note);
  }
  EXPECT_EQ(name_of(Kind::dangling_end), "dangling end");
  EXPECT_THAT(
      kinds(segments({{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}})),
      ElementsAre(Kind::self_intersection, Kind::self_intersection, Kind::dangling_end, Kind::dangling_end));
}

}  // namespace
}  // namespace sinkmesh::test
