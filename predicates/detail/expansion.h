// SPDX-License-Identifier: MIT
//
// Shewchuk's expansions: exact sums and products of doubles [S97, 2].
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace sinkmesh::detail {

/// A rounded result and what rounding took away: their sum is exact.
struct Pair {
  double high;
  double low;
};

/// Exact for all a, b without overflow [S97, Theorem 7].
inline Pair two_sum(double a, double b) {
  const double high = a + b;
  const double b_virtual = high - a;
  const double a_virtual = high - b_virtual;
  return {high, (a - a_virtual) + (b - b_virtual)};
}

inline Pair two_difference(double a, double b) { return two_sum(a, -b); }

/// Requires |a| >= |b|, or a = 0 [S97, Theorem 6].
inline Pair fast_two_sum(double a, double b) {
  const double high = a + b;
  return {high, b - (high - a)};
}

/// Exact without over- and underflow [S97, Theorem 18]; Dekker's product, since not every target has a fused
/// one.
inline Pair two_product(double a, double b) {
  constexpr double kSplitter = 0x1p27 + 1;
  const double high = a * b;
  const double a_scaled = kSplitter * a;
  const double a_high = a_scaled - (a_scaled - a);
  const double a_low = a - a_high;
  const double b_scaled = kSplitter * b;
  const double b_high = b_scaled - (b_scaled - b);
  const double b_low = b - b_high;
  return {high, a_low * b_low - (((high - a_high * b_high) - a_low * b_high) - a_high * b_low)};
}

/// A sum of doubles that do not overlap, by increasing magnitude, without zeros: an exact real number of any
/// size. Empty: zero. The largest component decides the sign.
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(double a) {
    if (a != 0) parts_.push_back(a);
  }
  /// Requires a pair whose low part is what rounding took away.
  explicit Expansion(Pair a) {
    if (a.low != 0) parts_.push_back(a.low);
    if (a.high != 0) parts_.push_back(a.high);
  }

  int sign() const { return parts_.empty() ? 0 : parts_.back() > 0 ? 1 : -1; }
  /// Within half a unit in the last place of its largest component, times two.
  double estimate() const {
    double sum = 0;
    for (const double part : parts_) sum += part;
    return sum;
  }

  Expansion operator-() const {
    Expansion negative = *this;
    for (double& part : negative.parts_) part = -part;
    return negative;
  }
  friend Expansion operator+(const Expansion& a, const Expansion& b);
  friend Expansion operator-(const Expansion& a, const Expansion& b) { return a + -b; }
  friend Expansion operator*(const Expansion& a, const Expansion& b);

 private:
  void add(double a);
  void compress();

  std::vector<double> parts_;
};

}  // namespace sinkmesh::detail
