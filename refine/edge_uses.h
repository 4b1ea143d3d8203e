// SPDX-License-Identifier: MIT
//
// Which triangles are at each edge.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/handles.h"

namespace sinkmesh {

/// One triangle at one edge.
struct EdgeUse {
  std::array<Vertex, 2> edge;
  std::uint32_t facet;
  std::uint32_t k;  // the corner opposite
  auto operator<=>(const EdgeUse&) const = default;
};

/// Calls visit(first, last) with the range of uses of each edge, in the order of the edges; within an edge by
/// facet.
/// @param corners_of  the three vertices of facet number f. Log-linear.
template <class CornersOf, class Visit>
void for_each_edge(std::size_t num_facets, CornersOf&& corners_of, Visit&& visit) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * num_facets);
  for (std::uint32_t f = 0; f < num_facets; ++f) {
    const std::array<Vertex, 3>& corners = corners_of(f);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Vertex a = corners[(k + 1) % 3];
      const Vertex b = corners[(k + 2) % 3];
      uses.push_back({{std::min(a, b), std::max(a, b)}, f, k});
    }
  }
  std::sort(uses.begin(), uses.end());
  for (auto first = uses.begin(); first != uses.end();) {
    auto last = first;
    while (last != uses.end() && last->edge == first->edge) ++last;
    visit(first, last);
    first = last;
  }
}

}  // namespace sinkmesh
