// SPDX-License-Identifier: MIT
//
// Moving and picking [OS, 3]: what gets better, and what must not get worse.
#include "refine/sliver_mover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "refine/refine.h"
#include "test/support/boundary_surfaces.h"
#include "test/support/dimensions.h"
#include "test/support/mesh_state.h"
#include "test/support/surfaces.h"
#include "tools/io/read.h"

namespace sinkmesh {
namespace {

using namespace test;

Surface3 model(const std::string& name) {
  return read_surface(std::string(SINKMESH_TEST_MODELS) + "/" + name + ".off");
}

RefineOptions sliver_options(double max_ratio) {
  RefineOptions options;
  options.max_ratio = max_ratio;
  options.slivers = true;
  return options;
}

template <int Dim>
std::int64_t total_cost(const Mesh<Dim>& mesh, const RefineOptions& options) {
  const SliverCost<Dim> cost(options.min_dihedral, options.max_ratio);
  std::int64_t sum = 0;
  for (const auto& simplex : mesh.simplices) {
    Corners<Dim> corners;
    for (std::size_t i = 0; i <= Dim; ++i) corners[i] = &mesh.points[simplex[i]];
    sum += cost(corners);
  }
  return sum;
}

// Each sliver of the mesh, and nothing else, is listed, with a reason that holds.
template <int Dim>
void expect_slivers(const SurfaceMesher<Dim>& mesher, const MeshState<Dim>& state, double min_angle) {
  std::set<std::uint32_t> on_boundary;
  for (const auto& facet : state.mesh.boundary) on_boundary.insert(facet.begin(), facet.end());
  std::set<std::array<std::uint32_t, Dim + 1>> expected;
  for (auto simplex : state.mesh.simplices) {
    Corners<Dim> corners;
    for (std::size_t i = 0; i <= Dim; ++i) corners[i] = &state.mesh.points[simplex[i]];
    if (angles<Dim>(corners).min >= min_angle) continue;
    std::sort(simplex.begin(), simplex.end());
    expected.insert(simplex);
  }
  double least = 0;
  for (const Sliver<Dim>& sliver : mesher.slivers()) {
    auto corners = sliver.corners;
    std::sort(corners.begin(), corners.end());
    EXPECT_EQ(expected.erase(corners), 1U);
    EXPECT_GE(sliver.angle, least);
    least = sliver.angle;
    const bool is_on_boundary =
        std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return on_boundary.contains(v); });
    EXPECT_EQ(sliver.reason == SliverReason::boundary_vertices, is_on_boundary);
    EXPECT_NE(sliver.reason, SliverReason::untried);
  }
  EXPECT_TRUE(expected.empty());
}

TEST(SliverMover, LeavesNoInnerSliverInTheCuboctahedronAndNoMoreTetrahedra) {
  const Surface3 surface = model("cuboctahedron");
  SurfaceMesher3 mesher(surface);
  mesher.find_domain();
  const RefineOptions options = sliver_options(2);
  mesher.refine(options);
  const MeshState<3> before(mesher, 2);
  EXPECT_EQ(mesher.angle_census().below(0), before.check.angles.below(0));
  EXPECT_GT(before.check.angles.below(0), 100U);
  const Improvement improvement = mesher.improve(options);
  const MeshState<3> after(mesher, 2);
  expect_improved(surface, before, after, improvement);
  expect_slivers(mesher, after, 15);
  EXPECT_TRUE(mesher.triangulation().validate().ok()) << mesher.triangulation().validate();
  EXPECT_EQ(before.centers_outside, 0U);
  EXPECT_LE(after.check.angles.below(0), 40U);
  EXPECT_EQ(after.check.angles.inner_below(1), 0U);
  EXPECT_EQ(mesher.angle_census().histogram(), after.check.angles.histogram());
  EXPECT_EQ(improvement.moving.stop, Stop::no_candidate);
  EXPECT_GT(improvement.moving.moved, 100U);
  EXPECT_GT(improvement.moving.inserted, 10U);
  EXPECT_EQ(improvement.moving.cost_before, total_cost(before.mesh, options));
  EXPECT_EQ(improvement.moving.cost_after, total_cost(after.mesh, options));
  EXPECT_LT(improvement.moving.cost_after, improvement.moving.cost_before);
}

template <class T>
class SliverMoverTest : public testing::Test {};
TYPED_TEST_SUITE(SliverMoverTest, PlaneAndSpace, DimensionName);

// In the plane a bound on r/l of 1 means 30 degrees: slivers are asked for beyond that.
template <int Dim>
RefineOptions demanding_options() {
  RefineOptions options = sliver_options(Dim == 2 ? 1.0 : 1.5);
  options.min_dihedral = Dim == 2 ? 35 : 18;
  return options;
}

TYPED_TEST(SliverMoverTest, MakesNothingWorseWithinADividedBoundary) {
  constexpr int kDim = TypeParam::value;
  std::size_t moved = 0;
  for (const auto& named : boundary_surfaces<kDim>()) {
    SCOPED_TRACE(named.name);
    RefineOptions options = demanding_options<kDim>();
    options.boundary.mode = BoundaryMode::refine;
    options.max_vertices = 4000;
    SurfaceMesher<kDim> mesher(named.surface);
    if (!mesher.find_domain(options).ok() || mesher.refine(options).stop != Stop::no_candidate) continue;
    const MeshState<kDim> before(mesher, options.max_ratio);
    const Improvement improvement = mesher.improve(options);
    const MeshState<kDim> after(mesher, options.max_ratio);
    expect_improved(named.surface, before, after, improvement);
    expect_slivers(mesher, after, options.min_dihedral);
    EXPECT_EQ(improvement.moving.cost_after, total_cost(after.mesh, options));
    EXPECT_LE(improvement.moving.cost_after, improvement.moving.cost_before);
    EXPECT_EQ(mesher.leftovers().size(), improvement.remaining.total());
    moved += improvement.moving.moved;
    // The mesh can be worked on: all that is known of it is still true.
    mesher.refine(options);
    const MeshState<kDim> again(mesher, options.max_ratio);
    EXPECT_TRUE(again.check.is_delaunay());
    EXPECT_EQ(again.check.unstable_facets, 0U);
  }
  EXPECT_GT(moved, 100U);
}

