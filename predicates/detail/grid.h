// SPDX-License-Identifier: MIT
//
// Doubles as multiples of powers of two.
#pragma once

#include <bit>
#include <cstdint>

namespace sinkmesh::detail {

/// The least q >= 0 such that the finite x is a multiple of 2^-q.
inline int fraction_bits(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto exponent = static_cast<int>(bits >> 52 & 0x7ff);
  std::uint64_t significand = bits & ((std::uint64_t{1} << 52) - 1);
  if (exponent != 0) significand |= std::uint64_t{1} << 52;
  if (significand == 0) return 0;
  // x = significand * 2^(exponent - 1075), where subnormal numbers have the exponent of the smallest normal
  // ones.
  const int lowest = std::countr_zero(significand) + (exponent == 0 ? 1 : exponent) - 1075;
  return lowest < 0 ? -lowest : 0;
}

}  // namespace sinkmesh::detail
