// SPDX-License-Identifier: MIT
#include "refine/mesh_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "core/triangulation.h"
#include "refine/refine.h"

namespace sinkmesh {
namespace {

using Kind = MeshDefect::Kind;

template <int Dim>
std::vector<Kind> kinds(const MeshCheck<Dim>& check) {
  std::vector<Kind> result;
  for (const MeshDefect& defect : check.defects) result.push_back(defect.kind);
  return result;
}

// Two tetrahedra on one triangle, at different heights.
Mesh3 bipyramid(double above, double below) {
  Mesh3 mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, above}, {0.3, 0.3, -below}};
  mesh.simplices = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  return mesh;
}

// n^3 cubes of six tetrahedra each, around the diagonals.
Mesh3 cubes(std::uint32_t n) {
  Mesh3 mesh;
  const auto id = [n](const std::array<std::uint32_t, 3>& p) {
    return (p[0] * (n + 1) + p[1]) * (n + 1) + p[2];
  };
  for (std::uint32_t x = 0; x <= n; ++x) {
    for (std::uint32_t y = 0; y <= n; ++y) {
      for (std::uint32_t z = 0; z <= n; ++z) {
        mesh.points.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
        if (x == n || y == n || z == n) continue;
        std::array<std::size_t, 3> axes = {0, 1, 2};
        do {
          std::array<std::uint32_t, 3> corner = {x, y, z};
          Mesh3::Simplex s = {id(corner), 0, 0, 0};
          for (std::size_t k = 0; k < 3; ++k) {
            ++corner[axes[k]];
            s[k + 1] = id(corner);
          }
          const bool odd = (axes[0] > axes[1]) ^ (axes[0] > axes[2]) ^ (axes[1] > axes[2]);
          if (odd) std::swap(s[0], s[1]);
          mesh.simplices.push_back(s);
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
    }
  }
  return mesh;
}

template <int Dim>
std::vector<Point<Dim>> random_points(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<Point<Dim>> points(count);
  for (Point<Dim>& p : points) {
    for (double& x : p) x = static_cast<double>(random() >> 11) * 0x1p-53;
  }
  return points;
}

TEST(MeshCheck, CountsOfASingleSimplex) {
  Mesh3 mesh = bipyramid(1, 1);
  mesh.simplices.pop_back();
  const auto check = check_mesh(mesh);
  EXPECT_TRUE(check.ok());
  EXPECT_TRUE(check.is_delaunay());
  EXPECT_EQ(check.vertices, 4U);
  EXPECT_EQ(check.unused_points, 1U);
  EXPECT_EQ(check.boundary_facets, 4U);
  EXPECT_EQ(check.interior_facets, 0U);
  EXPECT_EQ(check.components, 1U);
}

TEST(MeshCheck, RegularTetrahedronIsASink) {
  Mesh3 mesh;
  mesh.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  mesh.simplices = {{0, 2, 1, 3}};
  const auto check = check_mesh(mesh);
  EXPECT_TRUE(check.ok());
  EXPECT_EQ(check.sinks, 1U);
  EXPECT_EQ(check.unstable_facets, 0U);
  EXPECT_NEAR(check.quality.max_ratio(), std::sqrt(3.0 / 8), 1e-15);
}

TEST(MeshCheck, FlatTetrahedronFlowsOutThroughItsLargestFacets) {
  Mesh3 mesh = bipyramid(0.01, 1);
  mesh.simplices.pop_back();
  const auto check = check_mesh(mesh);
  EXPECT_EQ(check.sinks, 0U);
  EXPECT_GT(check.unstable_facets, 0U);
  EXPECT_EQ(check.quality.low_quality(), 1U);
}

TEST(MeshCheck, TallBipyramidIsDelaunayAndAFlatOneIsNot) {
  EXPECT_TRUE(check_mesh(bipyramid(1, 1)).is_delaunay());
  const auto check = check_mesh(bipyramid(0.1, 0.1));
  EXPECT_TRUE(check.ok());
  EXPECT_FALSE(check.is_delaunay());
  EXPECT_EQ(check.facets_not_delaunay, 1U);
  EXPECT_EQ(check.simplices_not_delaunay, 2U);
  EXPECT_EQ(check.first_not_delaunay, 0U);
}

TEST(MeshCheck, EveryDivisionOfCosphericalPointsIsDelaunay) {
  const auto check = check_mesh(cubes(4));
  EXPECT_TRUE(check.ok()) << check.defects.front().message;
  EXPECT_TRUE(check.is_delaunay());
  EXPECT_EQ(check.facets_not_delaunay, 0U);
  EXPECT_GE(check.cospherical_facets, 64U * 6);
  EXPECT_EQ(check.boundary_facets, 6U * 16 * 2);
  EXPECT_EQ(check.components, 1U);
}

TEST(MeshCheck, DelaunayAcrossTheBoundaryCounts) {
  // Two tetrahedra apart from each other, the tip of one in the circumsphere of the other.
  Mesh3 mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0.5}, {3, 3, 2}, {3, 2, 3}, {2, 3, 3}};
  mesh.simplices = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  if (check_mesh(mesh).defects.size() == 1) std::swap(mesh.simplices[1][0], mesh.simplices[1][1]);
  const auto check = check_mesh(mesh);
  EXPECT_TRUE(check.ok());
  EXPECT_EQ(check.components, 2U);
  EXPECT_EQ(check.interior_facets, 0U);
  EXPECT_EQ(check.facets_not_delaunay, 0U);
  EXPECT_FALSE(check.is_delaunay());
}

