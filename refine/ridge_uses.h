// SPDX-License-Identifier: MIT
//
// Which facets are at each ridge: at an edge in space, at a vertex in the plane.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/handles.h"

namespace sinkmesh {

/// One facet at one ridge.
template <int Dim>
struct RidgeUse {
  std::array<Vertex, Dim - 1> ridge;  ///< increasing
  std::uint32_t facet;
  std::uint32_t k;  ///< the corner that is not on the ridge
  auto operator<=>(const RidgeUse&) const = default;
};

/// Calls visit(first, last) with the range of uses of each ridge, in the order of the ridges; within one by
/// facet. Log-linear.
/// @param corners_of  the vertices of facet number f.
template <int Dim, class CornersOf, class Visit>
void for_each_ridge(std::size_t num_facets, CornersOf&& corners_of, Visit&& visit) {
  std::vector<RidgeUse<Dim>> uses;
  uses.reserve(Dim * num_facets);
  for (std::uint32_t f = 0; f < num_facets; ++f) {
    const std::array<Vertex, Dim>& corners = corners_of(f);
    for (std::uint32_t k = 0; k < Dim; ++k) {
      RidgeUse<Dim> use{{}, f, k};
      for (std::size_t j = 0; j + 1 < Dim; ++j) use.ridge[j] = corners[(k + 1 + j) % Dim];
      std::sort(use.ridge.begin(), use.ridge.end());
      uses.push_back(use);
    }
  }
  std::sort(uses.begin(), uses.end());
  for (auto first = uses.begin(); first != uses.end();) {
    auto last = first;
    while (last != uses.end() && last->ridge == first->ridge) ++last;
    visit(first, last);
    first = last;
  }
}

}  // namespace sinkmesh
