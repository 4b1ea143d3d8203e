// SPDX-License-Identifier: MIT
//
// Of which facet of the surface a sub-facet is a part.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "refine/boundary.h"
#include "refine/box_forest.h"

namespace sinkmesh {

/// Sub-facets of a patch of several facets are flipped and divided with no regard to these; so the facet that
/// holds the center of a sub-facet, in the projection of the patch, is looked for.
template <int Dim>
class Parents {
 public:
  /// @param facets  of the surface.
  Parents(const Boundary<Dim>& boundary, std::span<const std::array<Vertex, Dim>> facets);

  /// Cost: constant for a whole facet, and in a patch of one; else about logarithmic, the first time
  /// log-linear.
  std::uint32_t of(SubFacet f);

 private:
  const Boundary<Dim>* boundary_;
  std::span<const std::array<Vertex, Dim>> facets_;
  std::optional<BoxForest<Dim>> boxes_;  // from the first need on
};

extern template class Parents<2>;
extern template class Parents<3>;

}  // namespace sinkmesh
