// SPDX-License-Identifier: MIT
//
// Taking points away again [OS, 3]: off-sinks leave hardly any that the mesh can do without, sinks many.
#include "refine/coarsener.h"

#include <gtest/gtest.h>

#include <algorithm>
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

struct Coarsened {
  std::size_t inserted;
  Improvement improvement;
};

// With everything that must hold of the result.
template <int Dim>
Coarsened coarsen(const Surface<Dim>& surface, const RefineOptions& options) {
  SurfaceMesher<Dim> mesher(surface);
  mesher.find_domain(options);
  Coarsened result{mesher.refine(options).inserted, {}};
  const MeshState<Dim> before(mesher, options.max_ratio);
  result.improvement = mesher.improve(options);
  const MeshState<Dim> after(mesher, options.max_ratio);
  expect_improved(surface, before, after, result.improvement);
  EXPECT_TRUE(mesher.triangulation().validate().ok()) << mesher.triangulation().validate();
  for (std::size_t i = 0; i < AngleCensus::kSmall.size(); ++i) {
    EXPECT_LE(after.check.angles.below(i), before.check.angles.below(i));
  }
  EXPECT_GE(after.check.quality.min_angle(), std::min(15.0, before.check.quality.min_angle()));
  return result;
}

TEST(Coarsener, TakesAwayLessThanOneInAHundredOfTheOffSinks) {
  for (const char* name : {"cuboctahedron", "paraboloid"}) {
    RefineOptions options;
    options.coarsen = true;
    const Coarsened result = coarsen(model(name), options);
    EXPECT_LT(100 * result.improvement.coarsening.removed, result.inserted) << name;
    EXPECT_GE(result.improvement.coarsening.tried, result.inserted) << name;
    EXPECT_EQ(result.improvement.stop(), Stop::no_candidate);
  }
}

TEST(Coarsener, TakesAwayMoreThanOneInTwentyOfTheSinks) {
  RefineOptions options;
  options.coarsen = true;
  options.insert = Insert::sink;
  const Coarsened result = coarsen(model("cuboctahedron"), options);
  EXPECT_GT(20 * result.improvement.coarsening.removed, result.inserted);
}

TEST(Coarsener, EndsAtOnceIfABudgetIsSpent) {
  RefineOptions options;
  options.insert = Insert::sink;
  SurfaceMesher3 mesher(model("paraboloid"));
  mesher.find_domain();
  mesher.refine(options);
  const std::uint64_t hash = mesher.hash();
  options.coarsen = options.slivers = true;
  options.max_vertices = 0;
  const Improvement improvement = mesher.improve(options);
  EXPECT_EQ(improvement.stop(), Stop::budget);
  EXPECT_EQ(improvement.coarsening.tried, 0U);
  EXPECT_EQ(mesher.hash(), hash);
}

// Work that a limit ends is taken back: to the vertices that were there, less those that had been taken away.
TEST(Coarsener, WhatHasGoneDoesNotComeBackWhenWorkIsTakenBack) {
  RefineOptions options;
  options.boundary.mode = BoundaryMode::refine;
  options.insert = Insert::sink;
  options.coarsen = true;
  const Surface3 surface = ellipsoid_surface(3, {1, 0.9, 0.15}, 1e-2);
  SurfaceMesher3 mesher(surface);
  ASSERT_TRUE(mesher.find_domain(options).ok());
  ASSERT_EQ(mesher.refine(options).stop, Stop::no_candidate);
  EXPECT_GT(mesher.improve(options).coarsening.removed, 0U);
  std::size_t taken_back = 0;
  for (options.max_ratio = 1.6; options.max_ratio > 1; options.max_ratio -= 0.01) {
    const std::size_t vertices = mesher.num_vertices();
    options.max_vertices = vertices + 7;
    const RefineResult result = mesher.refine(options);
    taken_back += result.stop == Stop::budget && mesher.num_vertices() < options.max_vertices ? 1 : 0;
    EXPECT_EQ(mesher.num_vertices(), vertices + result.inserted);
    ASSERT_TRUE(mesher.triangulation().validate().ok()) << mesher.triangulation().validate();
    const MeshCheck<3> check = check_mesh(mesher.mesh());
    EXPECT_TRUE(check.is_delaunay());
    EXPECT_EQ(check.unstable_facets, 0U);
    EXPECT_EQ(check.unused_points, 0U);
  }
  EXPECT_GT(taken_back, 0U);
}

template <class T>
class CoarsenerTest : public testing::Test {};
TYPED_TEST_SUITE(CoarsenerTest, PlaneAndSpace, DimensionName);

TYPED_TEST(CoarsenerTest, MakesNothingWorseWithinADividedBoundary) {
  constexpr int kDim = TypeParam::value;
  std::size_t removed = 0;
  for (const auto& named : boundary_surfaces<kDim>()) {
    SCOPED_TRACE(named.name);
    RefineOptions options;
    options.boundary.mode = BoundaryMode::refine;
    options.max_ratio = kDim == 2 ? 1 : 1.5;
    options.insert = Insert::circumcenter;
    options.max_vertices = 4000;
    options.coarsen = true;
    SurfaceMesher<kDim> probe(named.surface);
    if (!probe.find_domain(options).ok() || probe.refine(options).stop != Stop::no_candidate) continue;
    removed += coarsen(named.surface, options).improvement.coarsening.removed;
  }
  EXPECT_GT(removed, 5U);
}

}  // namespace
}  // namespace sinkmesh
