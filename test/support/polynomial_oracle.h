// SPDX-License-Identifier: MIT
//
// Connects the polynomials of the predicates module with the oracle and with the public functions, so that one
// test can run over all of them.
#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "predicates/polynomials.h"
#include "predicates/predicates.h"
#include "test/support/exact_signs.h"

namespace sinkmesh::test {

template <class P>
detail::Points<P> pointers(const std::vector<Point<P::kDim>>& points) {
  detail::Points<P> p;
  for (std::size_t i = 0; i < P::kPoints; ++i) p[i] = &points[i];
  return p;
}

/// The exact value of a polynomial.
struct ExactValue {
  int sign;
  double magnitude;
};

template <int Dim>
ExactValue exact_value(detail::Orientation<Dim>, const ExactPoints<Dim>& p) {
  const Exact e = exact_orientation<Dim>(p);
  return {e.sign(), e.magnitude()};
}
template <int Dim>
ExactValue exact_value(detail::InSphere<Dim>, const ExactPoints<Dim>& p) {
  const Exact e = exact_in_sphere<Dim>(p);
  return {e.sign(), e.magnitude()};
}
template <int Dim>
ExactValue exact_value(detail::Diametral<Dim>, const ExactPoints<Dim>& p) {
  const Exact e = exact_diametral<Dim>(p);
  return {e.sign(), e.magnitude()};
}
/// The oracle's value is this polynomial times 2 d1 d2.
template <int Dim>
ExactValue exact_value(detail::Orthogonality<Dim>, const ExactPoints<Dim>& p) {
  const Exact e = exact_orthogonality<Dim>(p);
  const Exact d{2 * exact_volume<Dim>(p, 0) * exact_volume<Dim>(p, Dim + 1), 2 * Dim * p.shift()};
  return {e.sign() * d.sign(), d.sign() == 0 ? 0 : e.magnitude() / d.magnitude()};
}
template <class P>
ExactValue exact_value(const std::vector<Point<P::kDim>>& points) {
  return exact_value(P{}, ExactPoints<P::kDim>(points));
}

template <class P>
constexpr bool kIsOrthogonality = std::is_same_v<P, detail::Orthogonality<P::kDim>>;

/// The oracle for orthogonality needs simplices of nonzero volume; the others take everything.
template <class P>
bool in_domain(const std::vector<Point<P::kDim>>& points) {
  if (!kIsOrthogonality<P>) return true;
  const ExactPoints<P::kDim> p(points);
  return exact_volume<P::kDim>(p, 0) != 0 && exact_volume<P::kDim>(p, P::kDim + 1) != 0;
}

/// The public functions for raw doubles. Orthogonality: of the value, not of the polynomial.
inline int public_sign(detail::Orientation<2>, const std::vector<Point2>& p) {
  return orient2d(p[0], p[1], p[2]);
}
inline int public_sign(detail::Orientation<3>, const std::vector<Point3>& p) {
  return orient3d(p[0], p[1], p[2], p[3]);
}
inline int public_sign(detail::InSphere<2>, const std::vector<Point2>& p) {
  return incircle(p[0], p[1], p[2], p[3]);
}
inline int public_sign(detail::InSphere<3>, const std::vector<Point3>& p) {
  return insphere(p[0], p[1], p[2], p[3], p[4]);
}
inline int public_sign(detail::Diametral<2>, const std::vector<Point2>& p) {
  return diametral_side(p[0], p[1], p[2]);
}
inline int public_sign(detail::Diametral<3>, const std::vector<Point3>& p) {
  return diametral_side(p[0], p[1], p[2], p[3]);
}
inline int public_sign(detail::Orthogonality<2>, const std::vector<Point2>& p) {
  return orthogonality({p[0], p[1], p[2]}, {p[3], p[4], p[5]});
}
inline int public_sign(detail::Orthogonality<3>, const std::vector<Point3>& p) {
  return orthogonality({p[0], p[1], p[2], p[3]}, {p[4], p[5], p[6], p[7]});
}
inline int public_sos(const std::vector<Point2>& p, detail::InSphere<2>) {
  return incircle_sos(p[0], p[1], p[2], p[3]);
}
inline int public_sos(const std::vector<Point3>& p, detail::InSphere<3>) {
  return insphere_sos(p[0], p[1], p[2], p[3], p[4]);
}
inline int public_sos(const std::vector<Point2>& p, detail::Diametral<2>) {
  return diametral_side_sos(p[0], p[1], p[2]);
}
inline int public_sos(const std::vector<Point3>& p, detail::Diametral<3>) {
  return diametral_side_sos(p[0], p[1], p[2], p[3]);
}

}  // namespace sinkmesh::test
