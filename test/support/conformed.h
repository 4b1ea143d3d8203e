// SPDX-License-Identifier: MIT
//
// A boundary with all that belongs to it, and what must hold of it, recomputed from coordinates and from the
// list of all facets of the triangulation.
#pragma once

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "refine/conformer.h"
#include "test/support/exact_signs.h"
#include "test/support/rational_geometry.h"

namespace sinkmesh::test {

template <int Dim>
struct Conforming {
  using Facet = std::array<Vertex, Dim>;

  /// Requires a surface without unused points.
  explicit Conforming(const Surface<Dim>& given, bool projects = true, const Collars& with = {})
      : surface(given),
        triangulation(surface.points),
        domain(triangulation),
        flow(triangulation),
        facets(facets_of(surface)),
        collars(with),
        boundary(triangulation, domain, facets, domain.find(facets), surface.facet_tags, 0x1p-40),
        conformer(triangulation, domain, flow, boundary, collars, 0.5, 0x1p-30, projects) {}
  Conforming(const Conforming&) = delete;
  Conforming& operator=(const Conforming&) = delete;

  static std::vector<Facet> facets_of(const Surface<Dim>& surface) {
    std::vector<Facet> result;
    for (const auto& ids : surface.facets) {
      result.emplace_back();
      for (std::size_t k = 0; k < Dim; ++k) result.back()[k] = Vertex(ids[k]);
    }
    return result;
  }
  bool conform(std::size_t max_points = 20000) {
    return conformer.conform([&] { return max_points-- > 0; });
  }
  void label() {
    domain.label(facets, boundary.walls(), surface.seeds);
    conformer.remember_regions();
  }
  const Complex<Dim>& complex() const { return triangulation.complex(); }
  std::vector<SubFacet> sub_facets() const {
    std::vector<SubFacet> result;
    boundary.sub_facets().for_each([&](SubFacet f) { result.push_back(f); });
    return result;
  }
  /// Inserts a point whatever is there, and tells the boundary.
  Vertex insert(const Point<Dim>& x, const BoundaryVertex& info) {
    triangulation.announce(x);
    const auto at = triangulation.locate(x);
    EXPECT_FALSE(at.is_at_corner());
    Cavity<Dim> cavity;
    triangulation.grow_prestar(cavity, x, at.simplex);
    boundary.before_insertion(cavity);
    const Vertex v = triangulation.substitute_star(cavity, x);
    boundary.set_vertex(v, info);
    boundary.after_insertion(cavity);
    return v;
  }

