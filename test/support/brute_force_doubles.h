// SPDX-License-Identifier: MIT
//
// The perturbed Delaunay complex of a few doubles by exact integers, fast enough for a hundred thousand clouds;
// tested against the definition (brute_force.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "predicates/point.h"
#include "test/support/brute_force.h"
#include "test/support/exact_signs.h"
#include "test/support/integer_signs.h"

namespace sinkmesh::test {

/// Whether the last point lies inside the perturbed circumsphere of the others. Requires a positive volume, and
/// distinct points.
template <int Dim>
bool is_inside_exactly(const detail::Points<detail::InSphere<Dim>>& points) {
  const int sign = integer_sign<detail::InSphere<Dim>>(points);
  if (sign != 0) return sign > 0;
  std::vector<Point<Dim>> copies;
  for (const Point<Dim>* p : points) copies.push_back(*p);
  return exact_in_sphere<Dim>(ExactPoints<Dim>(copies), true).sign() > 0;
}

/// The simplices, in lexicographic order. Requires distinct points.
template <int Dim>
std::vector<IdSet<Dim + 1>> brute_force_delaunay_of_doubles(const std::vector<Point<Dim>>& points) {
  std::vector<IdSet<Dim + 1>> result;
  const auto n = static_cast<std::uint32_t>(points.size());
  for_all_subsets<Dim + 1>(n, [&](const IdSet<Dim + 1>& simplex) {
    detail::Points<detail::Orientation<Dim>> corners;
    for (std::size_t i = 0; i <= Dim; ++i) corners[i] = &points[simplex[i]];
    const int volume = integer_sign<detail::Orientation<Dim>>(corners);
    if (volume == 0) return;
    if (volume < 0) std::swap(corners[0], corners[1]);
    detail::Points<detail::InSphere<Dim>> all;
    std::copy(corners.begin(), corners.end(), all.begin());
    for (std::uint32_t e = 0; e < n; ++e) {
      if (std::find(simplex.begin(), simplex.end(), e) != simplex.end()) continue;
      all.back() = &points[e];
      if (is_inside_exactly<Dim>(all)) return;
    }
    result.push_back(simplex);
  });
  return result;
}

}  // namespace sinkmesh::test
