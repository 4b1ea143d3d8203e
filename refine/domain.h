// SPDX-License-Identifier: MIT
//
// Which simplices are inside: the part of the complex that is meshed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/triangulation.h"
#include "refine/flow.h"
#include "refine/surface.h"

namespace sinkmesh {

/// A set of solid simplices of a triangulation; its boundary is the set of facets between inside and outside.
/// Whoever replaces simplices labels the new ones.
template <int Dim>
class Domain {
 public:
  /// The facets of a surface, as vertices of a triangulation.
  using Facet = std::array<Vertex, Dim>;

  /// Everything outside.
  explicit Domain(const Triangulation<Dim>& triangulation)
      : triangulation_(&triangulation), inside_(triangulation.complex().num_slots(), 0) {}

  /// Labels by parity: a simplex is inside if a path to it from the outside crosses the surface an odd number
  /// of times. Orientation does not matter, so a cavity inside a solid is outside whichever way its facets are
  /// turned.
  ///
  /// @param facets  of a surface in which every ridge has an even number of facets.
  /// @return the facets, by index, that are no facets of the triangulation; unless empty, nothing was labelled.
  /// @throws InputError if parities contradict each other: the surface is not closed.
  /// Cost: linear in the complex.
  [[nodiscard]] std::vector<std::size_t> label_by_parity(std::span<const Facet> facets);

  struct Peeled {
    std::size_t simplices = 0;  ///< taken away
    std::size_t facets = 0;     ///< facets of the boundary that no longer are
  };
  /// Shrinks the domain to its maximal stable subcomplex [EG01, 5.1]: takes away every simplex that flows,
  /// directly or not, to the outside. What remains is the largest part from which no flow leads out: a union of
  /// parts with that property has it, too. One reverse search, linear in what is taken away and the boundary.
  Peeled peel(Flow<Dim>& flow);

  bool is_inside(Simplex s) const { return s.index() < inside_.size() && inside_[s.index()] != 0; }
  void set_inside(Simplex s, bool inside) {
    if (s.index() >= inside_.size()) inside_.resize(triangulation_->complex().num_slots(), 0);
    inside_[s.index()] = inside ? 1 : 0;
  }

  /// Inside simplices, by index. Linear.
  std::vector<Simplex> simplices() const;
  /// Facets of the boundary, each as the half-facet of its inside simplex. Linear.
  std::vector<HalfFacet> boundary() const;

 private:
  std::vector<HalfFacet> find(std::span<const Facet> facets) const;

  const Triangulation<Dim>* triangulation_;
  std::vector<std::uint8_t> inside_;
};

}  // namespace sinkmesh
