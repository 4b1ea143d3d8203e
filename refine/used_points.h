// SPDX-License-Identifier: MIT
//
// What of a surface is to be triangulated.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/handles.h"
#include "refine/surface.h"

namespace sinkmesh {

/// The points that facets use, in their order, without gaps. Unused points of a surface must not become
/// vertices of the mesh.
template <int Dim>
struct UsedPoints {
  std::vector<Point<Dim>> points;
  std::vector<std::array<Vertex, Dim>> facets;

  explicit UsedPoints(const Surface<Dim>& surface) {
    std::vector<std::uint32_t> new_id(surface.points.size(), 0);
    for (const auto& facet : surface.facets) {
      for (const std::uint32_t p : facet) new_id[p] = 1;
    }
    for (std::uint32_t p = 0; p < new_id.size(); ++p) {
      if (new_id[p] == 0) continue;
      new_id[p] = static_cast<std::uint32_t>(points.size());
      points.push_back(surface.points[p]);
    }
    facets.reserve(surface.facets.size());
    for (const auto& facet : surface.facets) {
      std::array<Vertex, Dim> corners;
      for (std::size_t k = 0; k < Dim; ++k) corners[k] = Vertex(new_id[facet[k]]);
      facets.push_back(corners);
    }
  }
};

}  // namespace sinkmesh
