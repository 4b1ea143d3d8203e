// SPDX-License-Identifier: MIT
//
// Integers of fixed width whose type knows a bound of their value, so that no operation can overflow.
#pragma once

#include <array>
#include <cstdint>

namespace sinkmesh::detail {

__extension__ using Int128 = __int128;
__extension__ using Uint128 = unsigned __int128;

/// A signed integer v with |v| <= 2^Bits, in two's complement, least significant limb first. Sums and products
/// have the type that holds every possible result: |a*b| <= 2^(A+B), |a+b| <= 2^(max(A,B)+1). So the width of
/// each intermediate value of a predicate is proved by the compiler, from the width of the coordinates.
template <int Bits>
struct WideInt {
  /// -2^Bits ... 2^Bits takes Bits+2 bits.
  static constexpr int kLimbs = (Bits + 2 + 63) / 64;

  std::array<std::uint64_t, kLimbs> limb;

  /// Requires |value| <= 2^Bits.
  static WideInt from(Int128 value) {
    WideInt result;
    result.limb[0] = static_cast<std::uint64_t>(value);
    for (std::size_t i = 1; i < kLimbs; ++i) {
      value >>= 64;
      result.limb[i] = static_cast<std::uint64_t>(i == 1 ? value : value >> 63);
    }
    return result;
  }

  bool is_negative() const { return limb[kLimbs - 1] >> 63 != 0; }
  /// All ones for a negative value, zero otherwise: the limbs that follow the last one.
  std::uint64_t extension() const { return std::uint64_t{0} - (limb[kLimbs - 1] >> 63); }
  std::uint64_t extended(std::size_t i) const { return i < kLimbs ? limb[i] : extension(); }

  int sign() const {
    if (is_negative()) return -1;
    std::uint64_t any = 0;
    for (const std::uint64_t x : limb) any |= x;
    return any != 0 ? 1 : 0;
  }
};

namespace wide {

// a + b + carry.
inline std::uint64_t add(std::uint64_t a, std::uint64_t b, std::uint64_t& carry) {
  const Uint128 sum = Uint128{a} + b + carry;
  carry = static_cast<std::uint64_t>(sum >> 64);
  return static_cast<std::uint64_t>(sum);
}

// Subtracts `by`, shifted up by `shift` limbs, from `from`, if `condition` is all ones; modulo the width of
// `from`.
template <std::size_t N, std::size_t M>
void subtract_shifted(std::array<std::uint64_t, N>& from, const std::array<std::uint64_t, M>& by,
                      std::size_t shift, std::uint64_t condition) {
  std::uint64_t carry = 1;
  for (std::size_t i = 0; i + shift < N; ++i) {
    from[i + shift] = add(from[i + shift], ~(i < M ? by[i] & condition : 0), carry);
  }
}

}  // namespace wide

template <int A, int B>
WideInt<(A > B ? A : B) + 1> operator+(const WideInt<A>& a, const WideInt<B>& b) {
  WideInt<(A > B ? A : B) + 1> sum;
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < sum.kLimbs; ++i) sum.limb[i] = wide::add(a.extended(i), b.extended(i), carry);
  return sum;
}

template <int A, int B>
WideInt<(A > B ? A : B) + 1> operator-(const WideInt<A>& a, const WideInt<B>& b) {
  WideInt<(A > B ? A : B) + 1> difference;
  std::uint64_t carry = 1;
  for (std::size_t i = 0; i < difference.kLimbs; ++i) {
    difference.limb[i] = wide::add(a.extended(i), ~b.extended(i), carry);
  }
  return difference;
}

/// The product of the limbs as unsigned numbers, minus what a negative factor counts too much: 2^(64 limbs)
/// times the other one.
template <int A, int B>
WideInt<A + B> operator*(const WideInt<A>& a, const WideInt<B>& b) {
  constexpr std::size_t kA = WideInt<A>::kLimbs;
  constexpr std::size_t kB = WideInt<B>::kLimbs;
  constexpr std::size_t kResult = WideInt<A + B>::kLimbs;
  WideInt<A + B> product{};
#pragma GCC unroll 16
  for (std::size_t i = 0; i < kA; ++i) {
    std::uint64_t carry = 0;
#pragma GCC unroll 16
    for (std::size_t j = 0; j < kB; ++j) {
      if (i + j >= kResult) break;
      const Uint128 term = Uint128{a.limb[i]} * b.limb[j] + product.limb[i + j] + carry;
      product.limb[i + j] = static_cast<std::uint64_t>(term);
      carry = static_cast<std::uint64_t>(term >> 64);
    }
    if (i + kB < kResult) product.limb[i + kB] = carry;
  }
  wide::subtract_shifted(product.limb, b.limb, kA, a.extension());
  wide::subtract_shifted(product.limb, a.limb, kB, b.extension());
  return product;
}

template <int A>
WideInt<A> operator-(const WideInt<A>& a) {
  WideInt<A> negative{};
  wide::subtract_shifted(negative.limb, a.limb, 0, ~std::uint64_t{0});
  return negative;
}

/// The same value under a larger bound.
template <int To, int From>
WideInt<To> widen(const WideInt<From>& a) {
  static_assert(From <= To);
  WideInt<To> result;
  for (std::size_t i = 0; i < result.kLimbs; ++i) result.limb[i] = a.extended(i);
  return result;
}

/// Within a relative error of 2^-50; never overflows for the widths in use (at most 1000 bits).
template <int Bits>
double approximate(const WideInt<Bits>& a) {
  static_assert(Bits <= 1000);
  const WideInt<Bits> magnitude = a.is_negative() ? -a : a;
  double value = 0;
  for (std::size_t i = magnitude.kLimbs; i-- > 0;)
    value = value * 0x1p64 + static_cast<double>(magnitude.limb[i]);
  return a.is_negative() ? -value : value;
}

}  // namespace sinkmesh::detail