TEST(MeshCheck, TriangulationsAreDelaunayAndAgreeOnSinks) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Triangulation3 space(random_points<3>(500, seed));
    const auto check3 = check_mesh(hull_mesh(space));
    EXPECT_TRUE(check3.is_delaunay());
    Flow<3> flow3(space);
    EXPECT_EQ(check3.sinks, flow3.sinks().size());
    EXPECT_EQ(check3.boundary_facets, space.num_ghosts());

    const Triangulation2 plane(random_points<2>(500, seed));
    const auto check2 = check_mesh(hull_mesh(plane));
    EXPECT_TRUE(check2.is_delaunay());
    Flow<2> flow2(plane);
    EXPECT_EQ(check2.sinks, flow2.sinks().size());
  }
}

TEST(MeshCheck, FindsTheDefectsOfSimplices) {
  Mesh3 mesh = bipyramid(1, 1);
  std::swap(mesh.simplices[0][0], mesh.simplices[0][1]);
  EXPECT_THAT(kinds(check_mesh(mesh)), testing::Contains(Kind::inverted));
  mesh = bipyramid(1, 1);
  mesh.points[3] = {0.25, 0.25, 0};
  EXPECT_EQ(kinds(check_mesh(mesh)), std::vector{Kind::flat});
  mesh = bipyramid(1, 1);
  mesh.simplices[0][3] = 0;
  EXPECT_EQ(kinds(check_mesh(mesh)), std::vector{Kind::bad_corner});
  mesh = bipyramid(1, 1);
  mesh.simplices[0][3] = 5;
  EXPECT_EQ(kinds(check_mesh(mesh)), std::vector{Kind::bad_corner});
  mesh = bipyramid(1, 1);
  mesh.points[3][2] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(kinds(check_mesh(mesh)), std::vector{Kind::not_finite});
}

TEST(MeshCheck, FindsFacetsThatDoNotFit) {
  Mesh3 mesh = bipyramid(1, 1);
  mesh.points[4] = {0.2, 0.2, 3};
  mesh.simplices[1] = {0, 1, 2, 4};
  EXPECT_EQ(kinds(check_mesh(mesh)), std::vector{Kind::same_side});
  mesh = bipyramid(1, 1);
  mesh.points.push_back({0.2, 0.2, 3});
  mesh.simplices.push_back({0, 1, 2, 5});
  EXPECT_EQ(kinds(check_mesh(mesh)), std::vector{Kind::crowded_facet});
  mesh = bipyramid(1, 1);
  mesh.simplices.push_back(mesh.simplices[1]);
  EXPECT_THAT(kinds(check_mesh(mesh)), testing::Contains(Kind::crowded_facet));
}

TEST(MeshCheck, FindsDuplicateVertices) {
  Mesh3 mesh = bipyramid(1, 1);
  for (const std::uint32_t v : {0U, 2U, 1U}) mesh.points.push_back(mesh.points[v]);
  mesh.simplices[1] = {5, 6, 7, 4};
  EXPECT_EQ(kinds(check_mesh(mesh)), std::vector(3, Kind::duplicate_point));
}

TEST(MeshCheck, FindsAPartInsideAnother) {
  Mesh3 mesh = cubes(2);
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (const Point3& p : bipyramid(1, 1).points) {
    mesh.points.push_back({0.7 + p[0] / 8, 0.8 + p[1] / 8, 0.9 + p[2] / 8});
  }
  mesh.simplices.push_back({first, first + 1, first + 2, first + 3});
  EXPECT_THAT(kinds(check_mesh(mesh)), testing::ElementsAre(Kind::overlap));
}

TEST(MeshCheck, HugeAndTinyCoordinatesDoNotOverflow) {
  for (const double scale : {0x1p500, 0x1p-500}) {
    Mesh3 mesh = bipyramid(1, 1);
    const double ratio = check_mesh(mesh).quality.max_ratio();
    for (Point3& p : mesh.points) {
      for (double& x : p) x *= scale;
    }
    const auto check = check_mesh(mesh);
    EXPECT_TRUE(check.is_delaunay());
    EXPECT_EQ(check.quality.max_ratio(), ratio);
  }
}

TEST(MeshCheck, AnEmptyMeshHasNoDefect) {
  const auto check = check_mesh(Mesh3{});
  EXPECT_TRUE(check.ok());
  EXPECT_EQ(check.components, 0U);
}

}  // namespace
}  // namespace sinkmesh
