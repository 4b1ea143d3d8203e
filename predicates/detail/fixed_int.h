// SPDX-License-Identifier: MIT
//
// Signed integers whose width follows from the expression: an overflow is a compile-time impossibility.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace sinkmesh::detail {

__extension__ using Int128 = __int128;
__extension__ using Uint128 = unsigned __int128;

/// An integer of magnitude at most 2^Bits, in two's complement with 64-bit limbs, the lowest first. Sums and
/// products have the type that holds every result, so the bounds of a polynomial are those of its type.
template <int Bits>
struct FixedInt {
  /// 2^Bits itself must fit: Bits <= 64 kLimbs - 2.
  static constexpr std::size_t kLimbs = static_cast<std::size_t>(Bits + 1) / 64 + 1;

  FixedInt() = default;
  explicit FixedInt(std::int64_t x) : FixedInt(static_cast<Int128>(x)) {}
  /// Requires |x| <= 2^Bits.
  explicit FixedInt(Int128 x) {
    limbs[0] = static_cast<std::uint64_t>(x);
    if constexpr (kLimbs > 1) {
      limbs[1] = static_cast<std::uint64_t>(x >> 64);
      for (std::size_t i = 2; i < kLimbs; ++i) limbs[i] = x < 0 ? ~std::uint64_t{0} : 0;
    }
  }

  bool is_negative() const { return static_cast<std::int64_t>(limbs[kLimbs - 1]) < 0; }
  int sign() const {
    if (is_negative()) return -1;
    std::uint64_t any = 0;
    for (const std::uint64_t limb : limbs) any |= limb;
    return any != 0 ? 1 : 0;
  }

  /// Limb i of the infinite two's complement representation.
  std::uint64_t limb(std::size_t i) const {
    return i < kLimbs ? limbs[i] : (is_negative() ? ~std::uint64_t{0} : 0);
  }

  std::array<std::uint64_t, kLimbs> limbs{};
};

// One limb of a sum or difference. Compilers make a chain of add-with-carry from the intrinsics only.
using Carry = unsigned char;
#ifdef __x86_64__
inline std::uint64_t add_with_carry(std::uint64_t a, std::uint64_t b, Carry& carry) {
  unsigned long long s;
  carry = _addcarry_u64(carry, a, b, &s);
  return s;
}
inline std::uint64_t subtract_with_borrow(std::uint64_t a, std::uint64_t b, Carry& borrow) {
  unsigned long long s;
  borrow = _subborrow_u64(borrow, a, b, &s);
  return s;
}
#else
inline std::uint64_t add_with_carry(std::uint64_t a, std::uint64_t b, Carry& carry) {
  const Uint128 s = static_cast<Uint128>(a) + b + carry;
  carry = static_cast<Carry>(s >> 64);
  return static_cast<std::uint64_t>(s);
}
inline std::uint64_t subtract_with_borrow(std::uint64_t a, std::uint64_t b, Carry& borrow) {
  const Uint128 s = static_cast<Uint128>(a) - b - borrow;
  borrow = static_cast<Carry>(s >> 64) & 1;
  return static_cast<std::uint64_t>(s);
}
#endif

template <int A, int B>
inline FixedInt<std::max(A, B) + 1> operator+(const FixedInt<A>& a, const FixedInt<B>& b) {
  FixedInt<std::max(A, B) + 1> r;
  Carry carry = 0;
  for (std::size_t i = 0; i < r.kLimbs; ++i) r.limbs[i] = add_with_carry(a.limb(i), b.limb(i), carry);
  return r;
}

template <int A, int B>
inline FixedInt<std::max(A, B) + 1> operator-(const FixedInt<A>& a, const FixedInt<B>& b) {
  FixedInt<std::max(A, B) + 1> r;
  Carry borrow = 0;
  for (std::size_t i = 0; i < r.kLimbs; ++i) r.limbs[i] = subtract_with_borrow(a.limb(i), b.limb(i), borrow);
  return r;
}

/// The product of the limbs as unsigned numbers, then corrected: reading a negative x as unsigned adds
/// 2^(64 limbs), so the product is too large by the other factor times that power.
template <int A, int B>
inline FixedInt<A + B> operator*(const FixedInt<A>& a, const FixedInt<B>& b) {
  constexpr std::size_t kA = FixedInt<A>::kLimbs;
  constexpr std::size_t kB = FixedInt<B>::kLimbs;
  FixedInt<A + B> r;
  if constexpr (kA == 1 && kB == 1) {
    return FixedInt<A + B>(static_cast<Int128>(static_cast<std::int64_t>(a.limbs[0])) *
                           static_cast<std::int64_t>(b.limbs[0]));
  } else {
    constexpr std::size_t kR = FixedInt<A + B>::kLimbs;
    for (std::size_t i = 0; i < kA; ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < kB && i + j < kR; ++j) {
        const Uint128 t = static_cast<Uint128>(a.limbs[i]) * b.limbs[j] + r.limbs[i + j] + carry;
        r.limbs[i + j] = static_cast<std::uint64_t>(t);
        carry = static_cast<std::uint64_t>(t >> 64);
      }
      if (i + kB < kR) r.limbs[i + kB] = carry;
    }
    const std::uint64_t a_mask = a.is_negative() ? ~std::uint64_t{0} : 0;
    const std::uint64_t b_mask = b.is_negative() ? ~std::uint64_t{0} : 0;
    Carry borrow = 0;
    for (std::size_t i = kA; i < kR; ++i) {
      r.limbs[i] = subtract_with_borrow(r.limbs[i], b.limb(i - kA) & a_mask, borrow);
    }
    borrow = 0;
    for (std::size_t i = kB; i < kR; ++i) {
      r.limbs[i] = subtract_with_borrow(r.limbs[i], a.limb(i - kB) & b_mask, borrow);
    }
    return r;
  }
}

}  // namespace sinkmesh::detail
