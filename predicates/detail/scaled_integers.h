// SPDX-License-Identifier: MIT
//
// Differences of points as integers, scaled by one power of two, if that is exact.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "predicates/detail/fixed_int.h"
#include "predicates/detail/rounding.h"
#include "predicates/polynomials.h"

namespace sinkmesh::detail {

/// The widths of the two integer stages: one and two limbs.
inline constexpr int kBits64 = 62;
inline constexpr int kBits128 = 123;

/// 2^e; requires -1022 <= e <= 1023.
inline double power_of_two(int e) { return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52); }

/// floor(log2 |x|) for normal x; -1023 for subnormal x and 0.
inline int exponent_of(double x) {
  return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff) - 1023;
}

/// x = n? Requires |x| < 2^Bits.
inline bool to_integer(double x, std::int64_t& n) {
  n = static_cast<std::int64_t>(x);
  return static_cast<double>(n) == x;
}

/// In two parts, because conversions between double and 128 bits are slow: the part above 2^61, whose removal
/// is exact, and the rest.
inline bool to_integer(double x, Int128& n) {
  const auto high = static_cast<std::int64_t>(x * 0x1p-61);
  const double rest = x - static_cast<double>(high) * 0x1p61;
  const auto low = static_cast<std::int64_t>(rest);
  n = static_cast<Int128>(high) * (std::int64_t{1} << 61) + low;
  return static_cast<double>(low) == rest;
}

/// The scale for differences up to m: the largest power of two with m * scale < 2^Bits (or 2^1023).
template <int Bits>
double integer_scale(double m) {
  return power_of_two(std::min(Bits - 1 - exponent_of(m), 1023));
}

/// Did a nonzero number vanish under the scale? The only error that to_integer() does not see, because 0 is an
/// integer. With a scale of at least 2^53 every nonzero double stays a normal number, so that nothing is
/// rounded at all.
template <class V>
bool vanishes(const V& vectors, double scale) {
  bool lost = false;
  for (const auto& vector : vectors) {
    for (const double x : vector) lost |= x != 0 && x * scale == 0;
  }
  return lost;
}

/// The vectors of P times a power of two, as integers of magnitude at most 2^Bits. The rounded difference h and
/// its error l are both converted: |h * scale| < 2^Bits is a double, hence at most 2^Bits - 2^(Bits-53), and
/// |l * scale| is at most half a unit in its last place, 2^(Bits-54).
/// @return the scale if every conversion was exact, otherwise 0. Assumes nothing of the points; 0 also where a
///         difference overflows.
template <class P, int Bits>
double scaled_integers(const Points<P>& p, Vectors<P, FixedInt<Bits>>& result) {
  Vectors<P, double> heads;
  Vectors<P, double> tails;
  double m = 0;
  for (std::size_t i = 0; i < heads.size(); ++i) {
    for (std::size_t k = 0; k < P::kDim; ++k) {
      const TwoTerms d = two_diff((*p[P::kVectors[i].from])[k], (*p[P::kVectors[i].to])[k]);
      heads[i][k] = d.head;
      tails[i][k] = d.tail;
      m = std::max(m, std::abs(d.head));
    }
  }
  if (!(m <= std::numeric_limits<double>::max())) return 0;
  const double scale = integer_scale<Bits>(m);
  if (scale < 0x1p53 && (vanishes(heads, scale) || vanishes(tails, scale))) return 0;

  using Int = std::conditional_t<(FixedInt<Bits>::kLimbs > 1), Int128, std::int64_t>;
  bool exact = true;
  for (std::size_t i = 0; i < heads.size(); ++i) {
    for (std::size_t k = 0; k < P::kDim; ++k) {
      Int head;
      Int tail;
      exact &= to_integer(heads[i][k] * scale, head);
      exact &= to_integer(tails[i][k] * scale, tail);
      result[i][k] = FixedInt<Bits>(head + tail);
    }
  }
  return exact ? scale : 0;
}

}  // namespace sinkmesh::detail
