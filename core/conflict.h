// SPDX-License-Identifier: MIT
//
// Is a simplex, solid or ghost, in conflict with a point?
#pragma once

#include "core/complex.h"
#include "predicates/staged.h"

namespace sinkmesh {

/// The corners of a ghost with x in the place of infinity: positively oriented if x lies strictly beyond the
/// ghost's hull facet.
template <int Dim>
Corners<Dim> corners_towards(const Complex<Dim>& complex, Simplex ghost, const PointArg<Dim>& x) {
  Corners<Dim> corners = complex.corners(ghost);
  corners[Dim] = &x;
  return corners;
}

/// A ghost is in conflict with x if x lies strictly beyond its hull facet, and not if strictly on the inner
/// side. In the plane of the facet the answer is that of the solid neighbour: its circumsphere cuts that plane
/// in the same circle, and its apex does not enter the perturbation either [PS, 3].
template <int Dim>
[[gnu::noinline]] bool ghost_in_conflict(const Complex<Dim>& complex, const Predicates<Dim>& predicates,
                                         Simplex ghost, const PointArg<Dim>& x) {
  const int side = predicates.orient(corners_towards(complex, ghost, x));
  if (side != 0) return side > 0;
  return predicates.in_sphere(complex.corners(complex.neighbor(ghost, Dim)), x) > 0;
}

/// Whether the perturbed open circumball of s holds x. Requires x distinct from the corners of s.
template <int Dim>
bool in_conflict(const Complex<Dim>& complex, const Predicates<Dim>& predicates, Simplex s,
                 const PointArg<Dim>& x) {
  if (complex.is_ghost(s)) [[unlikely]] {
    return ghost_in_conflict(complex, predicates, s, x);
  }
  return predicates.in_sphere(complex.corners(s), x) > 0;
}

}  // namespace sinkmesh