  Surface<Dim> surface;
  Triangulation<Dim> triangulation;
  Domain<Dim> domain;
  Flow<Dim> flow;
  std::vector<Facet> facets;
  Collars collars;
  Boundary<Dim> boundary;
  Conformer<Dim> conformer;
};

template <std::size_t N>
std::array<Vertex, N> sorted_corners(std::array<Vertex, N> corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// By sorted corners: the half-facets of all facets that a complex has, the infinite ones left out.
template <int Dim>
std::map<std::array<Vertex, Dim>, std::vector<HalfFacet>> all_facets(const Complex<Dim>& complex) {
  std::map<std::array<Vertex, Dim>, std::vector<HalfFacet>> result;
  for (const Simplex s : complex.simplices()) {
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet h = Complex<Dim>::half_facet(s, i);
      const auto corners = sorted_corners(complex.facet(h));
      if (!corners[0].is_infinite()) result[corners].push_back(h);
    }
  }
  return result;
}

/// The side of the diametral sphere of a facet on which x lies, in the integers of GMP.
template <int Dim>
int exact_diametral_side(const Complex<Dim>& complex, const std::array<Vertex, Dim>& facet, Vertex x) {
  std::vector<Point<Dim>> points;
  for (const Vertex v : facet) points.push_back(complex.point(v));
  points.push_back(complex.point(x));
  return exact_diametral<Dim>(ExactPoints<Dim>(points)).sign();
}

inline Rational exact_area2(const Point2& a, const Point2& b, const Point2& c) {
  const auto p = rational<2>(a);
  const auto q = rational<2>(b);
  const auto r = rational<2>(c);
  return Rational((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
}

/// Dim! times the volume of what is inside, in gated units.
template <int Dim>
Rational exact_inside(const Complex<Dim>& complex, const Domain<Dim>& domain) {
  Rational sum = 0;
  for (const Simplex s : domain.simplices()) {
    const auto p = rational_corners<Dim>(complex.corners(s));
    std::array<std::array<Rational, Dim>, Dim> d;
    for (std::size_t i = 0; i < Dim; ++i) {
      for (std::size_t k = 0; k < Dim; ++k) d[i][k] = p[i + 1][k] - p[0][k];
    }
    if constexpr (Dim == 2) {
      sum += d[0][0] * d[1][1] - d[0][1] * d[1][0];
    } else {
      sum += d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
             d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
             d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
    }
  }
  return sum;
}

/// B2, and that each sub-facet knows where it is.
template <int Dim>
void expect_walls(const Conforming<Dim>& c) {
  const auto known = all_facets(c.complex());
  std::size_t present = 0;
  for (const SubFacet f : c.sub_facets()) {
    const auto& record = c.boundary.sub_facets()[f];
    const auto found = known.find(sorted_corners(record.corners));
    ASSERT_EQ(record.at.is_null(), found == known.end());
    if (record.at.is_null()) continue;
    ++present;
    ASSERT_EQ(sorted_corners(c.complex().facet(record.at)), sorted_corners(record.corners));
    for (const HalfFacet h : found->second) ASSERT_TRUE(c.domain.is_wall(h)) << h;
    ASSERT_EQ(c.boundary.at(record.at), f);
  }
  std::size_t walls = 0;
  for (const Simplex s : c.complex().simplices()) {
    for (int i = 0; i <= Dim; ++i) walls += c.domain.is_wall(Complex<Dim>::half_facet(s, i)) ? 1 : 0;
  }
  ASSERT_EQ(walls, 2 * present);
}

/// B1 in the plane: from one end of each segment to the other.
inline void expect_pieces(const Conforming<2>& c, bool) {
  const auto& features = c.boundary.features();
  std::vector<std::map<double, double>> next(features.segments().size());
  for (const SubFacet f : c.sub_facets()) {
    const auto& record = c.boundary.sub_facets()[f];
    for (const Vertex v : record.corners) ASSERT_TRUE(features.is_on_segment(v, record.owner));
    ASSERT_EQ(record.owner, record.parent);
    const double one = features.position(record.corners[0], record.owner);
    const double other = features.position(record.corners[1], record.owner);
    const auto [from, to] = std::minmax({one, other});
    ASSERT_LT(from, to);
    ASSERT_TRUE(next[record.owner].try_emplace(from, to).second);
  }
  for (const auto& path : next) {
    double at = 0;
    for (std::size_t i = 0; i < path.size(); ++i) at = path.contains(at) ? path.at(at) : -1;
    EXPECT_EQ(at, 1);
  }
}

/// B1 in space: all turned alike, and together as large as the facets of the patch; edges within a patch have
/// two sub-facets.
inline void expect_pieces(const Conforming<3>& c, bool is_exact) {
  const auto& features = c.boundary.features();
  std::map<std::uint32_t, Rational> area;  // by patch
  std::map<std::uint32_t, Rational> given;
  std::map<std::pair<Vertex, Vertex>, std::vector<std::pair<std::uint32_t, std::uint32_t>>> edges;
  const auto projected = [&](std::uint32_t patch, const std::array<Vertex, 3>& corners) {
    const Plane& plane = features.patches()[patch].plane;
    return exact_area2(plane.project(c.complex().point(corners[0])),
                       plane.project(c.complex().point(corners[1])),
                       plane.project(c.complex().point(corners[2])));
  };
  for (const SubFacet f : c.sub_facets()) {
    const auto& record = c.boundary.sub_facets()[f];
    const Rational size = projected(record.owner, record.corners);
    ASSERT_GT(size, 0) << "a sub-facet is not counterclockwise";
    area[record.owner] += size;
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_TRUE(features.is_on_patch(record.corners[k], record.owner));
      const Vertex u = record.corners[(k + 1) % 3];
      const Vertex v = record.corners[(k + 2) % 3];
      edges[std::minmax(u, v)].emplace_back(record.owner, record.segment[k]);
    }
  }
  for (const auto& [edge, sides] : edges) {
    for (const auto& [owner, segment] : sides) ASSERT_EQ(segment, sides[0].second);
    if (sides[0].second == SubFacets<3>::kNone) {
      ASSERT_EQ(sides.size(), 2U);
      ASSERT_EQ(sides[0].first, sides[1].first);
    } else {
      ASSERT_TRUE(features.is_on_segment(edge.first, sides[0].second));
      ASSERT_TRUE(features.is_on_segment(edge.second, sides[0].second));
      const auto& patches = features.patches_at_segment(sides[0].second);
      for (const auto& [owner, segment] : sides) {
        ASSERT_NE(std::find(patches.begin(), patches.end(), owner), patches.end());
      }
    }
  }
  for (std::uint32_t p = 0; p < features.patches().size(); ++p) {
    // The facets of a patch: those with all corners on it that have area in its projection.
    for (const auto& facet : c.facets) {
      const bool is_on =
          std::all_of(facet.begin(), facet.end(), [&](Vertex v) { return features.is_on_patch(v, p); });
      if (is_on) given[p] += abs(projected(p, facet));
    }
    const Rational difference = abs(given[p] - area[p]);
    if (is_exact) {
      EXPECT_EQ(difference, 0) << "patch " << p;
    } else {
      EXPECT_LE(difference, area[p] * 1e-12) << "patch " << p;
    }
  }
}

/// What is known of each vertex agrees with where it is.
template <int Dim>
void expect_places(const Conforming<Dim>& c) {
  const auto& features = c.boundary.features();
  for (std::uint32_t i = 0; i < c.complex().num_vertices(); ++i) {
    const Vertex v(i);
    const BoundaryVertex& info = features.vertex(v);
    if (i < c.surface.points.size()) {
      EXPECT_EQ(c.triangulation.point(v), c.surface.points[i]);
      EXPECT_EQ(info.on, (Feature{Feature::Kind::corner, i}));
      EXPECT_EQ(info.level, 0U);
      continue;
    }
    EXPECT_GE(info.level, 1U);
    if (info.on.kind == Feature::Kind::segment) {
      EXPECT_GT(info.t, 0);
      EXPECT_LT(info.t, 1);
      EXPECT_EQ(features.point_at(info.on.id, info.t), c.complex().point(v));
    } else if constexpr (Dim == 3) {
      ASSERT_EQ(info.on.kind, Feature::Kind::patch);
      EXPECT_LE(features.patches()[info.on.id].plane.distance(c.complex().point(v)), 0x1p-50);
    }
  }
}

/// The point of it all: every sub-facet is there, and no apex strictly inside its diametral sphere.
template <int Dim>
void expect_conforming(const Conforming<Dim>& c) {
  ASSERT_TRUE(c.triangulation.validate().ok()) << c.triangulation.validate();
  const auto known = all_facets(c.complex());
  for (const SubFacet f : c.sub_facets()) {
    const auto found = known.find(sorted_corners(c.boundary.sub_facets()[f].corners));
    ASSERT_NE(found, known.end()) << "a sub-facet is no facet of the triangulation";
    for (const HalfFacet h : found->second) {
      const Vertex apex = c.complex().apex(h);
      if (apex.is_infinite()) continue;
      ASSERT_GE(exact_diametral_side<Dim>(c.complex(), found->first, apex), 0) << apex;
    }
  }
}

}  // namespace sinkmesh::test
