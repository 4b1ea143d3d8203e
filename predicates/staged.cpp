// SPDX-License-Identifier: MIT
#include "predicates/staged.h"

#include <cmath>

#include "predicates/detail/symbolic.h"

namespace sinkmesh {
namespace {

// g^k for g = 2^-granularity, as long as that is a normal double; 0 switches the certificate off.
double grain(int granularity, int degree) {
  return granularity * degree <= 1022 ? std::ldexp(1.0, -granularity * degree) : 0;
}

}  // namespace

template <int Dim>
Predicates<Dim>::Predicates(const Box<Dim>& box, int granularity)
    : box_(box), per_grain_(std::ldexp(1.0, granularity)) {
  orient_.grain = grain(granularity, Orient::kDegree);
  in_sphere_.grain = grain(granularity, InSphere::kDegree);
  diametral_.grain = grain(granularity, Diametral::kDegree);
  set_errors();
}

// Rounding is monotone: |fl(x - y)| <= fl(high - low) for all x, y in the box. So the extents bound all
// differences.
template <int Dim>
void Predicates<Dim>::set_errors() {
  std::array<double, Dim> extents;
  for (std::size_t k = 0; k < Dim; ++k) extents[k] = box_.high[k] - box_.low[k];
  orient_.error = detail::error_over<Orient>(extents);
  in_sphere_.error = detail::error_over<InSphere>(extents);
  diametral_.error = detail::error_over<Diametral>(extents);
}

template <int Dim>
void Predicates<Dim>::enlarge(const Point<Dim>& p) {
  box_.include(p);
  set_errors();
}

template <int Dim>
bool Predicates<Dim>::is_multiple(const Point<Dim>& p) const {
  for (const double x : p) {
    const double scaled = x * per_grain_;
    if (std::trunc(scaled) != scaled) return false;
  }
  return true;
}

template <int Dim>
void Predicates<Dim>::give_up_granularity() {
  is_granular_ = false;
  orient_.grain = in_sphere_.grain = diametral_.grain = 0;
}

template <int Dim>
int Predicates<Dim>::orient_exactly(const typename Orient::Points& points) const {
  return detail::exact_sign<Orient>(points, orient_.grain).sign;
}

template <int Dim>
int Predicates<Dim>::in_sphere_exactly(const typename InSphere::Points& points) const {
  const int sign = detail::exact_sign<InSphere>(points, in_sphere_.grain).sign;
  if (sign != 0) return sign;
  return detail::in_sphere_tie(points, [this](const Corners<Dim>& s) { return orient(s); });
}

template <int Dim>
int Predicates<Dim>::diametral_side_exactly(const typename Diametral::Points& points) const {
  return detail::exact_sign<Diametral>(points, diametral_.grain).sign;
}

template <int Dim>
int Predicates<Dim>::flow_side_exactly(const typename Diametral::Points& points) const {
  const int sign = diametral_side_exactly(points);
  return sign != 0 ? sign : detail::flow_tie(points);
}

template <int Dim>
int Predicates<Dim>::orthogonality(const Corners<Dim>& s, const Corners<Dim>& t) const {
  typename detail::Orthogonality<Dim>::Points points;
  for (std::size_t i = 0; i <= Dim; ++i) {
    points[i] = s[i];
    points[i + Dim + 1] = t[i];
  }
  const int sign = detail::exact_sign<detail::Orthogonality<Dim>>(points, 0).sign;
  return sign == 0 ? 0 : sign * orient(s) * orient(t);
}

template class Predicates<2>;
template class Predicates<3>;

}  // namespace sinkmesh
