// SPDX-License-Identifier: MIT
//
// Whether refinement can keep a surface as it is.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "refine/patches.h"
#include "refine/quality.h"
#include "refine/surface.h"

namespace sinkmesh::program {

struct SurfaceFit {
  explicit SurfaceFit(double max_ratio) : quality(max_ratio) {}

  /// Facets, by index, that are not in the Delaunay triangulation of the vertices. If there are any, nothing is
  /// known of what is inside.
  std::vector<std::size_t> missing;
  /// Two facets that meet at so small an angle that refine does not divide them.
  std::optional<Fold> too_sharp;
  /// Facets through which the flow leads from the inside to the outside.
  std::size_t unstable = 0;
  /// Vertices used by facets.
  std::size_t vertices = 0;
  /// Of all simplices inside.
  QualityStatistics quality;
  /// With a fixed boundary: simplices that would be peeled off, since the flow leads out from them; and the
  /// facets that go with them.
  std::size_t peeled_simplices = 0;
  std::size_t peeled_facets = 0;
};

/// Requires a surface for which check_surface() finds no error.
template <int Dim>
SurfaceFit fit(const Surface<Dim>& surface, double max_ratio);

}  // namespace sinkmesh::program
