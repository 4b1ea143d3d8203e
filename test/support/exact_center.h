// SPDX-License-Identifier: MIT
//
// Circumcenters, powers and normals in rationals, and the rounding that circumcenter() promises.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "predicates/input_gate.h"
#include "test/support/exact_signs.h"

namespace sinkmesh::test {

/// value / divisor * 2^-shift.
inline mpq_class scaled(const Integer& value, const Integer& divisor, long shift) {
  mpq_class q(value, divisor);
  q.canonicalize();
  if (shift >= 0) {
    mpq_div_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(shift));
  } else {
    mpq_mul_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(-shift));
  }
  return q;
}

/// The double nearest to the exact coordinate among those on the gate's grid, ties to even.
inline double rounded_on_grid(const mpq_class& exact) {
  const mpq_class units = exact * (mpz_class(1) << kGridBits);
  // The unit in the last place, in units of the grid: 2^(bits - 53) if the integer part has more than 53 bits.
  mpz_class floor = units.get_num() / units.get_den();
  floor = abs(floor);
  const std::size_t bits = floor == 0 ? 0 : mpz_sizeinbase(floor.get_mpz_t(), 2);
  const mpz_class step = mpz_class(1) << (bits > 53 ? bits - 53 : 0);
  const mpq_class steps = units / step;
  mpz_class lower;
  mpz_fdiv_q(lower.get_mpz_t(), steps.get_num_mpz_t(), steps.get_den_mpz_t());
  const mpq_class above = steps - lower;
  const mpq_class half(1, 2);
  const bool up = above > half || (above == half && mpz_odd_p(lower.get_mpz_t()) != 0);
  const mpz_class nearest = (up ? mpz_class(lower + 1) : lower) * step;
  return std::ldexp(nearest.get_d(), -kGridBits) + 0.0;
}

/// The vector from point `from` to the circumcenter of the points 0..Dim. Requires nonzero volume.
template <int Dim>
std::vector<mpq_class> exact_vector_to_center(const ExactPoints<Dim>& p, std::size_t from) {
  const auto y = exact_center_numerator<Dim>(p, 0, exact_lifts<Dim>(p, 0));
  const Integer d = 2 * exact_volume<Dim>(p, 0);
  std::vector<mpq_class> vector;
  for (std::size_t k = 0; k < Dim; ++k)
    vector.push_back(scaled((p[0][k] - p[from][k]) * d + y[k], d, p.shift()));
  return vector;
}

/// What circumcenter() must return for these corners: nothing for a center outside [-2, 2]^Dim.
template <int Dim>
std::optional<Point<Dim>> exact_center(const std::vector<Point<Dim>>& points) {
  const ExactPoints<Dim> p(points);
  const auto vector = exact_vector_to_center<Dim>(p, 0);
  Point<Dim> center;
  for (std::size_t k = 0; k < Dim; ++k) {
    const mpq_class coordinate = vector[k] + scaled(p[0][k], 1, p.shift());
    if (abs(coordinate) > 2) return std::nullopt;
    center[k] = rounded_on_grid(coordinate);
  }
  return center;
}

/// |y-z|^2 - r^2 for the circumsphere (z,r) of the points 0..Dim and y = point Dim+1. Requires nonzero volume.
template <int Dim>
mpq_class exact_power(const ExactPoints<Dim>& p) {
  // z = a + q/(2d): |y-a|^2 - (y-a).q/d.
  const Integer d = exact_volume<Dim>(p, 0);
  const auto q = exact_center_numerator<Dim>(p, 0, exact_lifts<Dim>(p, 0));
  const auto e = p.difference(Dim + 1, 0);
  return scaled(inner(e, e) * d - inner(e, q), d, 2 * p.shift());
}

/// (b-a) x (c-a) of the points 0..Dim-1, in the plane the edge turned clockwise.
template <int Dim>
std::vector<mpq_class> exact_normal(const ExactPoints<Dim>& p) {
  const auto u = p.difference(1, 0);
  std::vector<Integer> exact;
  if constexpr (Dim == 2) {
    exact = {u[1], -u[0]};
  } else {
    const auto v = p.difference(2, 0);
    exact = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }
  std::vector<mpq_class> normal;
  for (const Integer& x : exact) normal.push_back(scaled(x, 1, (Dim - 1) * p.shift()));
  return normal;
}

}  // namespace sinkmesh::test
