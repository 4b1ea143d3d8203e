// SPDX-License-Identifier: MIT
//
// Centers, radii and barycentric coordinates in the rationals of GMP, from their defining equations.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/triangulation.h"
#include "predicates/point.h"

namespace sinkmesh::test {

using Rational = mpq_class;
template <int Dim>
using RationalPoint = std::array<Rational, Dim>;

template <int Dim>
RationalPoint<Dim> rational(const PointArg<Dim>& p) {
  RationalPoint<Dim> r;
  for (std::size_t k = 0; k < Dim; ++k) r[k] = p[k];
  return r;
}

template <std::size_t N>
Rational squared_distance(const std::array<Rational, N>& a, const std::array<Rational, N>& b) {
  Rational sum = 0;
  for (std::size_t k = 0; k < N; ++k) {
    const Rational d = a[k] - b[k];
    sum += d * d;
  }
  return sum;
}

/// The solution of N equations, each a row of N coefficients and the right side, by elimination.
template <std::size_t N>
std::array<Rational, N> solve(std::array<std::array<Rational, N + 1>, N> rows) {
  for (std::size_t column = 0; column < N; ++column) {
    std::size_t pivot = column;
    while (rows[pivot][column] == 0) ++pivot;
    std::swap(rows[pivot], rows[column]);
    for (std::size_t i = 0; i < N; ++i) {
      if (i == column || rows[i][column] == 0) continue;
      const Rational factor = rows[i][column] / rows[column][column];
      for (std::size_t k = column; k <= N; ++k) rows[i][k] -= factor * rows[column][k];
    }
  }
  std::array<Rational, N> x;
  for (std::size_t i = 0; i < N; ++i) x[i] = rows[i][N] / rows[i][i];
  return x;
}

template <int Dim>
struct RationalSphere {
  RationalPoint<Dim> center;
  Rational radius2;

  /// |y-z|^2 - r^2.
  Rational power(const RationalPoint<Dim>& y) const { return squared_distance(y, center) - radius2; }
};

/// The sphere orthogonal to the corners with weights -lift[i]: |z-p_i|^2 + lift[i] is the same for all i.
/// Without lifts, the circumsphere.
template <int Dim>
RationalSphere<Dim> orthosphere(const std::array<RationalPoint<Dim>, Dim + 1>& p,
                                const std::array<Rational, Dim + 1>& lift = {}) {
  std::array<std::array<Rational, Dim + 1>, Dim> equations;
  const RationalPoint<Dim> origin{};
  for (std::size_t i = 1; i <= Dim; ++i) {
    for (std::size_t k = 0; k < Dim; ++k) equations[i - 1][k] = 2 * (p[i][k] - p[0][k]);
    equations[i - 1][Dim] = squared_distance(p[i], origin) + lift[i] - squared_distance(p[0], origin) - lift[0];
  }
  RationalSphere<Dim> sphere;
  sphere.center = solve<Dim>(equations);
  sphere.radius2 = squared_distance(sphere.center, p[0]) + lift[0];
  return sphere;
}

template <int Dim>
std::array<RationalPoint<Dim>, Dim + 1> rational_corners(const Corners<Dim>& corners) {
  std::array<RationalPoint<Dim>, Dim + 1> p;
  for (std::size_t i = 0; i <= Dim; ++i) p[i] = rational<Dim>(*corners[i]);
  return p;
}

template <int Dim>
RationalSphere<Dim> circumsphere(const Corners<Dim>& corners) {
  return orthosphere<Dim>(rational_corners<Dim>(corners));
}
template <int Dim>
RationalSphere<Dim> circumsphere(const Complex<Dim>& complex, Simplex s) {
  return circumsphere<Dim>(complex.corners(s));
}

template <int Dim>
std::array<Rational, Dim + 1> barycentric(const std::array<RationalPoint<Dim>, Dim + 1>& p,
                                          const RationalPoint<Dim>& x) {
  std::array<std::array<Rational, Dim + 2>, Dim + 1> equations;
  for (std::size_t i = 0; i <= Dim; ++i) {
    for (std::size_t k = 0; k < Dim; ++k) equations[k][i] = p[i][k];
    equations[Dim][i] = 1;
  }
  for (std::size_t k = 0; k < Dim; ++k) equations[k][Dim + 1] = x[k];
  equations[Dim][Dim + 1] = 1;
  return solve<Dim + 1>(equations);
}

/// Of the simplices that are no ghosts.
template <int Dim>
std::vector<Simplex> solid_simplices(const Complex<Dim>& complex) {
  std::vector<Simplex> result;
  for (const Simplex s : complex.simplices()) {
    if (!complex.is_ghost(s)) result.push_back(s);
  }
  return result;
}

}  // namespace sinkmesh::test
