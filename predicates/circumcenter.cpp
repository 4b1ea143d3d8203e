// SPDX-License-Identifier: MIT
#include "predicates/circumcenter.h"

#include <algorithm>
#include <cmath>

#include "predicates/detail/forms.h"
#include "predicates/detail/wide_int.h"
#include "predicates/error.h"
#include "predicates/input_gate.h"

namespace sinkmesh {
namespace {

using namespace detail;

// Gated coordinates in units of the grid are integers below 2^122, their differences below 2^123.
constexpr int kCoordinateBits = 122;
constexpr int kDifferenceBits = 123;

Int128 in_grid_units(double x) { return static_cast<Int128>(std::ldexp(x, kGridBits)); }

template <int Dim>
Vec<WideInt<kDifferenceBits>, Dim> difference(const Point<Dim>& p, const Point<Dim>& q) {
  Vec<WideInt<kDifferenceBits>, Dim> d;
  for (std::size_t k = 0; k < Dim; ++k) {
    d[k] = WideInt<kDifferenceBits>::from(in_grid_units(p[k]) - in_grid_units(q[k]));
  }
  return d;
}

// A quotient of integers, cut off towards minus infinity, and what its cutting left: of the divisor, nothing
// (0), less than a half (1), a half (2), or more (3).
struct Quotient {
  Int128 floor;
  int rest;
};

// Divides in steps of about 50 bits: a quotient of doubles is within a relative error of 2^-48 of the true one,
// so each step leaves at most 2^-48 of the numerator, and at last less than the divisor but for a final
// correction. Requires divisor > 0 and |numerator| < 2^123 divisor.
template <int N, int D>
Quotient divide(const WideInt<N>& numerator, const WideInt<D>& divisor) {
  // Room for products of an approximate digit and the divisor.
  using Rest = WideInt<N + 2>;
  Rest rest = widen<N + 2>(numerator);
  Int128 quotient = 0;
  const double divisor_value = approximate(divisor);
  const auto subtract = [&](Int128 digit) {
    const auto product = WideInt<125>::from(digit) * divisor;
    const auto difference = rest - product;
    for (std::size_t i = 0; i < rest.kLimbs; ++i) rest.limb[i] = difference.extended(i);
    quotient += digit;
  };
  for (;;) {
    const double digit = approximate(rest) / divisor_value;
    if (std::abs(digit) < 2) break;
    subtract(static_cast<Int128>(digit));
  }
  while (rest.is_negative()) subtract(-1);
  while (!(rest - widen<N + 2>(divisor)).is_negative()) subtract(1);
  if (rest.sign() == 0) return {quotient, 0};
  return {quotient, 2 + (rest + rest - widen<N + 2>(divisor)).sign()};
}

// The nearest double on the grid, ties to even, of quotient.floor + rest, in units of the grid. Above 2^53
// units the double is coarser than the grid, and the rest only says on which side of a tie the value is.
double round_to_grid(const Quotient& q) {
  const bool is_negative = q.floor < 0;
  // Work with the magnitude: for a negative value, cut off towards zero instead.
  auto magnitude = static_cast<Uint128>(is_negative ? -q.floor : q.floor);
  int rest = q.rest;
  if (is_negative && rest != 0) {
    magnitude -= 1;
    rest = 4 - rest;
  }
  int bits = 0;
  while (bits < 127 && magnitude >> bits != 0) ++bits;
  const int dropped = std::max(bits - 53, 0);
  if (dropped > 0) {
    const Uint128 half = Uint128{1} << (dropped - 1);
    const Uint128 tail = magnitude & ((half << 1) - 1);
    const bool is_exact = rest == 0;
    rest = tail < half ? (tail == 0 && is_exact ? 0 : 1) : (tail == half && is_exact ? 2 : 3);
    magnitude >>= dropped;
  }
  const bool is_odd = (magnitude & 1) != 0;
  if (rest == 3 || (rest == 2 && is_odd)) magnitude += 1;
  const double value =
      std::ldexp(static_cast<double>(static_cast<std::uint64_t>(magnitude)), dropped - kGridBits);
  return is_negative ? -value : value;
}

// z = a + Y/(2D), over one denominator: (2 D a + Y) / (2 D).
template <int Dim, class Terms>
bool center_from(const Point<Dim>& a, const Terms& terms, Point<Dim>& center) {
  auto divisor = terms.d + terms.d;
  SINKMESH_ASSERT(divisor.sign() != 0);
  const bool is_turned = divisor.is_negative();
  if (is_turned) divisor = -divisor;
  Point<Dim> result;
  for (std::size_t k = 0; k < Dim; ++k) {
    const auto offset = WideInt<kCoordinateBits>::from(in_grid_units(a[k])) * divisor;
    const auto y = is_turned ? -terms.y[k] : terms.y[k];
    const auto numerator = offset + y;
    // Two in units of the grid is 2^122; more is not asked for.
    if (!(std::abs(approximate(numerator)) < 0x1.1p122 * approximate(divisor))) return false;
    result[k] = round_to_grid(divide(numerator, divisor)) + 0.0;
    if (std::abs(result[k]) > 2) return false;
  }
  center = result;
  return true;
}

}  // namespace

bool circumcenter(const Corners<2>& s, Point2& center) {
  return center_from<2>(*s[0], center_terms(difference<2>(*s[1], *s[0]), difference<2>(*s[2], *s[0])), center);
}

bool circumcenter(const Corners<3>& s, Point3& center) {
  return center_from<3>(
      *s[0],
      center_terms(difference<3>(*s[1], *s[0]), difference<3>(*s[2], *s[0]), difference<3>(*s[3], *s[0])),
      center);
}

}  // namespace sinkmesh
