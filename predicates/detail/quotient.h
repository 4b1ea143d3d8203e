// SPDX-License-Identifier: MIT
//
// Quotients of exact integers in twice the working precision.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "predicates/detail/fixed_int.h"
#include "predicates/detail/rounding.h"
#include "predicates/detail/scaled_integers.h"
#include "predicates/polynomials.h"

namespace sinkmesh::detail {

/// The vectors from the first corner to the others.
template <int Dim>
struct FromFirstCorner;
template <>
struct FromFirstCorner<2> {
  static constexpr std::size_t kDim = 2, kPoints = 3;
  static constexpr std::array<Difference, 2> kVectors{{{1, 0}, {2, 0}}};
  template <class T>
  static auto quotient(const std::array<std::array<T, 2>, 2>& v) {
    return circumcenter_quotient(v[0], v[1]);
  }
};
template <>
struct FromFirstCorner<3> {
  static constexpr std::size_t kDim = 3, kPoints = 4;
  static constexpr std::array<Difference, 3> kVectors{{{1, 0}, {2, 0}, {3, 0}}};
  template <class T>
  static auto quotient(const std::array<std::array<T, 3>, 3>& v) {
    return circumcenter_quotient(v[0], v[1], v[2]);
  }
};

/// x in two doubles; relative error at most 2^-104: of |x| = T 2^e + rest, with 2^127 <= T < 2^128, the upper
/// 106 bits of T are kept, and 2^22 + 1 <= 2^-104 T.
template <int Bits>
inline TwoTerms to_two_terms(const FixedInt<Bits>& x) {
  constexpr std::size_t kLimbs = FixedInt<Bits>::kLimbs;
  const std::uint64_t flip = x.is_negative() ? ~std::uint64_t{0} : 0;
  std::array<std::uint64_t, kLimbs> magnitude;
  Carry carry = flip & 1;
  for (std::size_t i = 0; i < kLimbs; ++i) magnitude[i] = add_with_carry(x.limbs[i] ^ flip, 0, carry);
  std::size_t top = kLimbs;
  while (top > 0 && magnitude[top - 1] == 0) --top;
  if (top == 0) return {0, 0};
  const auto limb = [&](std::size_t below) { return top >= below ? magnitude[top - below] : std::uint64_t{0}; };
  const int shift = std::countl_zero(limb(1));
  Uint128 t = (static_cast<Uint128>(limb(1)) << 64 | limb(2)) << shift;
  if (shift != 0) t |= limb(3) >> (64 - shift);
  const int exponent = static_cast<int>(top) * 64 - 128 - shift;
  const double sign = x.is_negative() ? -1.0 : 1.0;
  const auto upper = static_cast<double>(static_cast<std::uint64_t>(t >> 75));
  const auto lower = static_cast<double>(static_cast<std::uint64_t>(t >> 22) & ((std::uint64_t{1} << 53) - 1));
  return fast_two_sum(sign * upper * power_of_two(exponent + 75), sign * lower * power_of_two(exponent + 22));
}

/// y / d with relative error at most 32 u^2 + 2 * 2^-104 <= 2^-100 (the second part from the inputs). With q =
/// fl(y/d), the head of q d cancels y's exactly; the remainder is below 6 u |y| and has four roundings of such
/// numbers, 14 u^2 |y|; dividing it rounds once more and ignores the tail of d, 12 u^2 |q|.
inline TwoTerms divide(const TwoTerms& y, const TwoTerms& d) {
  const double quotient = y.head / d.head;
  const TwoTerms product = two_product(quotient, d.head);
  const double remainder = (((y.head - product.head) - product.tail) + y.tail) - quotient * d.tail;
  return fast_two_sum(quotient, remainder / d.head);
}

}  // namespace sinkmesh::detail
