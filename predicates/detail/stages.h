// SPDX-License-Identifier: MIT
//
// The stages of a predicate, each alone, and their cascade. Tests force single stages; programs use
// predicates.h.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "predicates/detail/expansion.h"
#include "predicates/detail/forms.h"
#include "predicates/detail/wide_int.h"

namespace sinkmesh::detail {

enum class Stage : std::uint8_t {
  local,
  granularity,
  permanent,
  box,
  integer64,
  integer128,
  adaptive,
  expansion
};
inline constexpr std::size_t kStages = 8;

struct Verdict {
  int sign;
  Stage stage;
};

template <class Form>
using Differences = std::array<Vec<double, Form::kDim>, Form::kPairs.size()>;

template <class Form>
Differences<Form> differences(const typename Form::Points& p) {
  Differences<Form> d;
  for (std::size_t i = 0; i < d.size(); ++i) {
    const auto& [first, second] = Form::kPairs[i];
    for (std::size_t k = 0; k < Form::kDim; ++k) d[i][k] = (*p[first])[k] - (*p[second])[k];
  }
  return d;
}

/// The polynomial over another number type, made from each difference by make(high, low): the rounded
/// difference and what rounding took away.
template <class Form, class Make>
auto evaluate(const typename Form::Points& p, Make&& make) {
  using T = decltype(make(0.0, 0.0));
  std::array<Vec<T, Form::kDim>, Form::kPairs.size()> d;
  for (std::size_t i = 0; i < d.size(); ++i) {
    const auto& [first, second] = Form::kPairs[i];
    for (std::size_t k = 0; k < Form::kDim; ++k) {
      const Pair difference = two_difference((*p[first])[k], (*p[second])[k]);
      d[i][k] = make(difference.high, difference.low);
    }
  }
  return Form::value(d);
}

// -- filters. A NaN or an infinity certifies nothing.

/// A bound of the error of Form::value over all differences within the extents. Its computed permanent is
/// within a factor (1+u)^8 of that of exact arithmetic on the same rounded differences, as is permanent_over():
/// 2^-40 covers both.
template <class Form>
double error_over(const Vec<double, Form::kDim>& extents) {
  return Form::kError * (1 + 0x1p-40) * Form::permanent_over(extents);
}

/// Of these differences alone, by their permanent [PS, 0]. The computed permanent is what kError refers to
/// [S97].
template <class Form>
double error_of(const Differences<Form>& d) {
  std::array<Vec<Magnitude, Form::kDim>, Form::kPairs.size()> magnitudes;
  for (std::size_t i = 0; i < d.size(); ++i) {
    for (std::size_t k = 0; k < Form::kDim; ++k) magnitudes[i][k] = {std::abs(d[i][k])};
  }
  return Form::kError * Form::value(magnitudes).value;
}

inline std::optional<int> certify(double value, double error) {
  if (value > error) return 1;
  if (value < -error) return -1;
  return std::nullopt;
}

/// The polynomial is a multiple of grain = g^k when all coordinates are multiples of g. The exact value is
/// within |value| + error of zero, and rounding of that sum is monotone: below the grain it is zero. A grain of
/// 0 is never met.
inline bool is_below_grain(double value, double error, double grain) { return std::abs(value) + error < grain; }

// -- integers

/// The scale that brings the largest difference just below 2^bits: s = 2^(bits - 1 - floor(log2 m)), so m s <
/// 2^bits. A power of two in the range of normal doubles, or nothing; nothing also if there is no nonzero
/// difference, or an infinite one.
template <class Form>
std::optional<double> scale_to(const Differences<Form>& d, int bits) {
  double largest = 0;
  for (const auto& vector : d) {
    for (const double x : vector) largest = std::max(largest, std::abs(x));
  }
  const int exponent = static_cast<int>(std::bit_cast<std::uint64_t>(largest) >> 52) - 1023;
  const int shift = bits - 1 - exponent;
  if (!(largest > 0) || exponent == -1023 || exponent == 1024 || shift > 1023 || shift < -1022)
    return std::nullopt;
  return std::bit_cast<double>(static_cast<std::uint64_t>(shift + 1023) << 52);
}

/// x * scale as an integer of Bits bits, if it is one. Scaling is exact unless it underflows; a nonzero x that
/// vanishes is no integer. Requires |x| * scale < 2^Bits.
template <int Bits>
bool to_integer(double x, double scale, Int128& integer) {
  const double scaled = x * scale;
  if constexpr (Bits <= 62) {
    integer = static_cast<std::int64_t>(scaled);
  } else {
    integer = static_cast<Int128>(scaled);
  }
  return static_cast<double>(integer) == scaled && (scaled != 0 || x == 0);
}

/// The sign by integers of Bits bits, if every difference is one after scaling. Each is the sum of its rounded
/// value h and its tail l, |h| s < 2^Bits; |l| is at most half a unit in the last place of h, so |h s + l s| <=
/// 2^Bits. Scaling by a positive number does not change the sign of a homogeneous polynomial.
template <class Form, int Bits>
std::optional<int> integer_sign(const typename Form::Points& p, const Differences<Form>& d) {
  const std::optional<double> scale = scale_to<Form>(d, Bits);
  if (!scale) return std::nullopt;
  bool exact = true;
  const auto value = evaluate<Form>(p, [&](double high, double low) {
    Int128 h = 0;
    Int128 l = 0;
    exact = to_integer<Bits>(high, *scale, h) && to_integer<Bits>(low, *scale, l) && exact;
    return WideInt<Bits>::from(h + l);
  });
  if (!exact) return std::nullopt;
  return value.sign();
}

// -- expansions [S97]

/// The polynomial of the rounded differences, exactly; it decides if no tail is left, or if it is larger than
/// what the tails can change. That is: if d = h(1+e) with |e| <= u, the polynomial of degree k changes by at
/// most ((1+u)^k - 1) times its permanent over h (every term is a product of k differences), below 2 k u times
/// the permanent; the computed permanent is below the exact one by less than a factor 1 - 2^-40.
template <class Form>
std::optional<int> adaptive_sign(const typename Form::Points& p, const Differences<Form>& d) {
  bool has_tail = false;
  const Expansion value = evaluate<Form>(p, [&](double high, double low) {
    has_tail = has_tail || low != 0;
    return Expansion(high);
  });
  if (!has_tail) return value.sign();
  const double change = 2 * Form::kDegree * kUnit * (error_of<Form>(d) / Form::kError) * (1 + 0x1p-30);
  return certify(value.estimate(), change);
}

template <class Form>
int expansion_sign(const typename Form::Points& p) {
  return evaluate<Form>(p, [](double high, double low) { return Expansion(Pair{high, low}); }).sign();
}

// -- the cascade

/// The exact sign, after a static filter has failed or without one. `grain` is that of is_below_grain(), or 0.
template <class Form>
Verdict exact_sign(const typename Form::Points& p, double grain) {
  const Differences<Form> d = differences<Form>(p);
  const double value = Form::value(d);
  if constexpr (requires(const Vec<double, Form::kDim>& e) { Form::permanent_over(e); }) {
    Vec<double, Form::kDim> extents{};
    for (const auto& vector : d) {
      for (std::size_t k = 0; k < Form::kDim; ++k) extents[k] = std::max(extents[k], std::abs(vector[k]));
    }
    const double error = error_over<Form>(extents);
    if (const auto sign = certify(value, error)) return {*sign, Stage::local};
    if (is_below_grain(value, error, grain)) return {0, Stage::granularity};
  }
  const double error = error_of<Form>(d);
  if (const auto sign = certify(value, error)) return {*sign, Stage::permanent};
  if (is_below_grain(value, error, grain)) return {0, Stage::granularity};
  if (Form::is_zero(p)) return {0, Stage::box};
  if (const auto sign = integer_sign<Form, 62>(p, d)) return {*sign, Stage::integer64};
  if (const auto sign = integer_sign<Form, 123>(p, d)) return {*sign, Stage::integer128};
  if (const auto sign = adaptive_sign<Form>(p, d)) return {*sign, Stage::adaptive};
  return {expansion_sign<Form>(p), Stage::expansion};
}

extern template Verdict exact_sign<Orient2d>(const Orient2d::Points&, double);
extern template Verdict exact_sign<Orient3d>(const Orient3d::Points&, double);
extern template Verdict exact_sign<Incircle>(const Incircle::Points&, double);
extern template Verdict exact_sign<Insphere>(const Insphere::Points&, double);
extern template Verdict exact_sign<DiametralCircle>(const DiametralCircle::Points&, double);
extern template Verdict exact_sign<DiametralSphere>(const DiametralSphere::Points&, double);
extern template Verdict exact_sign<FacetNormals>(const FacetNormals::Points&, double);
extern template Verdict exact_sign<Orthogonality<2>>(const Orthogonality<2>::Points&, double);
extern template Verdict exact_sign<Orthogonality<3>>(const Orthogonality<3>::Points&, double);

}  // namespace sinkmesh::detail
