// SPDX-License-Identifier: MIT
//
// Looking up facets by their vertices.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/handles.h"

namespace sinkmesh {

/// Facets by their smallest vertex: few have the same one, so that looking one up is a short scan.
template <int Dim>
class FacetIndex {
 public:
  /// Linear.
  FacetIndex(std::span<const std::array<Vertex, Dim>> facets, std::size_t num_vertices)
      : first_(num_vertices + 1, 0), entries_(facets.size()) {
    for (const auto& facet : facets) ++first_[sorted(facet)[0].index() + 1];
    for (std::size_t v = 0; v < num_vertices; ++v) first_[v + 1] += first_[v];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < facets.size(); ++i) {
      const auto facet = sorted(facets[i]);
      entries_[next[facet[0].index()]++] = {facet, i};
    }
  }

  /// Calls found(index) for every facet of the list with these corners.
  template <class Found>
  void look_up(const std::array<Vertex, Dim>& corners, Found&& found) const {
    const Vertex smallest = *std::min_element(corners.begin(), corners.end());
    const std::uint32_t v = smallest.index();
    if (first_[v] == first_[v + 1]) return;
    const auto facet = sorted(corners);
    for (std::uint32_t k = first_[v]; k < first_[v + 1]; ++k) {
      if (entries_[k].facet == facet) found(entries_[k].index);
    }
  }

 private:
  static std::array<Vertex, Dim> sorted(std::array<Vertex, Dim> facet) {
    std::sort(facet.begin(), facet.end());
    return facet;
  }

  struct Entry {
    std::array<Vertex, Dim> facet;
    std::size_t index;
  };
  std::vector<std::uint32_t> first_;
  std::vector<Entry> entries_;
};

}  // namespace sinkmesh
