// SPDX-License-Identifier: MIT
//
// The predicates of one gated point set, dimension-free, with the static filter inline: what core and refine
// call. Same signs as predicates.h; the box and the granularity of the set make most calls one comparison.
#pragma once

#include "predicates/point.h"

namespace sinkmesh {

/// Laws and conventions: predicates.h. Every point passed in must have been covered by the box given to the
/// constructor or to include(); include() must come first, never after the call.
template <int Dim>
class Predicates {
 public:
  /// @param box          holds every point, in gated coordinates.
  /// @param granularity  every coordinate is a multiple of 2^-granularity (the input gate knows it).
  Predicates(const Box<Dim>& box, int granularity);

  /// Makes p a legal argument. A point outside the box enlarges it, and a point that is not a multiple of the
  /// granularity ends the certificates of zero that rest on it.
  void include(const Point<Dim>& p);

  /// Sign of the signed volume; 0 is an answer.
  int orient(const Corners<Dim>& s) const;
  /// Perturbed, never 0: +1 if x is strictly inside the circumsphere of the positively oriented s.
  int in_sphere(const Corners<Dim>& s, const Point<Dim>& x) const;
  /// Unperturbed: -1 if x is strictly inside the diametral sphere of the facet.
  int diametral_side(const FacetCorners<Dim>& facet, const Point<Dim>& x) const;
  /// Perturbed, never 0: -1 if the simplex of facet and apex flows across the facet.
  int flow_side(const FacetCorners<Dim>& facet, const Point<Dim>& apex) const;
  /// Unperturbed: see orthogonality() in predicates.h.
  int orthogonality(const Corners<Dim>& s, const Corners<Dim>& t) const;
};

}  // namespace sinkmesh
