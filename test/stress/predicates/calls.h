// SPDX-License-Identifier: MIT
//
// Every way to ask the library for the sign of a polynomial, by the polynomial.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "predicates/predicates.h"
#include "predicates/staged.h"
#include "predicates/verdict.h"

namespace sinkmesh::stress {

using detail::Diametral;
using detail::FacetNormals;
using detail::InSphere;
using detail::Orientation;
using detail::Orthogonality;
using detail::Points;

template <class P>
constexpr bool kIsInSphere = P::kPoints == P::kDim + 2;
template <class P>
constexpr bool kIsOrthogonality = P::kPoints == 2 * (P::kDim + 1);

// ------------------------------------------------------------------------------------------- raw doubles

inline int raw_sign(Orientation<2>, const Points<Orientation<2>>& p) { return orient2d(*p[0], *p[1], *p[2]); }
inline int raw_sign(Orientation<3>, const Points<Orientation<3>>& p) {
  return orient3d(*p[0], *p[1], *p[2], *p[3]);
}
inline int raw_sign(InSphere<2>, const Points<InSphere<2>>& p) { return incircle(*p[0], *p[1], *p[2], *p[3]); }
inline int raw_sign(InSphere<3>, const Points<InSphere<3>>& p) {
  return insphere(*p[0], *p[1], *p[2], *p[3], *p[4]);
}
inline int raw_sign(Diametral<2>, const Points<Diametral<2>>& p) { return diametral_side(*p[0], *p[1], *p[2]); }
inline int raw_sign(Diametral<3>, const Points<Diametral<3>>& p) {
  return diametral_side(*p[0], *p[1], *p[2], *p[3]);
}
/// No function of its own: it is what the tie rule of Diametral asks.
template <int Dim>
int raw_sign(FacetNormals<Dim>, const Points<FacetNormals<Dim>>& p) {
  return detail::decide<FacetNormals<Dim>>(p).sign;
}
/// Of the value; the polynomial has both volumes as factors.
inline int raw_sign(Orthogonality<2>, const Points<Orthogonality<2>>& p) {
  return orthogonality({*p[0], *p[1], *p[2]}, {*p[3], *p[4], *p[5]});
}
inline int raw_sign(Orthogonality<3>, const Points<Orthogonality<3>>& p) {
  return orthogonality({*p[0], *p[1], *p[2], *p[3]}, {*p[4], *p[5], *p[6], *p[7]});
}

inline int raw_sos(InSphere<2>, const Points<InSphere<2>>& p) {
  return incircle_sos(*p[0], *p[1], *p[2], *p[3]);
}
inline int raw_sos(InSphere<3>, const Points<InSphere<3>>& p) {
  return insphere_sos(*p[0], *p[1], *p[2], *p[3], *p[4]);
}
inline int raw_sos(Diametral<2>, const Points<Diametral<2>>& p) {
  return diametral_side_sos(*p[0], *p[1], *p[2]);
}
inline int raw_sos(Diametral<3>, const Points<Diametral<3>>& p) {
  return diametral_side_sos(*p[0], *p[1], *p[2], *p[3]);
}

// -------------------------------------------------------------------------------- predicates of a gated set

template <int N, std::size_t M, class T>
std::array<T, N> some_of(const std::array<T, M>& all, std::size_t first = 0) {
  std::array<T, N> some;
  std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(first), N, some.begin());
  return some;
}

template <int Dim>
int staged_sign(Orientation<Dim>, const Predicates<Dim>& predicates, const Points<Orientation<Dim>>& p) {
  return predicates.orient(p);
}
template <int Dim>
int staged_sign(InSphere<Dim>, const Predicates<Dim>& predicates, const Points<InSphere<Dim>>& p) {
  return predicates.in_sphere_unperturbed(some_of<Dim + 1>(p), *p.back());
}
template <int Dim>
int staged_sign(Diametral<Dim>, const Predicates<Dim>& predicates, const Points<Diametral<Dim>>& p) {
  return predicates.diametral_side(some_of<Dim>(p), *p.back());
}
template <int Dim>
int staged_sign(FacetNormals<Dim>, const Predicates<Dim>& predicates, const Points<FacetNormals<Dim>>& p) {
  return predicates.template verdict<FacetNormals<Dim>>(p).sign;
}
template <int Dim>
int staged_sign(Orthogonality<Dim>, const Predicates<Dim>& predicates, const Points<Orthogonality<Dim>>& p) {
  return predicates.orthogonality(some_of<Dim + 1>(p), some_of<Dim + 1>(p, Dim + 1));
}

template <int Dim>
int staged_sos(InSphere<Dim>, const Predicates<Dim>& predicates, const Points<InSphere<Dim>>& p) {
  return predicates.in_sphere(some_of<Dim + 1>(p), *p.back());
}
template <int Dim>
int staged_sos(Diametral<Dim>, const Predicates<Dim>& predicates, const Points<Diametral<Dim>>& p) {
  return predicates.flow_side(some_of<Dim>(p), *p.back());
}

}  // namespace sinkmesh::stress
