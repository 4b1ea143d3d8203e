// SPDX-License-Identifier: MIT
//
// Insertion by flips [EG01, 4.3; J91; ES96].
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/complex.h"
#include "core/location.h"
#include "core/retriangulator.h"
#include "predicates/staged.h"

namespace sinkmesh {

/// Inserts one vertex p after the other: subdivides the simplex that holds it, or the star of the face that
/// does, and then flips outer simplices that are in conflict with p into its star. Slower than star
/// substitution, and independent of it: what one gets wrong the other does not. Holds working memory only; keep
/// one and reuse it.
///
/// A flip is a change of the triangulation of the Dim+2 points sigma + p, for an outer simplex sigma behind a
/// link facet of p. The signs of the barycentric coordinates of p in sigma divide its corners into negative
/// (N), zero (Z) and positive (P) ones, and the points without Z can be triangulated in two ways: by leaving
/// out one of N + p, which is what is there, or one of P, which is what comes. So sigma and its neighbours
/// across the facets opposite N go, and sigma with each of P replaced by p comes: 2-3 for one negative corner,
/// 3-2 for two. With a zero corner y the same happens on both sides of the facet opposite y at once: 4-4. All
/// of it holds with ghosts, whose corner at infinity counts as positive.
///
/// Why it ends: each flip takes away an outer simplex, and all that it brings are in the star of p. Why it is
/// never stuck before all is Delaunay: among the outer simplices in conflict, the one whose lifted hyperplane p
/// meets first when its lifted point descends can be flipped [ES96; PS, 3]; a facet that cannot be flipped now
/// is looked at again from a new link facet when a neighbour has joined the star.
template <int Dim>
class FlipInserter {
 public:
  /// Inserts v, whose coordinates are in the complex already, at the place where walk_to() found it.
  /// Requires a Delaunay triangulation, and that v is at no corner.
  /// @throws CapacityError, std::bad_alloc; the complex is then a triangulation, but need not be Delaunay.
  void insert(Complex<Dim>& complex, const Predicates<Dim>& predicates, const Location<Dim>& at, Vertex v);

  /// Flips since construction, by the number of simplices before and after.
  struct Counts {
    std::size_t subdivisions = 0;
    std::size_t two_to_two = 0;  ///< in the plane
    std::size_t two_to_three = 0;
    std::size_t three_to_two = 0;
    std::size_t four_to_four = 0;
  };
  const Counts& counts() const { return counts_; }

 private:
  using CornerSet = std::array<bool, Dim + 1>;

  void subdivide(const Location<Dim>& at);
  void flip_link_facet(Simplex t);
  void flip_solid(Simplex sigma);
  void flip_ghost(Simplex sigma);
  void flip(Simplex sigma, const CornerSet& negative, const CornerSet& positive);
  bool is_behind_link_facet(Simplex s, int corner) const;
  void add_with_replaced(Simplex s, Vertex replaced);
  void replace();

  Complex<Dim>* complex_ = nullptr;
  const Predicates<Dim>* predicates_ = nullptr;
  Vertex v_;
  std::uint32_t stamp_ = 0;  // of the vertices that are adjacent to v

  Retriangulator<Dim> retriangulator_;
  std::vector<Simplex> stack_;  // simplices of the star of v whose link facet is to be looked at
  std::vector<Simplex> old_;
  std::vector<std::array<Vertex, Dim + 1>> fresh_;
  Counts counts_;
};

extern template class FlipInserter<2>;
extern template class FlipInserter<3>;

}  // namespace sinkmesh
