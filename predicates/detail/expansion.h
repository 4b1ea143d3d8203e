// SPDX-License-Identifier: MIT
//
// Expansions: unevaluated sums of doubles that represent real numbers exactly [S97, Sec. 2].
#pragma once

#include <initializer_list>
#include <vector>

#include "predicates/detail/rounding.h"

namespace sinkmesh::detail {

/// A ring of exact numbers. Exact while no intermediate product overflows and none has bits below 2^-1074
/// [PS, 11].
///
/// Invariant: the terms are nonzero, of increasing magnitude, and strongly nonoverlapping, so that the largest
/// one has the sign of the sum [S97, Sec. 2]. Zero has no terms.
///
/// The terms live on the heap: expansions are the last stage, for raw doubles whose exponents spread too far
/// for the fixed-width integers, and the lengths vary from one to hundreds.
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(double x) : Expansion(TwoTerms{x, 0}) {}
  /// Requires the result of one of the functions of rounding.h.
  explicit Expansion(TwoTerms x);

  friend Expansion operator+(const Expansion& a, const Expansion& b) { return sum(a, b, +1); }
  friend Expansion operator-(const Expansion& a, const Expansion& b) { return sum(a, b, -1); }
  friend Expansion operator*(const Expansion& a, const Expansion& b);

  int sign() const;
  const std::vector<double>& terms() const { return terms_; }

 private:
  static Expansion sum(const Expansion& a, const Expansion& b, double sign_of_b);
  Expansion scaled(double factor) const;
  void compress();
  void append(double term) {
    if (term != 0) terms_.push_back(term);
  }

  std::vector<double> terms_;
};

}  // namespace sinkmesh::detail
