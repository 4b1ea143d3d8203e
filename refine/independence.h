// SPDX-License-Identifier: MIT
//
// Can two points be inserted without noticing each other [EG01, 4.4]?
#pragma once

#include <span>

#include "core/star.h"
#include "core/triangulation.h"

namespace sinkmesh {

/// Whether the closures of two prestars are disjoint: closures are complexes, so they are iff they share no
/// vertex; sharing no simplex or no facet is not enough. Log-linear in the prestars.
template <int Dim>
bool have_disjoint_closures(const Complex<Dim>& complex, std::span<const Simplex> prestar_of_x,
                            std::span<const Simplex> prestar_of_y);

/// Whether x and y are independent: inserting one leaves the closed prestar of the other as it is. For points
/// strictly inside the hull and distinct from all vertices; a point on the hull has ghosts in its prestar, and
/// two such points share the vertex at infinity. For the weaker conditions that follow [EG01, Independence
/// Lemma] see the tests: of
///   I    x and y are independent,
///   II   the edge xy is not in D_xy,
///   III  x is not in the interior of Fl St y in D_y,
///   IV   x is not in the interior of Fl Pt y in D,
/// each implies the next. In general position II and III are equivalent, beyond the paper: the edge xy is in
/// D_xy iff y is in the closure of Pt x in D_y, which holds iff y is a corner of a simplex of D_y whose ball
/// holds x. For cospherical points III does not imply II.
///
/// @param triangulation  is as before at the return; x and y have been announced to its predicates.
/// @param x, y           gated coordinates.
template <int Dim>
bool are_independent(Triangulation<Dim>& triangulation, const PointArg<Dim>& x, const PointArg<Dim>& y);

/// Whether the circumspheres of two solid simplices are orthogonal or further than that [EG01, 4.4]: their
/// centers are then at least as far apart as the larger radius. Exact.
template <int Dim>
bool are_orthogonal_or_further(const Triangulation<Dim>& triangulation, Simplex s, Simplex t) {
  const Complex<Dim>& complex = triangulation.complex();
  return triangulation.predicates().orthogonality(complex.corners(s), complex.corners(t)) >= 0;
}

}  // namespace sinkmesh
