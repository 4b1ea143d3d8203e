// SPDX-License-Identifier: MIT
//
// The fast oracle: signs of the polynomials of the predicates module, some 10^6 per second. From determinants
// and centers as the slow one (exact_signs.h), against which it is tested. It shares no code and no formula
// with the predicates module, of which it only knows the names of the polynomials.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "predicates/point.h"
#include "predicates/polynomials.h"
#include "test/support/inline_integer.h"

namespace sinkmesh::test {

template <std::size_t Dim>
using IntegerVector = std::array<InlineInteger, Dim>;
template <std::size_t Dim, std::size_t N>
using IntegerPoints = std::array<IntegerVector<Dim>, N>;

/// In a common unit. Requires finite coordinates; those whose exponents are too far apart throw.
template <std::size_t Dim, std::size_t N>
IntegerPoints<Dim, N> to_integers(const std::array<const std::array<double, Dim>*, N>& points) {
  struct Scaled {
    std::int64_t significand;
    int exponent;
  };
  std::array<std::array<Scaled, Dim>, N> scaled;
  int lowest = 1 << 20;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t k = 0; k < Dim; ++k) {
      int exponent = 0;
      auto significand = static_cast<std::int64_t>(std::ldexp(std::frexp((*points[i])[k], &exponent), 53));
      const int zeros = significand == 0 ? 0 : std::countr_zero(static_cast<std::uint64_t>(significand));
      scaled[i][k] = {significand / (std::int64_t{1} << zeros), exponent - 53 + zeros};
      if (significand != 0) lowest = std::min(lowest, scaled[i][k].exponent);
    }
  }
  IntegerPoints<Dim, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t k = 0; k < Dim; ++k) {
      const auto [significand, exponent] = scaled[i][k];
      if (significand == 0) continue;
      result[i][k] = InlineInteger(significand).shifted_left(static_cast<std::size_t>(exponent - lowest));
    }
  }
  return result;
}

template <std::size_t Dim>
IntegerVector<Dim> operator-(const IntegerVector<Dim>& a, const IntegerVector<Dim>& b) {
  IntegerVector<Dim> d;
  for (std::size_t k = 0; k < Dim; ++k) d[k] = a[k] - b[k];
  return d;
}

template <std::size_t Dim>
InlineInteger inner(const IntegerVector<Dim>& a, const IntegerVector<Dim>& b) {
  InlineInteger sum = a[0] * b[0];
  for (std::size_t k = 1; k < Dim; ++k) sum = sum + a[k] * b[k];
  return sum;
}

