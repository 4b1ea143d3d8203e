// SPDX-License-Identifier: MIT
//
// Self-intersections by brute force: every pair of facets is intersected in the rationals, by clipping one with
// the half-spaces of the other.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "refine/surface.h"
#include "test/support/rational_geometry.h"

namespace sinkmesh::test {

/// Corners of a convex polygon, in cyclic order and possibly repeated; one corner: a point; two: a segment.
template <int Dim>
using RationalPolygon = std::vector<RationalPoint<Dim>>;

template <int Dim>
RationalPoint<Dim> difference(const RationalPoint<Dim>& a, const RationalPoint<Dim>& b) {
  RationalPoint<Dim> d;
  for (std::size_t k = 0; k < Dim; ++k) d[k] = a[k] - b[k];
  return d;
}
template <std::size_t N>
Rational inner_product(const std::array<Rational, N>& a, const std::array<Rational, N>& b) {
  Rational sum = 0;
  for (std::size_t k = 0; k < N; ++k) sum += a[k] * b[k];
  return sum;
}
inline RationalPoint<3> cross_product(const RationalPoint<3>& a, const RationalPoint<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// All x with normal . (x - origin) >= 0.
template <int Dim>
struct HalfSpace {
  RationalPoint<Dim> origin;
  RationalPoint<Dim> normal;

  Rational value(const RationalPoint<Dim>& x) const {
    return inner_product(normal, difference<Dim>(x, origin));
  }
  HalfSpace opposite() const { return {origin, difference<Dim>(RationalPoint<Dim>{}, normal)}; }
};

template <int Dim>
RationalPolygon<Dim> clipped(const RationalPolygon<Dim>& polygon, const HalfSpace<Dim>& half_space) {
  RationalPolygon<Dim> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint<Dim>& a = polygon[i];
    const RationalPoint<Dim>& b = polygon[(i + 1) % polygon.size()];
    const Rational at_a = half_space.value(a);
    const Rational at_b = half_space.value(b);
    if (at_a >= 0) result.push_back(a);
    if (at_a * at_b >= 0) continue;
    const Rational part = at_a / (at_a - at_b);
    RationalPoint<Dim>& x = result.emplace_back();
    for (std::size_t k = 0; k < Dim; ++k) x[k] = a[k] + part * (b[k] - a[k]);
  }
  return result;
}

/// Whose intersection is the facet; none if it is degenerate.
inline std::vector<HalfSpace<2>> half_spaces(const RationalPolygon<2>& s) {
  const RationalPoint<2> along = difference<2>(s[1], s[0]);
  if (along == RationalPoint<2>{}) return {};
  const HalfSpace<2> side{s[0], {-along[1], along[0]}};
  return {side, side.opposite(), {s[0], along}, HalfSpace<2>{s[1], along}.opposite()};
}
inline std::vector<HalfSpace<3>> half_spaces(const RationalPolygon<3>& s) {
  const RationalPoint<3> normal = cross_product(difference<3>(s[1], s[0]), difference<3>(s[2], s[0]));
  if (normal == RationalPoint<3>{}) return {};
  const HalfSpace<3> side{s[0], normal};
  std::vector<HalfSpace<3>> result = {side, side.opposite()};
  for (std::size_t k = 0; k < 3; ++k) {
    result.push_back({s[k], cross_product(normal, difference<3>(s[(k + 1) % 3], s[k]))});
  }
  return result;
}

/// Is x in the convex hull of at most two points?
template <int Dim>
bool is_between(const RationalPolygon<Dim>& ends, const RationalPoint<Dim>& x) {
  if (ends.empty()) return false;
  const RationalPoint<Dim> u = difference<Dim>(ends.back(), ends.front());
  const RationalPoint<Dim> v = difference<Dim>(x, ends.front());
  const Rational length = inner_product(u, u);
  const Rational product = inner_product(u, v);
  return product >= 0 && product <= length && product * product == length * inner_product(v, v) &&
         (length != 0 || inner_product(v, v) == 0);
}

/// Facets of distinct ids in range. Compare self_intersections().
template <int Dim>
std::vector<std::pair<std::uint32_t, std::uint32_t>> self_intersections_by_definition(
    const Surface<Dim>& surface) {
  std::vector<RationalPolygon<Dim>> facets;
  std::vector<std::vector<HalfSpace<Dim>>> sides;
  for (const auto& facet : surface.facets) {
    RationalPolygon<Dim>& corners = facets.emplace_back();
    for (const std::uint32_t v : facet) corners.push_back(rational<Dim>(surface.points[v]));
    sides.push_back(half_spaces(corners));
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    for (std::uint32_t g = f + 1; g < facets.size(); ++g) {
      if (sides[f].empty() || sides[g].empty()) continue;
      RationalPolygon<Dim> common;
      std::copy_if(facets[f].begin(), facets[f].end(), std::back_inserter(common), [&](const auto& p) {
        return std::find(facets[g].begin(), facets[g].end(), p) != facets[g].end();
      });
      if (common.size() == Dim) continue;
      RationalPolygon<Dim> intersection = facets[f];
      for (const HalfSpace<Dim>& side : sides[g]) intersection = clipped<Dim>(intersection, side);
      const bool is_common_face = std::all_of(intersection.begin(), intersection.end(),
                                              [&](const auto& x) { return is_between<Dim>(common, x); });
      if (!is_common_face) pairs.emplace_back(f, g);
    }
  }
  return pairs;
}

}  // namespace sinkmesh::test
