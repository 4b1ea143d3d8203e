// SPDX-License-Identifier: MIT
#include "predicates/circumcenter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "predicates/detail/circumcenter_stages.h"
#include "predicates/detail/quotient.h"
#include "predicates/detail/rounding.h"
#include "predicates/detail/scaled_integers.h"
#include "predicates/error.h"
#include "predicates/input_gate.h"
#include "predicates/polynomials.h"

namespace sinkmesh {
namespace detail {
namespace {

// -------------------------------------------------------------------------------------- the certified quotient

/// base + q, rounded once, if the error of q cannot change the result.
CenterResult certified_sum(double base, const TwoTerms& q, double& result) {
  const TwoTerms sum = two_sum(base, q.head);
  const double rest = sum.tail + q.tail;
  const TwoTerms z = two_sum(sum.head, rest);
  // The exact center is z up to 2^-100 |q| and the rounding of `rest`; the factors of two cover those of the
  // next lines.
  const double error = 0x1p-99 * std::abs(q.head) + 0x1p-51 * (std::abs(rest) + std::abs(z.tail));
  const double low = z.head + (z.tail - error);
  const double high = z.head + (z.tail + error);
  if (low > 2 || high < -2) return CenterResult::kOutside;
  // Below 2^(52-kGridBits) the grid is coarser than the doubles.
  const double magnitude = std::abs(low);
  if (low != high || !(magnitude < 2) || magnitude <= power_of_two(52 - kGridBits))
    return CenterResult::kUnknown;
  result = low;
  return CenterResult::kInside;
}

// ------------------------------------------------------------------------------------------- the long division

/// A natural number below 2^(64 N).
template <std::size_t N>
struct Natural {
  std::array<std::uint64_t, N> limbs{};

  template <int Bits>
  static Natural magnitude(const FixedInt<Bits>& x) {
    static_assert(FixedInt<Bits>::kLimbs <= N);
    const std::uint64_t flip = x.is_negative() ? ~std::uint64_t{0} : 0;
    Natural r;
    Carry carry = flip & 1;
    for (std::size_t i = 0; i < N; ++i) r.limbs[i] = add_with_carry(x.limb(i) ^ flip, 0, carry);
    return r;
  }

