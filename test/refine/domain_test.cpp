// SPDX-License-Identifier: MIT
#include "refine/domain.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/triangulation.h"
#include "predicates/predicates.h"
#include "test/support/surfaces.h"

namespace sinkmesh {
namespace {

using test::box_surface;
using test::ellipsoid_surface;

std::vector<Domain<3>::Facet> facets_of(const Surface3& surface) {
  std::vector<Domain<3>::Facet> facets;
  for (const auto& [a, b, c] : surface.facets) facets.push_back({Vertex(a), Vertex(b), Vertex(c)});
  return facets;
}

// Six times the volume, exact for small integers.
double six_volumes(const Triangulation3& triangulation, const Domain<3>& domain) {
  double sum = 0;
  for (const Simplex s : domain.simplices()) {
    std::array<Point3, 4> p;
    for (int i = 0; i < 4; ++i)
      p[static_cast<std::size_t>(i)] = triangulation.point(triangulation.complex().corner(s, i));
    std::array<Point3, 3> d;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) d[i][k] = p[i + 1][k] - p[0][k];
    }
    sum += d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) +
           d[0][1] * (d[1][2] * d[2][0] - d[1][0] * d[2][2]) +
           d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
  }
  return sum;
}

// The triangles that the triangulation chose on the sides of boxes, since those of a box surface may be the
// others.
Surface3 with_delaunay_sides(Surface3 surface, const Triangulation3& triangulation) {
  const std::vector<std::size_t> missing = Domain<3>(triangulation).label_facets(facets_of(surface));
  for (std::size_t side = 0; side < surface.facets.size(); side += 2) {
    if (std::none_of(missing.begin(), missing.end(), [&](std::size_t f) { return f / 2 == side / 2; }))
      continue;
    // Two triangles abc, acd of a box side, whichever way they turn: take the other diagonal.
    std::vector<std::uint32_t> shared;
    std::vector<std::uint32_t> single;
    for (const std::uint32_t v : surface.facets[side]) {
      const auto& other = surface.facets[side + 1];
      (std::find(other.begin(), other.end(), v) != other.end() ? shared : single).push_back(v);
    }
    for (const std::uint32_t v : surface.facets[side + 1]) {
      if (std::find(shared.begin(), shared.end(), v) == shared.end()) single.push_back(v);
    }
    const auto [a, c] = std::pair(shared[0], shared[1]);
    const auto [b, d] = std::pair(single[0], single[1]);
    surface.facets[side] = {a, b, d};
    surface.facets[side + 1] = {b, c, d};
  }
  return surface;
}

TEST(Domain, NestedBoxesAlternateBetweenInsideAndOutside) {
  for (const bool turned : {false, true}) {
    Surface3 middle = box_surface({2, 2, 2}, {8, 8, 8});
    if (turned) middle = test::reversed(middle);
    Surface3 surface =
        test::join(test::join(box_surface({0, 0, 0}, {10, 10, 10}), middle), box_surface({4, 4, 4}, {6, 6, 6}));
    const Triangulation3 triangulation(surface.points);
    surface = with_delaunay_sides(surface, triangulation);
    Domain<3> domain(triangulation);
    ASSERT_TRUE(domain.label_facets(facets_of(surface)).empty());
    EXPECT_EQ(six_volumes(triangulation, domain), 6 * (1000 - 216 + 8));
    EXPECT_EQ(domain.boundary().size(), surface.facets.size());
  }
}

TEST(Domain, BoundaryIsTheSurfaceFacetForFacet) {
  const Surface3 surface = ellipsoid_surface(3, {1, 1.1, 0.9}, 1e-3);
  const Triangulation3 triangulation(surface.points);
  Domain<3> domain(triangulation);
  ASSERT_TRUE(domain.label_facets(facets_of(surface)).empty());
  std::vector<std::array<std::uint32_t, 3>> expected;
  std::vector<std::array<std::uint32_t, 3>> actual;
  for (auto facet : surface.facets) {
    std::sort(facet.begin(), facet.end());
    expected.push_back(facet);
  }
  for (const HalfFacet h : domain.boundary()) {
    std::array<std::uint32_t, 3> facet;
    const auto vertices = triangulation.complex().facet(h);
    for (std::size_t k = 0; k < 3; ++k) facet[k] = vertices[k].index();
    std::sort(facet.begin(), facet.end());
    actual.push_back(facet);
  }
  std::sort(expected.begin(), expected.end());
  std::sort(actual.begin(), actual.end());
  EXPECT_EQ(actual, expected);
}

