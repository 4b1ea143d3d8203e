// SPDX-License-Identifier: MIT
//
// Every stage of the predicates alone, for any polynomial P. A stage returns a sign that it has proved, or
// kUndecided. The derivations use u = 2^-53 and that rounding is monotone: r <= s implies fl(r) <= fl(s).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "predicates/detail/expansion.h"
#include "predicates/detail/rings.h"
#include "predicates/detail/rounding.h"
#include "predicates/detail/scaled_integers.h"
#include "predicates/verdict.h"

namespace sinkmesh::detail {

inline constexpr int kUndecided = 2;

/// Static, local and permanent stage: the sign of any number within `error` of `value`. Written so that a NaN
/// or an infinite error decides nothing. A value and an error that underflowed are both multiples of 2^-1074,
/// and so is the true error behind the rounded one: value > error still implies value > true error.
inline int by_error(double value, double error) {
  if (value > error) return 1;
  if (value < -error) return -1;
  return kUndecided;
}

/// Granularity stage: a multiple of `unit` smaller than unit is 0. fl(|value| + error) < unit implies that the
/// real sum is below unit, because unit is a double and rounding is monotone. unit == 0 switches the stage off.
inline int by_granularity(double value, double error, double unit) {
  return std::abs(value) + error < unit ? 0 : kUndecided;
}

/// Error of the rounded value, from the largest difference along every axis.
template <class P>
double local_error(const Vectors<P, double>& v) {
  Point<P::kDim> extents{};
  for (const auto& vector : v) {
    for (std::size_t k = 0; k < P::kDim; ++k) extents[k] = std::max(extents[k], std::abs(vector[k]));
  }
  return error_within<P>(extents);
}

/// Error of the rounded value, from the permanent of the same expression [PS, 0].
template <class P>
double permanent_of(const Vectors<P, double>& v) {
  Vectors<P, Magnitude> magnitudes;
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (std::size_t k = 0; k < P::kDim; ++k) magnitudes[i][k] = {std::abs(v[i][k])};
  }
  return P::value(magnitudes).value;
}
template <class P>
double permanent_error(const Vectors<P, double>& v) {
  return P::kErrorBound * permanent_of<P>(v);
}

/// Box stage: a position of the points that makes P vanish whatever their coordinates are.
template <class P>
int by_box(const Points<P>& points) {
  if constexpr (requires { P::is_zero(points); }) {
    if (P::is_zero(points)) return 0;
  }
  return kUndecided;
}

/// Integer stages (Bits = kBits64, kBits128): P is homogeneous, so a positive scale does not change its sign.
template <class P, int Bits>
int by_integers(const Points<P>& points) {
  Vectors<P, FixedInt<Bits>> v;
  if (scaled_integers<P, Bits>(points, v) == 0) return kUndecided;
  return P::value(v).sign();
}

/// Every difference as head + tail, exactly.
template <class P>
Vectors<P, TwoTerms> exact_vectors(const Points<P>& p) {
  Vectors<P, TwoTerms> v;
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (std::size_t k = 0; k < P::kDim; ++k) {
      v[i][k] = two_diff((*p[P::kVectors[i].from])[k], (*p[P::kVectors[i].to])[k]);
    }
  }
  return v;
}

/// What the error of the first expansion stage is bounded by, as a multiple of the permanent.
template <class P>
constexpr double first_order_error() {
  return kUnit * kUnit * (P::kDegree * P::kDegree + 64 * P::kDegree);
}

/// First expansion stage: P at the rounded differences h, exactly, plus its derivative in the direction of
/// their tails t, rounded (stages B and C of [S97, Sec. 4], for any polynomial).
///
/// With degree k, permanent Q of |h|, and |t| <= u |h|:
///   |p(h+t) - p(h) - p'(h) t|  <=  ((1+u)^k - 1 - k u) Q  <=  (k(k-1)/2) (1+u)^k u^2 Q;
///   the rounded p'(h) t has at most twice as many roundings on a path as p(h), of which there are at most 30,
///   and majorant k u Q:  its error is at most 61 k u^2 Q.
/// The sum is below (k^2 + 64 k) u^2 Q, with room for the roundings of Q and of the bound. Adding the bound
/// exactly and comparing signs avoids the error of an estimate of the expansion.
template <class P>
int by_first_order(const Points<P>& points) {
  const Vectors<P, TwoTerms> exact = exact_vectors<P>(points);
  Vectors<P, Expansion> heads;
  Vectors<P, Dual> duals;
  Vectors<P, double> rounded;
  bool has_tail = false;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (std::size_t k = 0; k < P::kDim; ++k) {
      heads[i][k] = Expansion(exact[i][k].head);
      duals[i][k] = {exact[i][k].head, exact[i][k].tail};
      rounded[i][k] = exact[i][k].head;
      has_tail |= exact[i][k].tail != 0;
    }
  }
  const Expansion value = P::value(heads);
  if (!has_tail) return value.sign();
  const Expansion error(first_order_error<P>() * permanent_of<P>(rounded));
  const Expansion corrected = value + Expansion(P::value(duals).slope);
  const int low = (corrected - error).sign();
  const int high = (corrected + error).sign();
  return low == high && low != 0 ? low : kUndecided;
}

/// Second expansion stage: P exactly (stage D of [S97, Sec. 4]).
template <class P>
int by_expansions(const Points<P>& points) {
  const Vectors<P, TwoTerms> exact = exact_vectors<P>(points);
  Vectors<P, Expansion> v;
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (std::size_t k = 0; k < P::kDim; ++k) v[i][k] = Expansion(exact[i][k]);
  }
  return P::value(v).sign();
}

}  // namespace sinkmesh::detail
