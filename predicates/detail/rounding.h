// SPDX-License-Identifier: MIT
//
// Rounding errors that are themselves doubles [S97, Sec. 2]. Exact in round-to-nearest unless a result
// overflows, and for products unless the error lies below 2^-1074.
#pragma once

#include <cmath>

#include "predicates/build_guard.h"

namespace sinkmesh::detail {

/// head = the rounded result; head + tail = the exact one.
struct TwoTerms {
  double head;
  double tail;
};

/// Requires |a| >= |b| or a == 0.
inline TwoTerms fast_two_sum(double a, double b) {
  const double head = a + b;
  return {head, b - (head - a)};
}

inline TwoTerms two_sum(double a, double b) {
  const double head = a + b;
  const double b_part = head - a;
  const double a_part = head - b_part;
  return {head, (a - a_part) + (b - b_part)};
}

inline TwoTerms two_diff(double a, double b) {
  const double head = a - b;
  const double b_part = a - head;
  const double a_part = head + b_part;
  return {head, (a - a_part) + (b_part - b)};
}

#ifdef __FMA__
inline TwoTerms two_product(double a, double b) {
  const double head = a * b;
  return {head, std::fma(a, b, -head)};
}
#else
/// The upper 26 bits of a and the rest; |a| < 2^996.
inline TwoTerms split(double a) {
  const double c = 0x1.0000002p+27 * a;  // 2^27 + 1
  const double head = c - (c - a);
  return {head, a - head};
}

inline TwoTerms two_product(double a, double b) {
  const double head = a * b;
  const TwoTerms x = split(a);
  const TwoTerms y = split(b);
  const double rest = ((head - x.head * y.head) - x.tail * y.head) - x.head * y.tail;
  return {head, x.tail * y.tail - rest};
}
#endif

}  // namespace sinkmesh::detail
