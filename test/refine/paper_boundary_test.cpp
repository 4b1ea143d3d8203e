// SPDX-License-Identifier: MIT
//
// The boundary of the paper's models, divided where that is needed: what that mends, and what it takes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "core/vector.h"
#include "refine/refine.h"
#include "tools/io/read.h"

namespace sinkmesh {
namespace {

Surface3 model(const std::string& name) {
  return read_surface(std::string(SINKMESH_TEST_MODELS) + "/" + name + ".off");
}

RefineResult refine_model(SurfaceMesher3& mesher, Insert insert, BoundaryMode mode, double small_angle) {
  RefineOptions options;
  options.insert = insert;
  options.boundary.mode = mode;
  options.boundary.small_angle = small_angle;
  options.max_vertices = 100000;  // so that a run that does not end fails
  EXPECT_TRUE(mesher.find_domain(options).ok());
  return mesher.refine(options);
}

struct Limit {
  const char* model;
  double tetrahedra;
  std::size_t boundary_points;
};
// The tetrahedra of sinks within a boundary that is kept, which leaves 141 and 358 of low quality, and a little
// more.
constexpr Limit kLimits[] = {{"star", 1.25 * 118902, 150}, {"head", 1.15 * 196776, 450}};

void PrintTo(const Limit& limit, std::ostream* out) { *out << limit.model; }

constexpr Insert kInserts[] = {Insert::off_sink, Insert::sink, Insert::circumcenter};

class SmallAngles : public testing::TestWithParam<std::tuple<Limit, Insert>> {};

// A center gives way to the boundary, and only where it cannot is the boundary divided.
TEST_P(SmallAngles, OfSeventeenDegreesLeaveNothing) {
  const auto& [limit, insert] = GetParam();
  const Surface3 surface = model(limit.model);
  SurfaceMesher3 mesher(surface);
  const RefineResult result = refine_model(mesher, insert, BoundaryMode::refine, 17);
  EXPECT_EQ(result.stop, Stop::no_candidate);
  EXPECT_EQ(result.remaining.total(), 0U);
  EXPECT_LE(static_cast<double>(mesher.statistics(2).simplices()), limit.tetrahedra);
  EXPECT_LE(result.points_on_segments + result.points_on_patches, limit.boundary_points);
  EXPECT_GT(result.points_on_segments + result.points_on_patches, 0U);

  // Points that gave way lie a little out of the diametral sphere of a sub-facet, which they see.
  const Complex<3>& complex = mesher.triangulation().complex();
  std::size_t withdrawn = 0;
  for (const HalfFacet h : mesher.domain().boundary()) {
    const Vertex apex = complex.apex(h);
    if (apex.index() < surface.points.size()) continue;
    const FacetCorners<3> corners = complex.facet_corners(h);
    const Point3 center = facet_center<3>(corners);
    const double out = squared_distance(complex.point(apex), center) / facet_shape<3>(corners).radius2 - 1;
    EXPECT_GE(out, -1e-9);
    withdrawn += std::abs(out - 0x1p-19) < 1e-9 ? 1 : 0;
  }
  EXPECT_GT(withdrawn, 20U);
}

INSTANTIATE_TEST_SUITE_P(PaperModels, SmallAngles,
                         testing::Combine(testing::ValuesIn(kLimits), testing::ValuesIn(kInserts)),
                         [](const auto& combination) {
                           return std::string(std::get<0>(combination.param).model) + "_" +
                                  name(std::get<1>(combination.param));
                         });

class AllModels : public testing::TestWithParam<std::tuple<const char*, Insert, int>> {};

TEST_P(AllModels, NoAngleLeavesMoreThanAFixedBoundary) {
  const auto& [name, insert, small_angle] = GetParam();
  const Surface3 surface = model(name);
  SurfaceMesher3 fixed(surface);
  const std::size_t left = refine_model(fixed, insert, BoundaryMode::fixed, small_angle).remaining.total();
  SurfaceMesher3 mesher(surface);
  const RefineResult result = refine_model(mesher, insert, BoundaryMode::refine, small_angle);
  EXPECT_EQ(result.stop, Stop::no_candidate);
  EXPECT_LE(result.remaining.total(), left);
  // The floor is 2^-30 of the diagonal, and no two vertices of these models are nearly as close.
  const Complex<3>& complex = mesher.triangulation().complex();
  double shortest2 = HUGE_VAL;
  for (const Simplex s : complex.simplices()) {
    if (!complex.is_ghost(s)) shortest2 = std::min(shortest2, shape<3>(complex.corners(s)).shortest2);
  }
  EXPECT_GE(std::ldexp(std::sqrt(shortest2), -mesher.triangulation().gate().exponent()), result.separation);
}

INSTANTIATE_TEST_SUITE_P(PaperModels, AllModels,
                         testing::Combine(testing::Values("cuboctahedron", "paraboloid", "star", "head"),
                                          testing::ValuesIn(kInserts), testing::Values(20, 29)),
                         [](const auto& combination) {
                           return std::string(std::get<0>(combination.param)) + "_" +
                                  name(std::get<1>(combination.param)) + "_" +
                                  std::to_string(std::get<2>(combination.param));
                         });

}  // namespace
}  // namespace sinkmesh