TEST(Domain, MissingFacetsAreReportedAndNothingIsLabelled) {
  Surface3 surface = ellipsoid_surface(2, {1, 1, 1}, 1e-3);
  const Triangulation3 triangulation(surface.points);
  // A triangle of three far-apart vertices is no Delaunay facet.
  surface.facets[5] = {0, 3, 5};
  surface.facets[7] = {1, 2, 4};
  Domain<3> domain(triangulation);
  EXPECT_EQ(domain.label_facets(facets_of(surface)), (std::vector<std::size_t>{5, 7}));
  EXPECT_TRUE(domain.simplices().empty());
}

TEST(Domain, OpenSurfaceIsRefused) {
  Surface3 surface = ellipsoid_surface(2, {1, 1, 1}, 1e-3);
  const Triangulation3 triangulation(surface.points);
  surface.facets.pop_back();
  Domain<3> domain(triangulation);
  EXPECT_THROW((void)domain.label_facets(facets_of(surface)), InputError);
  EXPECT_TRUE(domain.simplices().empty());
}

// The oracle removes, round by round, every simplex that flows to a simplex already removed.
TEST(Domain, PeelingLeavesTheMaximalStableSubcomplex) {
  std::size_t peeled_in_all = 0;
  for (const double flatness : {1.0, 0.3, 0.05, 0.02}) {
    SCOPED_TRACE(flatness);
    const Surface3 surface = ellipsoid_surface(3, {1, 0.7, flatness}, 1e-3);
    const Triangulation3 triangulation(surface.points);
    const Complex<3>& complex = triangulation.complex();
    Flow<3> flow(triangulation);
    // Everything in the hull that is not a sliver at its border: a domain that need not be stable.
    Domain<3> domain(triangulation);
    std::vector<bool> expected(complex.num_slots(), false);
    for (const Simplex s : complex.simplices()) {
      if (complex.is_ghost(s)) continue;
      domain.set_region(s, 1);
      expected[s.index()] = true;
      for (int i = 0; i < 4; ++i) {
        if (!complex.is_ghost(complex.neighbor(s, i))) continue;
        const HalfFacet h = Complex<3>::half_facet(s, i);
        domain.add_wall(h);
        domain.add_wall(complex.mate(h));
      }
    }
    bool changed = true;
    while (changed) {
      changed = false;
      for (const Simplex s : complex.simplices()) {
        if (!expected[s.index()]) continue;
        for (int i = 0; i < 4; ++i) {
          const Simplex t = complex.neighbor(s, i);
          const bool is_out = diametral_side_sos(*complex.facet_corners(Complex<3>::half_facet(s, i))[0],
                                                 *complex.facet_corners(Complex<3>::half_facet(s, i))[1],
                                                 *complex.facet_corners(Complex<3>::half_facet(s, i))[2],
                                                 complex.point(complex.corner(s, i))) < 0;
          if (is_out && !expected[t.index()]) {
            expected[s.index()] = false;
            changed = true;
            break;
          }
        }
      }
    }
    const std::size_t before = domain.simplices().size();
    const Domain<3>::Peeled peeled = domain.peel(flow);
    EXPECT_EQ(domain.simplices().size(), before - peeled.simplices);
    std::size_t bare = 0;  // facets of the hull
    for (const Simplex s : complex.simplices()) {
      if (complex.is_ghost(s)) bare += expected[complex.neighbor(s, 3).index()] ? 0 : 1;
    }
    EXPECT_EQ(peeled.facets, bare);
    peeled_in_all += peeled.simplices;
    for (const Simplex s : complex.simplices()) ASSERT_EQ(domain.is_inside(s), expected[s.index()]) << s;
  }
  EXPECT_GT(peeled_in_all, 100U);
}

}  // namespace
}  // namespace sinkmesh
