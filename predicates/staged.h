// SPDX-License-Identifier: MIT
//
// The predicates of one gated point set, dimension-free, with the static filter inline: what core and refine
// call. Same signs as predicates.h; the box and the granularity of the set make most calls one comparison.
#pragma once

#include <array>
#include <type_traits>

#include "predicates/detail/stages.h"
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
  void include(const Point<Dim>& p) {
    if (!box_.contains(p)) enlarge(p);
    if (is_granular_ && !is_multiple(p)) give_up_granularity();
  }

  /// Sign of the signed volume; 0 is an answer.
  int orient(const Corners<Dim>& s) const {
    const double value = Orient::value(detail::differences<Orient>(s));
    if (value > orient_.error) return 1;
    if (value < -orient_.error) return -1;
    return orient_exactly(s);
  }

  /// Perturbed, never 0: +1 if x is strictly inside the circumsphere of the positively oriented s.
  int in_sphere(const Corners<Dim>& s, const PointArg<Dim>& x) const {
    const auto points = append(s, x);
    const double value = InSphere::value(detail::differences<InSphere>(points));
    if (value > in_sphere_.error) return 1;
    if (value < -in_sphere_.error) return -1;
    return in_sphere_exactly(points);
  }

  /// Unperturbed: -1 if x is strictly inside the diametral sphere of the facet.
  int diametral_side(const FacetCorners<Dim>& facet, const PointArg<Dim>& x) const {
    const auto points = append(facet, x);
    const double value = Diametral::value(detail::differences<Diametral>(points));
    if (value > diametral_.error) return 1;
    if (value < -diametral_.error) return -1;
    return diametral_side_exactly(points);
  }

  /// Perturbed, never 0: -1 if the simplex of facet and apex flows across the facet.
  int flow_side(const FacetCorners<Dim>& facet, const PointArg<Dim>& apex) const {
    const auto points = append(facet, apex);
    const double value = Diametral::value(detail::differences<Diametral>(points));
    if (value > diametral_.error) return 1;
    if (value < -diametral_.error) return -1;
    return flow_side_exactly(points);
  }

  /// Unperturbed: see orthogonality() in predicates.h.
  int orthogonality(const Corners<Dim>& s, const Corners<Dim>& t) const;

 private:
  using Orient = std::conditional_t<Dim == 2, detail::Orient2d, detail::Orient3d>;
  using InSphere = std::conditional_t<Dim == 2, detail::Incircle, detail::Insphere>;
  using Diametral = std::conditional_t<Dim == 2, detail::DiametralCircle, detail::DiametralSphere>;

  /// What is known of a form over the whole set.
  struct Known {
    double error = 0;  ///< of its rounded value, for all points in the box
    double grain = 0;  ///< its exact value is a multiple; 0: nothing known
  };

  template <std::size_t N>
  static std::array<const Point<Dim>*, N + 1> append(const std::array<const Point<Dim>*, N>& points,
                                                     const Point<Dim>& x) {
    std::array<const Point<Dim>*, N + 1> all;
    for (std::size_t i = 0; i < N; ++i) all[i] = points[i];
    all[N] = &x;
    return all;
  }

  void enlarge(const Point<Dim>& p);
  void set_errors();
  bool is_multiple(const Point<Dim>& p) const;
  void give_up_granularity();

  int orient_exactly(const typename Orient::Points& points) const;
  int in_sphere_exactly(const typename InSphere::Points& points) const;
  int diametral_side_exactly(const typename Diametral::Points& points) const;
  int flow_side_exactly(const typename Diametral::Points& points) const;

  Known orient_;
  Known in_sphere_;
  Known diametral_;
  Box<Dim> box_;
  double per_grain_ = 0;  // 2^granularity
  bool is_granular_ = true;
};

extern template class Predicates<2>;
extern template class Predicates<3>;

}  // namespace sinkmesh
