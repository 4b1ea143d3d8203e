// SPDX-License-Identifier: MIT
//
// Which sink each simplex belongs to: the watersheds of phi_S [EG01, 3.3].
#pragma once

#include <cstdint>
#include <vector>

#include "refine/flow.h"

namespace sinkmesh {

/// One sink for every simplex.
///
/// In the plane it is the only one, so maximal ancestor sets are disjoint: a triangle has at most one
/// successor. At least two of its angles are acute. The barycentric coordinates of the circumcenter, sin(2
/// angle) up to a positive factor, are positive at these corners, and stay so under infinitesimal weights. So
/// the flow crosses at most the edge opposite the third corner.
///
/// In space they overlap. The label is then the sink of the steepest flow, which prefers at every simplex the
/// successor with the largest circumsphere among those that do not lead to omega only; SinkWalk meets it first.
template <int Dim>
struct Watersheds {
  /// The label of what flows to omega only, and of ghosts.
  static constexpr std::int32_t kOmega = -1;

  std::vector<Simplex> sinks;       ///< by index
  std::vector<std::int32_t> label;  ///< by simplex: a position in `sinks`, or kOmega

  std::int32_t operator[](Simplex s) const { return label[s.index()]; }
};

/// Linear in the complex: every simplex is looked at once, after its successors.
template <int Dim>
Watersheds<Dim> find_watersheds(Flow<Dim>& flow);

/// The number of sinks in whose ancestor set a simplex is, by simplex; 0 for ghosts. Sink simplices are
/// counted: in a degenerate set several can have the same circumcenter. Cost: the sum of the results.
template <int Dim>
std::vector<std::uint32_t> count_sinks(Flow<Dim>& flow);

/// The facets between simplices of different labels, hull facets of labelled simplices included; each once, as
/// half-facet of its solid simplex, or of the one with the smaller index. Linear.
/// The boundary of a single ancestor set: boundary(complex, flow.ancestors({sink})), see core/star.h.
template <int Dim>
std::vector<HalfFacet> watershed_boundaries(const Complex<Dim>& complex, const Watersheds<Dim>& watersheds);

}  // namespace sinkmesh
