// SPDX-License-Identifier: MIT
//
// Number types over which polynomials.h yields error bounds and first-order corrections.
#pragma once

namespace sinkmesh::detail {

/// Evaluates permanents: starts from |x|, and subtraction adds.
struct Magnitude {
  double value;

  friend Magnitude operator+(Magnitude a, Magnitude b) { return {a.value + b.value}; }
  friend Magnitude operator-(Magnitude a, Magnitude b) { return {a.value + b.value}; }
  friend Magnitude operator*(Magnitude a, Magnitude b) { return {a.value * b.value}; }
};

/// Evaluates p(value) and its derivative in a direction.
struct Dual {
  double value;
  double slope;

  friend Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.slope + b.slope}; }
  friend Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.slope - b.slope}; }
  friend Dual operator*(Dual a, Dual b) { return {a.value * b.value, a.value * b.slope + a.slope * b.value}; }
};

}  // namespace sinkmesh::detail
