// SPDX-License-Identifier: MIT
//
// The parts that models are made of, on simple shapes.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/vector.h"
#include "test/models/model_facts.h"
#include "tools/models/outline_simplifier.h"
#include "tools/models/planar_region.h"
#include "tools/models/surface_sampler.h"
#include "tools/models/tube.h"

namespace sinkmesh::test {
namespace {

using namespace models;

std::vector<Point2> regular_polygon(int n, double radius, bool clockwise = false) {
  std::vector<Point2> polygon;
  for (int i = 0; i < n; ++i) {
    // Not quite regular: nothing is cocircular.
    const double t = (clockwise ? -1 : 1) * 2 * std::numbers::pi * (i + 0.02 * std::sin(3 * i)) / n;
    polygon.push_back({radius * std::cos(t), radius * std::sin(t)});
  }
  return polygon;
}

double area(const Mesh2& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.simplices) {
    sum += cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]) / 2;
  }
  return sum;
}

TEST(MeshRegion, KeepsTheOutlineAndAddsAsManyPointsAsItIsTold) {
  const auto outer = regular_polygon(60, 1);
  const auto inner = regular_polygon(40, 0.4, true);
  const Mesh2 mesh = mesh_region(
      {outer, inner}, [](const Point2&) { return 1.0; }, 150);
  ASSERT_EQ(mesh.points.size(), 250U);
  for (std::size_t i = 0; i < 60; ++i) EXPECT_EQ(mesh.points[i], outer[i]);
  for (std::size_t i = 0; i < 40; ++i) EXPECT_EQ(mesh.points[60 + i], inner[i]);
  // Euler's formula for an annulus.
  EXPECT_EQ(mesh.simplices.size(), 100U + 2 * 150U);
  double expected = 0;
  for (const auto& loop : {outer, inner}) {
    for (std::size_t i = 0; i < loop.size(); ++i) expected += cross(loop[i], loop[(i + 1) % loop.size()]) / 2;
  }
  EXPECT_NEAR(area(mesh), expected, 1e-12);
}

TEST(MeshRegion, GradesAsTheSizeSays) {
  const Mesh2 mesh = mesh_region(
      {regular_polygon(40, 1)}, [](const Point2& p) { return 0.1 + std::hypot(p[0], p[1]); }, 300);
  std::size_t near_center = 0;
  for (const Point2& p : mesh.points) near_center += std::hypot(p[0], p[1]) < 0.25 ? 1 : 0;
  EXPECT_GT(near_center, 100U);
}

TEST(MeshRegion, StopsWhenThereIsNoRoom) {
  const Mesh2 mesh = mesh_region(
      {regular_polygon(6, 1)}, [](const Point2&) { return 1.0; }, 1000);
  EXPECT_LT(mesh.points.size(), 20U);
}

TEST(MeshRegion, RefusesAnOutlineThatIsNotDelaunay) {
  // Points close to the middle of the long segment, on either side.
  const std::vector<Point2> flat = {{-10, 0}, {10, 0}, {0, 0.1}};
  const std::vector<Point2> below = {{0, -0.1}, {-1, -5}, {1, -5}};
  EXPECT_THROW(mesh_region(
                   {flat, below}, [](const Point2&) { return 1.0; }, 0),
               std::logic_error);
}

TEST(Tube, HasAsManyFacetsAsItSays) {
  const auto side = [](Point2 a, Point2 b) {
    return [=](double t, double) { return Point2{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])}; };
  };
  const std::vector<Point2> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const int segments : {1, 2, 3, 8}) {
    std::vector<SectionPiece> section;
    for (std::size_t i = 0; i < 4; ++i) {
      section.push_back({side(square[i], square[(i + 1) % 4]), 1.0, segments});
    }
    for (const int rows : {4, 5}) {
      const Tube tube = make_tube(section, true, 2, rows);
      EXPECT_EQ(tube.facets.size(), tube_facets(section, true, rows));
      EXPECT_EQ(tube.bottom.size(), 4U * static_cast<unsigned>(segments));
      for (const std::uint32_t v : tube.bottom) EXPECT_EQ(tube.points[v][2], 0);
      for (const std::uint32_t v : tube.top) EXPECT_EQ(tube.points[v][2], 2);
      double flux = 0;  // of (x, y, 0) through the sides: twice the volume
      for (const auto& [a, b, c] : tube.facets) {
        const Point3& p = tube.points[a];
        const Point3 normal = cross(tube.points[b] - p, tube.points[c] - p);
        Point3 middle{};
        for (const std::uint32_t v : {a, b, c}) {
          for (std::size_t k = 0; k < 2; ++k) middle[k] += tube.points[v][k] / 3;
        }
        flux += dot(middle, normal) / 2;
      }
      EXPECT_NEAR(flux, 4, 1e-9);
    }
  }
}

TEST(SimplifyOutline, EndsWithGoodEdgesOnTheCurve) {
  // A comb: sharp teeth, close together.
  std::vector<Point2> comb = {{0, -1}, {10, -1}};
  for (int i = 0; i < 10; ++i) {
    const double x = 10 - i;
    comb.push_back({x, 0});
    comb.push_back({x - 0.45, 1.5 + 0.1 * std::sin(i)});
    comb.push_back({x - 0.9, 0.1});
  }
  for (const std::size_t vertices : {80, 120, 200}) {
    Surface2 surface;
    surface.points = simplify_outline(comb, vertices);
    EXPECT_LE(surface.points.size(), vertices);
    const auto n = static_cast<std::uint32_t>(surface.points.size());
    for (std::uint32_t i = 0; i < n; ++i) surface.facets.push_back({i, (i + 1) % n});
    const ModelFacts<2> facts = facts_of(surface);
    EXPECT_EQ(facts.missing_facets, 0U);
    EXPECT_EQ(facts.peeled, 0U);
    EXPECT_EQ(facts.circumcenters_outside, 0U);
  }
}

class UnitBall final : public ImplicitSolid {
 public:
  double value(const Point3& p) const override { return dot(p, p) - 1; }
  double size(const Point3&) const override { return 1; }
  double max_ratio() const override { return 1.2; }
  Point3 onto(const Point3& p) const override {
    const double r = std::sqrt(dot(p, p));
    return {p[0] / r, p[1] / r, p[2] / r};
  }
  std::vector<Point3> seeds(std::size_t) const override {
    return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  }
  bool is_clear_of_edges(const Point3&, std::size_t) const override { return true; }
  bool is_centrally_symmetric() const override { return false; }
};

// All points cospherical up to rounding: the worst there is for circumcenters.
TEST(SampleSurface, CoversABallEvenly) {
  const Surface3 surface = sample_surface(UnitBall(), 1000);
  EXPECT_EQ(surface.facets.size(), 1000U);
  const ModelFacts<3> facts = facts_of(surface);
  EXPECT_TRUE(facts.defects.empty());
  EXPECT_EQ(facts.missing_facets, 0U);
  EXPECT_EQ(facts.peeled, 0U);
  EXPECT_NEAR(facts.summary.signed_volume, 4 * std::numbers::pi / 3, 0.06);
  EXPECT_LT(facts.surface.max, 1.5);
}

}  // namespace
}  // namespace sinkmesh::test