  bool is_zero() const {
    return std::all_of(limbs.begin(), limbs.end(), [](std::uint64_t limb) { return limb == 0; });
  }
  void shift_left(unsigned count) {
    for (; count >= 64; count -= 64) {
      std::copy_backward(limbs.begin(), limbs.end() - 1, limbs.end());
      limbs[0] = 0;
    }
    if (count == 0) return;
    for (std::size_t i = N; i-- > 1;) limbs[i] = limbs[i] << count | limbs[i - 1] >> (64 - count);
    limbs[0] <<= count;
  }
  void halve() {
    for (std::size_t i = 0; i + 1 < N; ++i) limbs[i] = limbs[i] >> 1 | limbs[i + 1] << 63;
    limbs[N - 1] >>= 1;
  }
  /// Subtracts x if the result is not negative. @return whether it did.
  bool try_subtract(const Natural& x) {
    Natural difference;
    Carry borrow = 0;
    for (std::size_t i = 0; i < N; ++i) {
      difference.limbs[i] = subtract_with_borrow(limbs[i], x.limbs[i], borrow);
    }
    if (borrow == 0) *this = difference;
    return borrow == 0;
  }
};

/// numerator / denominator in units of the grid, rounded to nearest even on the grid's doubles; false if the
/// magnitude of the quotient exceeds 2 (2^(kGridBits+1) units).
template <int A, int B>
bool round_quotient(const FixedInt<A>& numerator, const FixedInt<B>& denominator, double& result) {
  constexpr int kQuotientBits = kGridBits + 2;  // of twice the quotient
  constexpr std::size_t kLimbs = static_cast<std::size_t>(std::max(A + 1, B + kQuotientBits)) / 64 + 1;
  using Number = Natural<kLimbs>;
  Number remainder = Number::magnitude(numerator);
  remainder.shift_left(1);
  Number divisor = Number::magnitude(denominator);
  divisor.shift_left(kQuotientBits);
  Uint128 quotient = 0;  // floor(2 numerator / denominator)
  for (int bit = kQuotientBits; bit >= 0; --bit) {
    if (remainder.try_subtract(divisor)) quotient |= static_cast<Uint128>(1) << bit;
    divisor.halve();
  }
  const bool inexact = !remainder.is_zero();
  const Uint128 largest = static_cast<Uint128>(1) << kQuotientBits;
  if (quotient > largest || (quotient == largest && inexact)) return false;

  // Two bits below the unit: the half, and whether anything lies below it.
  const Uint128 n = quotient << 1 | static_cast<Uint128>(inexact);
  const auto high = static_cast<std::uint64_t>(n >> 64);
  const auto low = static_cast<std::uint64_t>(n);
  const int length = static_cast<int>(high != 0 ? 64 + std::bit_width(high) : std::bit_width(low));
  const int dropped = std::max(2, length - 53);
  auto rounded = static_cast<std::uint64_t>(n >> dropped);
  const Uint128 rest = n - (static_cast<Uint128>(rounded) << dropped);
  const Uint128 half = static_cast<Uint128>(1) << (dropped - 1);
  if (rest > half || (rest == half && (rounded & 1) != 0)) ++rounded;
  const double magnitude = static_cast<double>(rounded) * power_of_two(dropped - 2 - kGridBits);
  const bool negative = numerator.sign() * denominator.sign() < 0;
  result = negative && rounded != 0 ? -magnitude : magnitude;
  return true;
}

}  // namespace

template <int Dim>
CenterResult certified_circumcenter(const Corners<Dim>& s, Point<Dim>& center) {
  using P = FromFirstCorner<Dim>;
  Vectors<P, FixedInt<kBits64>> vectors;
  const double scale = scaled_integers<P, kBits64>(s, vectors);
  if (scale == 0) return CenterResult::kUnknown;
  const auto quotient = P::quotient(vectors);
  SINKMESH_ASSERT(quotient.d.sign() != 0);
  // The integers are the lengths times scale; y / (2 d) is homogeneous of degree 1.
  const double unit = 0.5 / scale;
  const TwoTerms d = to_two_terms(quotient.d);
  Point<Dim> result;
  bool known = true;
  for (std::size_t k = 0; k < Dim; ++k) {
    const TwoTerms q = divide(to_two_terms(quotient.y[k]), d);
    const CenterResult r = certified_sum((*s[0])[k], {q.head * unit, q.tail * unit}, result[k]);
    if (r == CenterResult::kOutside) return r;
    known &= r == CenterResult::kInside;
  }
  if (!known) return CenterResult::kUnknown;
  center = result;
  return CenterResult::kInside;
}

/// With coordinates as integers in units of the grid: z = a + y / (2 d) = (2 a d + y) / (2 d).
template <int Dim>
CenterResult exact_circumcenter(const Corners<Dim>& s, Point<Dim>& center) {
  using P = FromFirstCorner<Dim>;
  constexpr int kCoordinateBits = kGridBits + 1;
  const auto grid_units = [&](std::size_t i, std::size_t k) {
    Int128 n = 0;
    [[maybe_unused]] const bool on_grid = to_integer((*s[i])[k] * power_of_two(kGridBits), n);
    SINKMESH_ASSERT(on_grid);
    return n;
  };
  Vectors<P, FixedInt<kCoordinateBits + 1>> vectors;
  for (std::size_t i = 0; i < Dim; ++i) {
    for (std::size_t k = 0; k < Dim; ++k) {
      vectors[i][k] = FixedInt<kCoordinateBits + 1>(grid_units(i + 1, k) - grid_units(0, k));
    }
  }
  const auto quotient = P::quotient(vectors);
  SINKMESH_ASSERT(quotient.d.sign() != 0);
  const auto denominator = twice(quotient.d);
  Point<Dim> result;
  for (std::size_t k = 0; k < Dim; ++k) {
    const FixedInt<kCoordinateBits> base(grid_units(0, k));
    if (!round_quotient(base * denominator + quotient.y[k], denominator, result[k]))
      return CenterResult::kOutside;
  }
  center = result;
  return CenterResult::kInside;
}

template CenterResult certified_circumcenter<2>(const Corners<2>&, Point2&);
template CenterResult certified_circumcenter<3>(const Corners<3>&, Point3&);
template CenterResult exact_circumcenter<2>(const Corners<2>&, Point2&);
template CenterResult exact_circumcenter<3>(const Corners<3>&, Point3&);

namespace {

template <int Dim>
bool rounded_circumcenter(const Corners<Dim>& s, Point<Dim>& center) {
  CenterResult r = certified_circumcenter<Dim>(s, center);
  if (r == CenterResult::kUnknown) r = exact_circumcenter<Dim>(s, center);
  return r == CenterResult::kInside;
}

}  // namespace
}  // namespace detail

bool circumcenter(const Corners<2>& s, Point2& center) { return detail::rounded_circumcenter<2>(s, center); }
bool circumcenter(const Corners<3>& s, Point3& center) { return detail::rounded_circumcenter<3>(s, center); }

}  // namespace sinkmesh
