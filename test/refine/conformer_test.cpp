// SPDX-License-Identifier: MIT
#include "refine/conformer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "refine/parents.h"
#include "test/support/boundary_surfaces.h"
#include "test/support/conformed.h"
#include "test/support/dimensions.h"

namespace sinkmesh {
namespace {

using test::Conforming;

template <class T>
class Conform : public testing::Test {};
TYPED_TEST_SUITE(Conform, test::PlaneAndSpace, test::DimensionName);

// In the units of the input.
template <int Dim>
double inside_of(const Conforming<Dim>& c) {
  const double factor = std::ldexp(1.0, -Dim * c.triangulation.gate().exponent());
  return test::exact_inside(c.complex(), c.domain).get_d() * factor / (Dim == 2 ? 2 : 6);
}

TYPED_TEST(Conform, EverySurfaceBecomesDelaunayAndKeepsItsShape) {
  constexpr int kDim = TypeParam::value;
  for (const auto& [name, surface, measure, is_exact] : test::boundary_surfaces<kDim>()) {
    for (const bool projects : {true, false}) {
      SCOPED_TRACE(name + (projects ? "" : ", middles"));
      Conforming<kDim> c(surface, projects);
      c.conformer.start();
      ASSERT_TRUE(c.conform());
      EXPECT_TRUE(c.conformer.unconformed().empty());
      test::expect_conforming(c);
      test::expect_walls(c);
      test::expect_pieces(c, is_exact);
      test::expect_places(c);
      const std::size_t points = c.conformer.points_on_segments() + c.conformer.points_on_patches();
      EXPECT_EQ(c.complex().num_vertices(), surface.points.size() + points);
      c.label();
      if (is_exact) {
        EXPECT_EQ(inside_of(c), measure);
      } else {
        EXPECT_NEAR(inside_of(c), measure, 1e-12 * std::max(measure, 1.0));
      }
    }
  }
}

// Ties everywhere, and nothing to be done.
TEST(Conformer, GridCubesNeedNoPointAndARightTetrahedronOne) {
  for (const auto& [name, surface, measure, is_exact] : test::boundary_solids()) {
    if (name.find("cube") == std::string::npos && name != "tetrahedron") continue;
    if (name == "nested cubes") continue;
    SCOPED_TRACE(name);
    Conforming<3> c(surface);
    c.conformer.start();
    ASSERT_TRUE(c.conform());
    EXPECT_EQ(c.complex().num_vertices(), surface.points.size() + (name == "tetrahedron" ? 1 : 0));
  }
}

// Pieces whose center lies outside their parent, of the patches with a single facet or of the others; parents
// in another patch count everywhere.
template <int Dim>
std::size_t astray(const Conforming<Dim>& c, bool in_single) {
  std::map<std::uint32_t, std::size_t> facets_of;  // by patch; one facet for each segment in the plane
  for (std::uint32_t p = 0; p < c.boundary.features().patches().size(); ++p) {
    for (const auto& facet : c.facets) {
      const bool is_on = std::all_of(facet.begin(), facet.end(),
                                     [&](Vertex v) { return c.boundary.features().is_on_patch(v, p); });
      facets_of[p] += is_on ? 1 : 0;
    }
  }
  std::size_t count = 0;
  Parents<Dim> parents(c.boundary, c.facets);
  for (const SubFacet f : c.sub_facets()) {
    const auto& record = c.boundary.sub_facets()[f];
    Point<Dim> center{};
    for (const Point<Dim>* p : c.boundary.corner_points(f)) {
      for (std::size_t k = 0; k < Dim; ++k) center[k] += (*p)[k] / Dim;
    }
    if (Dim == 3 && (facets_of[record.owner] == 1) != in_single) continue;
    const auto& parent = c.facets[parents.of(f)];
    if constexpr (Dim == 2) {
      const Point2& a = c.complex().point(parent[0]);
      const Point2& b = c.complex().point(parent[1]);
      const double length2 = (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
      const double along = ((b[0] - a[0]) * (center[0] - a[0]) + (b[1] - a[1]) * (center[1] - a[1])) / length2;
      const double off = test::exact_area2(a, b, center).get_d() / std::sqrt(length2);
      count += std::abs(off) > 0x1p-50 || along < 0 || along > 1 ? 1 : 0;
    } else {
      const Plane& plane = c.boundary.features().patches()[record.owner].plane;
      EXPECT_LE(plane.distance(center), 0x1p-50);
      std::array<Point2, 3> p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = plane.project(c.complex().point(parent[k]));
      const double size = std::abs(test::exact_area2(p[0], p[1], p[2]).get_d());
      const double turn = test::exact_area2(p[0], p[1], p[2]) > 0 ? 1 : -1;
      bool is_out = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const double part = test::exact_area2(p[(k + 1) % 3], p[(k + 2) % 3], plane.project(center)).get_d();
        is_out = is_out || turn * part < -1e-9 * size;
      }
      for (const Vertex v : parent) is_out = is_out || !c.boundary.features().is_on_patch(v, record.owner);
      count += is_out ? 1 : 0;
    }
  }
  return count;
}

TYPED_TEST(Conform, ParentsHoldTheirPiecesWhereFacetsAreNotJoined) {
  constexpr int kDim = TypeParam::value;
  for (const auto& [name, surface, measure, is_exact] : test::boundary_surfaces<kDim>()) {
    SCOPED_TRACE(name);
    Conforming<kDim> c(surface);
    c.conformer.start();
    ASSERT_TRUE(c.conform());
    EXPECT_EQ(astray(c, true), 0U);
  }
}

TEST(Conformer, ParentsHoldTheirPiecesWhereFacetsAreJoined) {
  for (const auto& [name, surface, measure, is_exact] : test::boundary_solids()) {
    SCOPED_TRACE(name);
    Conforming<3> c(surface);
    c.conformer.start();
    ASSERT_TRUE(c.conform());
    EXPECT_EQ(astray(c, false), 0U) << "of " << c.sub_facets().size();
  }
}

// Against labels from scratch, after each of many splits; and the lists of what goes and what comes.
TYPED_TEST(Conform, LabelsOfNewSimplicesAreThoseFromScratch) {
  constexpr int kDim = TypeParam::value;
  for (const auto& [name, surface, measure, is_exact] : test::boundary_surfaces<kDim>()) {
    if (name == "grid cube" || name == "plate 1:10") continue;  // large
    SCOPED_TRACE(name);
    Conforming<kDim> c(surface);
    c.conformer.start();
    ASSERT_TRUE(c.conform());
    c.label();
    const auto listed = c.domain.simplices();
    std::set<Simplex> inside(listed.begin(), listed.end());
    c.conformer.on_removal = [&inside](Simplex s) { EXPECT_EQ(inside.erase(s), 1U) << s; };
    test::Random random(9);
    for (int step = 0; step < 12; ++step) {
      SCOPED_TRACE(step);
      const auto all = c.sub_facets();
      const SubFacet f = all[random() % all.size()];
      if (!c.conformer.split(f, 0)) continue;
      ASSERT_TRUE(c.conform());
      for (const Simplex s : c.conformer.label_new()) EXPECT_TRUE(inside.insert(s).second) << s;
      Domain<kDim> fresh(c.triangulation);
      fresh.label(c.facets, c.boundary.walls());
      for (const Simplex s : c.complex().simplices()) ASSERT_EQ(c.domain.region(s), fresh.region(s)) << s;
      const auto now = c.domain.simplices();
      ASSERT_EQ(std::set<Simplex>(now.begin(), now.end()), inside);
    }
    test::expect_conforming(c);
    test::expect_walls(c);
    test::expect_pieces(c, is_exact);
    test::expect_places(c);
    EXPECT_NEAR(inside_of(c), measure, is_exact ? 0 : 1e-12 * std::max(measure, 1.0));
  }
}

// What is computed of two multiples of 2^-121, or on a plane, need not be one. Corners a little off a
// coordinate plane, by numbers of a few bits, leave room for that.
template <int Dim>
Surface<Dim> near_coordinate_planes(Surface<Dim> surface, std::uint64_t seed) {
  test::Random random(seed);
  for (auto& p : surface.points) {
    for (double& x : p) {
      if (x == 0) x = 1e-25 * test::uniform(random, -1, 1);
    }
  }
  return surface;
}

TYPED_TEST(Conform, PutsPointsOnTheGridOfTheGate) {
  constexpr int kDim = TypeParam::value;
  std::size_t small = 0;
  for (const auto& [name, surface, measure, is_exact] : test::boundary_surfaces<kDim>()) {
    if (name == "grid cube") continue;  // large
    for (const std::uint64_t seed : {1, 2}) {
      SCOPED_TRACE(name);
      Conforming<kDim> c(near_coordinate_planes<kDim>(surface, seed));
      c.conformer.start();
      c.conform(500);
      test::Random random(seed);
      for (int step = 0; step < 10 && c.conformer.unconformed().empty(); ++step) {
        const auto all = c.sub_facets();
        c.conformer.split(all[random() % all.size()], 0);
        c.conform(500);
      }
      for (auto v = static_cast<std::uint32_t>(surface.points.size()); v < c.complex().num_vertices(); ++v) {
        for (const double x : c.complex().point(Vertex(v))) {
          ASSERT_EQ(x * 0x1p121, std::nearbyint(x * 0x1p121)) << v;
          small += x != 0 && std::abs(x) < 0x1p-69 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(small, 30U);
}

// Steps of a budget: the work goes on where it stopped, to the same end.
TYPED_TEST(Conform, GoesOnWhereItWasStopped) {
  constexpr int kDim = TypeParam::value;
  for (const auto& [name, surface, measure, is_exact] : test::boundary_surfaces<kDim>()) {
    if (name != "wedge of 10" && name != "star of 5" && name != "L") continue;
    SCOPED_TRACE(name);
    Conforming<kDim> whole(surface);
    whole.conformer.start();
    ASSERT_TRUE(whole.conform());
    Conforming<kDim> steps(surface);
    steps.conformer.start();
    std::size_t calls = 0;
    while (!steps.conform(1)) {
      ASSERT_LT(++calls, 10000U);
      ASSERT_TRUE(steps.triangulation.validate().ok());
      if (calls % 8 == 0) test::expect_walls(steps);
    }
    test::expect_conforming(steps);
  }
}

// A triangle, and three small tetrahedra around its edge from 0 to 10, `at` from its end: the edge is missing.
Surface3 surrounded_edge(double at) {
  Surface3 surface;
  surface.points = {{0, 0, 0}, {10, 0, 0}, {5, 10, 0}};
  surface.facets = {{0, 1, 2}};
  constexpr double kSize = 0.05;
  for (const Point2& out : {Point2{-0.3, 0}, Point2{0.2, 0.3}, Point2{0.2, -0.3}}) {
    const auto first = static_cast<std::uint32_t>(surface.points.size());
    const Point3 tip{at, out[0], out[1]};
    surface.points.push_back(tip);
    for (const auto& [x, turn] : {std::pair(1.0, 0.0), std::pair(-0.5, 1.0), std::pair(-0.5, -1.0)}) {
      surface.points.push_back({at + kSize * x, tip[1] + kSize * (3 * out[0] - turn * out[1]),
                                tip[2] + kSize * (3 * out[1] + turn * out[0])});
    }
    for (std::uint32_t k = 0; k < 4; ++k) {
      surface.facets.push_back({first + (k + 1) % 4, first + (k + 2) % 4, first + (k + 3) % 4});
    }
  }
  return surface;
}

// Next to what is nearest to its middle, but not at a short end; or in the middle.
TEST(Conformer, DividesAMissingSegmentWhereItsCulpritIsNearest) {
  for (const double at : {0.7, 1.5, 2.5, 3.5, 6.0, 7.5, 8.5, 9.2}) {
    SCOPED_TRACE(at);
    for (const bool projects : {true, false}) {
      const Surface3 surface = surrounded_edge(at);
      Conforming<3> c(surface, projects);
      c.conformer.start();
      ASSERT_FALSE(c.conform(1));
      const auto& info =
          c.boundary.features().vertex(Vertex(static_cast<std::uint32_t>(surface.points.size())));
      ASSERT_EQ(info.on.kind, Feature::Kind::segment);
      const auto& ends = c.boundary.features().segments()[info.on.id].ends;
      ASSERT_EQ(ends, (std::array{Vertex(0), Vertex(1)}));
      if (projects && at > 2.2 && at < 7.8) {
        EXPECT_NEAR(info.t, at / 10, 0.006);
        EXPECT_NE(info.t, 0.5);
      } else {
        EXPECT_EQ(info.t, 0.5);
      }
    }
  }
}

}  // namespace
}  // namespace sinkmesh