// Of low quality are some that nothing can mend; there must not be more, nor worse ones.
TEST(SliverMover, KeepsTheReasonsOfWhatStaysOfLowQuality) {
  const Surface3 surface = model("paraboloid");
  SurfaceMesher3 mesher(surface);
  mesher.find_domain();
  const RefineOptions options = sliver_options(1);
  const RefineResult refined = mesher.refine(options);
  const MeshState<3> before(mesher, 1);
  const Improvement improvement = mesher.improve(options);
  const MeshState<3> after(mesher, 1);
  expect_improved(surface, before, after, improvement);
  EXPECT_LT(after.check.quality.low_quality(), refined.remaining.total());
  const auto leftovers = mesher.leftovers();
  EXPECT_EQ(leftovers.size(), improvement.remaining.total());
  for (const auto& leftover : leftovers) {
    Corners<3> corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = &after.mesh.points[leftover.corners[i]];
    EXPECT_DOUBLE_EQ(leftover.ratio, std::sqrt(shape<3>(corners).ratio2()));
    EXPECT_GT(leftover.ratio, 1);
  }
}

// Numbers of vertices and facets must not count; neither must what stood in memory before.
TYPED_TEST(SliverMoverTest, DependsOnTheGeometryOnly) {
  constexpr int kDim = TypeParam::value;
  const auto surfaces = boundary_surfaces<kDim>();
  Random random(11);
  for (std::size_t i = 0; i < 3; ++i) {
    const Surface<kDim>& surface = surfaces[surfaces.size() - 1 - i].surface;
    SCOPED_TRACE(surfaces[surfaces.size() - 1 - i].name);
    std::set<std::uint64_t> hashes;
    std::set<std::size_t> moved;
    for (const Surface<kDim>& variant : {surface, surface, in_another_order(surface, random)}) {
      RefineOptions options = demanding_options<kDim>();
      options.boundary.mode = BoundaryMode::refine;
      options.coarsen = true;
      options.insert = Insert::sink;
      options.max_vertices = 4000;
      SurfaceMesher<kDim> mesher(variant);
      ASSERT_TRUE(mesher.find_domain(options).ok());
      mesher.refine(options);
      moved.insert(mesher.improve(options).moving.moved);
      hashes.insert(mesher.hash());
    }
    EXPECT_EQ(hashes.size(), 1U);
    EXPECT_EQ(moved.size(), 1U);
  }
}

TEST(SliverMover, IsDoneWhenItHasRunTwice) {
  SurfaceMesher3 mesher(ellipsoid_surface(3, {1, 1.2, 0.8}, 2e-3));
  mesher.find_domain();
  const RefineOptions options = sliver_options(1.3);
  mesher.refine(options);
  const Improvement first = mesher.improve(options);
  EXPECT_GT(first.moving.moved, 0U);
  const Improvement second = mesher.improve(options);
  EXPECT_EQ(second.moving.cost_before, first.moving.cost_after);
  EXPECT_LE(second.moving.cost_after, second.moving.cost_before);
}

TEST(SliverMover, EndsAtOnceIfABudgetIsSpentOrOnRequest) {
  const Surface3 surface = model("cuboctahedron");
  RefineOptions options = sliver_options(2);
  SurfaceMesher3 mesher(surface);
  mesher.find_domain();
  mesher.refine(options);
  const std::uint64_t hash = mesher.hash();

  options.max_vertices = 0;
  Improvement improvement = mesher.improve(options);
  EXPECT_EQ(improvement.stop(), Stop::budget);
  EXPECT_EQ(improvement.moving.tried, 0U);
  EXPECT_EQ(mesher.hash(), hash);
  EXPECT_GT(mesher.slivers().size(), 100U);
  for (const auto& sliver : mesher.slivers()) {
    EXPECT_NE(sliver.reason, SliverReason::no_better_place);
  }

  options.max_vertices = RefineOptions().max_vertices;
  int polls = 0;
  options.should_continue = [&] { return ++polls > 2 ? Continue::cancelled : Continue::yes; };
  const MeshState<3> before(mesher, 2);
  improvement = mesher.improve(options);
  EXPECT_EQ(improvement.stop(), Stop::cancelled);
  EXPECT_GT(improvement.moving.moved, 0U);
  expect_improved(surface, before, MeshState<3>(mesher, 2), improvement);
}

TEST(SliverMover, RefusesAnAngleThatNoMeshCanHave) {
  SurfaceMesher3 mesher(ellipsoid_surface(1, {1, 1, 1}, 1e-3));
  mesher.find_domain();
  for (const double angle : {0.0, -1.0, 46.0, std::nan("")}) {
    RefineOptions options = sliver_options(2);
    options.min_dihedral = angle;
    EXPECT_THROW(mesher.improve(options), InputError);
  }
}

TEST(SliverMover, OneCallRefinesAndMoves) {
  const Surface3 surface = ellipsoid_surface(3, {1, 1.2, 0.8}, 2e-3);
  const RefineOptions options = sliver_options(1.3);
  SurfaceMesher3 mesher(surface);
  mesher.find_domain(options);
  mesher.refine(options);
  mesher.improve(options);
  EXPECT_EQ(refine(surface, options).simplices, mesher.mesh().simplices);
}

}  // namespace
}  // namespace sinkmesh
