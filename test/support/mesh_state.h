// SPDX-License-Identifier: MIT
//
// A refined mesh seen from outside, and what improving it must not change.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "core/vector.h"
#include "predicates/circumcenter.h"
#include "refine/mesh_check.h"
#include "refine/refine.h"

namespace sinkmesh::test {

template <int Dim>
struct MeshState {
  using Facet = std::array<Point<Dim>, Dim>;

  MeshState(const SurfaceMesher<Dim>& mesher, double max_ratio)
      : mesh(mesher.mesh()), check(check_mesh(mesh, max_ratio)), centers_outside(count_centers(mesher)) {
    for (const auto& simplex : mesh.simplices) {
      for (std::size_t i = 0; i <= Dim; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          shortest2 = std::min(shortest2, squared_distance(mesh.points[simplex[i]], mesh.points[simplex[j]]));
        }
      }
    }
    for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
      Facet corners;
      for (std::size_t k = 0; k < Dim; ++k) corners[k] = mesh.points[mesh.boundary[f][k]];
      std::sort(corners.begin(), corners.end());
      parents.emplace(corners, mesh.boundary_fields[0].values[f]);
    }
    for (const auto value : mesh.simplex_fields[0].values) regions = std::max(regions, value);
  }

  // Circumcenters that lie in no simplex of the domain, nor on its boundary.
  static std::size_t count_centers(const SurfaceMesher<Dim>& mesher) {
    Triangulation<Dim> triangulation = mesher.triangulation();
    const Complex<Dim>& complex = triangulation.complex();
    std::size_t count = 0;
    for (const Simplex s : mesher.domain().simplices()) {
      Point<Dim> center;
      if (!circumcenter(complex.corners(s), center)) {
        ++count;
        continue;
      }
      triangulation.announce(center);
      const Location<Dim> at = triangulation.locate(center, s);
      const bool is_on_facet = at.support() != 0 && at.support() <= Dim;
      count += mesher.domain().is_inside(at.simplex) || is_on_facet ? 0 : 1;
    }
    return count;
  }

  Mesh<Dim> mesh;
  MeshCheck<Dim> check;
  std::size_t centers_outside;
  double shortest2 = HUGE_VAL;
  std::map<Facet, std::int64_t> parents;  // of boundary facets
  std::int64_t regions = 0;
};

/// That `after` has come from `before` by moving, removing and inserting inner points as it should.
template <int Dim>
void expect_improved(const Surface<Dim>& surface, const MeshState<Dim>& before, const MeshState<Dim>& after,
                     const Improvement& improvement) {
  EXPECT_TRUE(after.check.ok());
  EXPECT_TRUE(after.check.is_delaunay());
  EXPECT_EQ(after.check.unstable_facets, 0U);
  EXPECT_EQ(after.parents, before.parents) << "the boundary has changed";
  EXPECT_EQ(after.regions, before.regions);
  EXPECT_GE(after.shortest2, before.shortest2);
  EXPECT_LE(after.centers_outside, before.centers_outside);
  EXPECT_LE(after.check.quality.low_quality(), before.check.quality.low_quality());
  const double worst = std::max(before.check.quality.max_ratio(), 1.0);
  EXPECT_LE(after.check.quality.max_ratio(), worst + (before.check.quality.low_quality() == 0 ? 1 : 0));
  EXPECT_TRUE(std::equal(surface.points.begin(), surface.points.end(), after.mesh.points.begin()));
  EXPECT_EQ(after.mesh.points.size() + improvement.coarsening.removed + improvement.moving.removed,
            before.mesh.points.size() + improvement.moving.inserted);
  EXPECT_EQ(improvement.remaining.total(), after.check.quality.low_quality());
  EXPECT_LE(after.mesh.simplices.size(), before.mesh.simplices.size());
}

}  // namespace sinkmesh::test
