// SPDX-License-Identifier: MIT
//
// The flow relation: from a simplex to the neighbours on whose side its circumcenter lies [EG01, 3.3].
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/triangulation.h"

namespace sinkmesh {

/// tau precedes sigma when they share a facet and the circumcenter of tau lies strictly beyond it, after the
/// perturbation that also decides the Delaunay complex: no tie is left, the relation is acyclic, and every
/// simplex reaches a sink or omega, the outside [PS, 2]. Omega is any ghost; a ghost has no successor.
///
/// The bits of a simplex are computed at first need and kept; whoever replaces simplices of the complex calls
/// forget() for the new ones. One byte per simplex, and four more once a search has run.
template <int Dim>
class Flow {
 public:
  explicit Flow(const Triangulation<Dim>& triangulation) : triangulation_(&triangulation) {}

  /// Whether the simplex of h flows across h.
  bool crosses(HalfFacet h) {
    std::uint8_t& bits = bits_of(Complex<Dim>::simplex_of(h));
    const int i = Complex<Dim>::corner_of(h);
    if (!(bits >> i & 1)) bits = static_cast<std::uint8_t>(bits | evaluate(h) << i);
    return bits >> (i + 4) & 1;
  }

  /// Whether s contains its own circumcenter. Ghosts are no sinks.
  bool is_sink(Simplex s) {
    if (complex().is_ghost(s)) return false;
    for (int i = 0; i <= Dim; ++i) {
      if (crosses(Complex<Dim>::half_facet(s, i))) return false;
    }
    return true;
  }

  /// The neighbours that s flows into, at most Dim; in the plane at most one, because its flow crosses the edge
  /// opposite an obtuse angle. Omega is a successor as any ghost; a ghost has none.
  std::vector<Simplex> successors(Simplex s);

  /// All sinks of the complex, by index. Linear.
  std::vector<Simplex> sinks();

  /// The sinks that can be reached from any of the sources: for a single source, its set of sinks [EG01, 3.3].
  /// One search for all, linear in what it reaches; each simplex is looked at once. In the order of the search.
  std::vector<Simplex> sinks_reached(const std::vector<Simplex>& sources);

  /// The simplices from which any of the targets can be reached, the targets first: for one sink, its ancestor
  /// set; for all ghosts, what flows to omega. Linear in the result. In the order of the search.
  std::vector<Simplex> ancestors(const std::vector<Simplex>& targets);

  /// The bits of s are computed anew when they are next needed.
  void forget(Simplex s) { bits_of(s) = 0; }

  const Complex<Dim>& complex() const { return triangulation_->complex(); }

 private:
  std::uint8_t& bits_of(Simplex s) {
    if (s.index() >= bits_.size()) bits_.resize(complex().num_slots(), 0);
    return bits_[s.index()];
  }
  /// The known bit, and the flow bit four places up.
  unsigned evaluate(HalfFacet h) const;

  /// Begins a search; meet() then says whether it has not seen s yet. Starting costs nothing: many small
  /// searches, as for all ancestor sets, are linear in what they find.
  void begin_search();
  bool meet(Simplex s) { return std::exchange(seen_[s.index()], search_) != search_; }

  const Triangulation<Dim>* triangulation_;
  std::vector<std::uint8_t> bits_;
  std::vector<std::uint32_t> seen_;  // by simplex: the last search that met it
  std::uint32_t search_ = 0;
};

}  // namespace sinkmesh
