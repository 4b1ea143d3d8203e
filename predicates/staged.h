// SPDX-License-Identifier: MIT
//
// The predicates of one gated point set, dimension-free, with the static filter inline: what core and refine
// call. Same signs as predicates.h; the box and the granularity of the set make most calls one comparison.
#pragma once

#include <cmath>
#include <cstddef>

#include "predicates/lanes.h"
#include "predicates/point.h"
#include "predicates/polynomials.h"
#include "predicates/verdict.h"

namespace sinkmesh {

namespace detail {

/// What a point set says about every value of P.
template <class P>
struct Filter {
  double error = 0;  ///< of the rounded value
  double unit = 0;   ///< divides the exact value; 0 where it would underflow

  void update(const Point<P::kDim>& extents, int granularity);
};

template <int Dim>
struct Filters : Filter<Orientation<Dim>>,
                 Filter<InSphere<Dim>>,
                 Filter<Diametral<Dim>>,
                 Filter<FacetNormals<Dim>>,
                 Filter<Orthogonality<Dim>> {};

}  // namespace detail

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
  int orient(const Corners<Dim>& s) const { return verdict<detail::Orientation<Dim>>(s).sign; }

  /// Perturbed, never 0: +1 if x is strictly inside the circumsphere of the positively oriented s.
  int in_sphere(const Corners<Dim>& s, const Point<Dim>& x) const {
    const auto points = join<Dim + 2>(s, x);
    const detail::Verdict v = verdict<detail::InSphere<Dim>>(points);
    return v.sign != 0 ? v.sign : in_sphere_at_tie(points);
  }

  /// Unperturbed: +1 if x is strictly inside the circumsphere of the positively oriented s, 0 if on it.
  int in_sphere_unperturbed(const Corners<Dim>& s, const Point<Dim>& x) const {
    return verdict<detail::InSphere<Dim>>(join<Dim + 2>(s, x)).sign;
  }

  /// Unperturbed: -1 if x is strictly inside the diametral sphere of the facet.
  int diametral_side(const FacetCorners<Dim>& facet, const Point<Dim>& x) const {
    return verdict<detail::Diametral<Dim>>(join<Dim + 1>(facet, x)).sign;
  }

  /// Perturbed, never 0: -1 if the simplex of facet and apex flows across the facet.
  int flow_side(const FacetCorners<Dim>& facet, const Point<Dim>& apex) const {
    const auto points = join<Dim + 1>(facet, apex);
    const detail::Verdict v = verdict<detail::Diametral<Dim>>(points);
    return v.sign != 0 ? v.sign : flow_at_tie(points);
  }

  /// Unperturbed: see orthogonality() in predicates.h.
  int orthogonality(const Corners<Dim>& s, const Corners<Dim>& t) const;

  /// The unperturbed sign of one polynomial, and the stage that proved it.
  template <class P>
  detail::Verdict verdict(const detail::Points<P>& points) const {
    const detail::Filter<P>& filter = filters_;
    const double value = detail::rounded_value<P>(points);
    if (std::abs(value) > filter.error) [[likely]]
      return {value > 0 ? 1 : -1, detail::Stage::kStatic};
    return detail::decide_after_static<P>(points, value, filter.unit);
  }

 private:
  template <std::size_t N>
  static std::array<const Point<Dim>*, N> join(const std::array<const Point<Dim>*, N - 1>& points,
                                               const Point<Dim>& last) {
    std::array<const Point<Dim>*, N> result;
    for (std::size_t i = 0; i + 1 < N; ++i) result[i] = points[i];
    result[N - 1] = &last;
    return result;
  }

  int in_sphere_at_tie(const detail::Points<detail::InSphere<Dim>>& points) const;
  int flow_at_tie(const detail::Points<detail::Diametral<Dim>>& points) const;
  void update();

  Box<Dim> box_;
  int granularity_;
  detail::Filters<Dim> filters_;
};

extern template class Predicates<2>;
extern template class Predicates<3>;

}  // namespace sinkmesh