inline IntegerVector<3> outer(const IntegerVector<3>& a, const IntegerVector<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline InlineInteger determinant(const std::array<IntegerVector<2>, 2>& rows) {
  return rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
}
inline InlineInteger determinant(const std::array<IntegerVector<3>, 3>& rows) {
  return inner(rows[0], outer(rows[1], rows[2]));
}

/// From the point `from` to the M points after it.
template <std::size_t M, std::size_t Dim, std::size_t N>
std::array<IntegerVector<Dim>, M> edges(const IntegerPoints<Dim, N>& p, std::size_t from) {
  std::array<IntegerVector<Dim>, M> result;
  for (std::size_t i = 0; i < M; ++i) result[i] = p[from + 1 + i] - p[from];
  return result;
}

/// Signed volume of the simplex of the points first .. first+Dim.
template <std::size_t Dim, std::size_t N>
InlineInteger volume(const IntegerPoints<Dim, N>& p, std::size_t first = 0) {
  return determinant(edges<Dim>(p, first));
}

template <int Dim>
int integer_sign(detail::Orientation<Dim>, const auto& p) {
  return volume(p).sign();
}

/// Minus the determinant of the edges from point 0 and their squared lengths, expanded along the lengths.
template <int Dim>
int integer_sign(detail::InSphere<Dim>, const auto& p) {
  const auto edge = edges<Dim + 1>(p, 0);
  InlineInteger sum;
  for (std::size_t i = 0; i <= Dim; ++i) {
    std::array<IntegerVector<Dim>, Dim> others;
    std::copy_n(edge.begin(), i, others.begin());
    std::copy_n(edge.begin() + i + 1, Dim - i, others.begin() + i);
    const InlineInteger term = inner(edge[i], edge[i]) * determinant(others);
    sum = (i + Dim) % 2 == 0 ? sum - term : sum + term;
  }
  return sum.sign();
}

/// |x-c|^2 - r^2 for the smallest sphere (c,r) through the facet. In the plane c - p[0] = u/2; in space
/// c - p[0] = (|u|^2 v x n + |v|^2 n x u) / (2 n.n) with n = u x v, and the value is multiplied by n.n.
inline int integer_sign(detail::Diametral<2>, const IntegerPoints<2, 3>& p) {
  const auto [u, w] = edges<2>(p, 0);
  return (inner(w, w) - inner(u, w)).sign();
}
inline int integer_sign(detail::Diametral<3>, const IntegerPoints<3, 4>& p) {
  const auto [u, v, w] = edges<3>(p, 0);
  const auto n = outer(u, v);
  const InlineInteger to_center = inner(u, u) * inner(outer(v, n), w) + inner(v, v) * inner(outer(n, u), w);
  return (inner(n, n) * inner(w, w) - to_center).sign();
}

/// The inner normals of the facets opposite the first and the last point, up to the sign of the volume in both.
inline int integer_sign(detail::FacetNormals<2>, const IntegerPoints<2, 3>& p) {
  const auto normal = [&](std::size_t from, std::size_t to) {
    const auto edge = p[to] - p[from];
    return IntegerVector<2>{-edge[1], edge[0]};
  };
  return inner(normal(1, 2), normal(0, 1)).sign();
}
inline int integer_sign(detail::FacetNormals<3>, const IntegerPoints<3, 4>& p) {
  return inner(outer(p[3] - p[1], p[2] - p[1]), outer(p[1] - p[0], p[2] - p[0])).sign();
}

/// y with center = p[first] + y / (2 volume), by Cramer's rule for 2 edge . (center - p[first]) = |edge|^2.
template <std::size_t Dim, std::size_t N>
IntegerVector<Dim> center_numerator(const IntegerPoints<Dim, N>& p, std::size_t first) {
  const auto edge = edges<Dim>(p, first);
  IntegerVector<Dim> y;
  for (std::size_t k = 0; k < Dim; ++k) {
    auto rows = edge;
    for (std::size_t i = 0; i < Dim; ++i) rows[i][k] = inner(edge[i], edge[i]);
    y[k] = determinant(rows);
  }
  return y;
}

/// Of |z1-z2|^2 - r1^2 - r2^2 times both volumes; 0 if a volume is 0. The first factor is multiplied by
/// (2 d1 d2)^2: z1 - z2 = (2 d1 d2 e + d2 y1 - d1 y2) / (2 d1 d2), r = |y| / (2 d).
template <int Dim>
int integer_sign(detail::Orthogonality<Dim>, const auto& p) {
  constexpr std::size_t kSecond = Dim + 1;
  const InlineInteger d1 = volume(p, 0);
  const InlineInteger d2 = volume(p, kSecond);
  const auto y1 = center_numerator(p, 0);
  const auto y2 = center_numerator(p, kSecond);
  const auto e = p[0] - p[kSecond];
  IntegerVector<Dim> between;
  for (std::size_t k = 0; k < Dim; ++k) {
    const InlineInteger d = d1 * d2 * e[k];
    between[k] = d + d + d2 * y1[k] - d1 * y2[k];
  }
  const InlineInteger value = inner(between, between) - d2 * d2 * inner(y1, y1) - d1 * d1 * inner(y2, y2);
  return value.sign() * d1.sign() * d2.sign();
}

template <class P>
int integer_sign(const detail::Points<P>& points) {
  return integer_sign(P{}, to_integers(points));
}

}  // namespace sinkmesh::test
