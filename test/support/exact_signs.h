// SPDX-License-Identifier: MIT
//
// The oracle: every predicate again, from its definition, in the integers of GMP. Shares no code and no formula
// with the predicates module: determinants of lifted points, Cramer's rule for centers, and for the perturbed
// predicates real weights, tiny enough, in place of symbolic ones.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "predicates/point.h"

namespace sinkmesh::test {

using Integer = mpz_class;
using Matrix = std::vector<std::vector<Integer>>;

/// value * 2^-shift.
struct Exact {
  Integer value;
  long shift;

  int sign() const { return sgn(value); }
  /// Rounded; may be a subnormal number or 0.
  double magnitude() const {
    long exponent = 0;
    const double m = mpz_get_d_2exp(&exponent, value.get_mpz_t());
    return std::ldexp(std::abs(m), static_cast<int>(exponent - shift));
  }
};

/// By the first row; at most 5x5 here.
inline Integer determinant(const Matrix& m) {
  const std::size_t n = m.size();
  if (n == 1) return m[0][0];
  if (n == 2) return m[0][0] * m[1][1] - m[0][1] * m[1][0];
  Integer sum = 0;
  for (std::size_t column = 0; column < n; ++column) {
    if (m[0][column] == 0) continue;
    Matrix minor;
    for (std::size_t row = 1; row < n; ++row) {
      minor.emplace_back();
      for (std::size_t k = 0; k < n; ++k) {
        if (k != column) minor.back().push_back(m[row][k]);
      }
    }
    const Integer term = m[0][column] * determinant(minor);
    if (column % 2 == 0) {
      sum += term;
    } else {
      sum -= term;
    }
  }
  return sum;
}

/// Points as integers in a common unit, 2^-shift.
template <int Dim>
class ExactPoints {
 public:
  explicit ExactPoints(const std::vector<Point<Dim>>& points) : doubles_(points) {
    constexpr int kNone = 4096;
    int lowest = kNone;
    for (const auto& p : points) {
      for (const double x : p) {
        if (x != 0) lowest = std::min(lowest, std::ilogb(x) - 52);
      }
    }
    if (lowest == kNone) lowest = 0;
    shift_ = -lowest;
    for (const auto& p : points) {
      integers_.emplace_back();
      for (const double x : p) {
        int exponent = 0;
        const double m = std::frexp(x, &exponent);
        Integer n(std::ldexp(m, 53));
        if (x != 0)
          mpz_mul_2exp(n.get_mpz_t(), n.get_mpz_t(), static_cast<mp_bitcnt_t>(exponent - 53 - lowest));
        integers_.back().push_back(n);
      }
    }
  }

  using Vector = std::vector<Integer>;
  std::size_t size() const { return integers_.size(); }
  const Vector& operator[](std::size_t i) const { return integers_[i]; }
  long shift() const { return shift_; }

  Vector difference(std::size_t i, std::size_t j) const {
    Vector d;
    for (std::size_t k = 0; k < Dim; ++k) d.emplace_back(integers_[i][k] - integers_[j][k]);
    return d;
  }
  /// Positions 0.. of the points in lexicographic order of the doubles.
  std::vector<std::size_t> ranks() const {
    std::vector<std::size_t> order(size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return doubles_[i] < doubles_[j]; });
    std::vector<std::size_t> rank(size());
    for (std::size_t r = 0; r < order.size(); ++r) rank[order[r]] = r;
    return rank;
  }
  /// A number of bits that no coordinate, and hence no difference, exceeds.
  std::size_t bits() const {
    std::size_t most = 1;
    for (const auto& p : integers_) {
      for (const Integer& x : p) most = std::max(most, mpz_sizeinbase(x.get_mpz_t(), 2));
    }
    return most + 1;
  }

 private:
  std::vector<Point<Dim>> doubles_;
  std::vector<Vector> integers_;
  long shift_;
};

inline Integer inner(const std::vector<Integer>& v, const std::vector<Integer>& w) {
  Integer sum = 0;
  for (std::size_t k = 0; k < v.size(); ++k) sum += v[k] * w[k];
  return sum;
}

/// Weights +2^(-bits * degree * (rank + 1)) of the lifted coordinate, all times one power of two: smaller than
/// any nonzero coefficient can make up for, rank by rank.
struct TinyWeights {
  std::vector<Integer> lift;  // by point
  mp_bitcnt_t unit;           // lifted squares must be multiplied by 2^unit

  TinyWeights(const std::vector<std::size_t>& ranks, std::size_t bits, std::size_t degree) {
    const mp_bitcnt_t step = (bits + 3) * degree;
    unit = step * (ranks.size() + 1);
    for (const std::size_t rank : ranks) {
      Integer w = 1;
      mpz_mul_2exp(w.get_mpz_t(), w.get_mpz_t(), unit - step * (rank + 1));
      lift.push_back(w);
    }
  }
};

template <int Dim>
Exact exact_orientation(const ExactPoints<Dim>& p) {
  Matrix m;
  for (std::size_t i = 1; i <= Dim; ++i) m.push_back(p.difference(i, 0));
  return {determinant(m), Dim * p.shift()};
}

/// Determinant of the lifted points, seen from the first; negative if the last lies below the plane of the
/// others.
template <int Dim>
Exact exact_in_sphere(const ExactPoints<Dim>& p, bool perturbed = false) {
  const TinyWeights weights(p.ranks(), p.bits(), Dim + 2);
  Matrix m;
  for (std::size_t i = 1; i <= Dim + 1; ++i) {
    m.push_back(p.difference(i, 0));
    Integer lift = inner(m.back(), m.back());
    if (perturbed) {
      mpz_mul_2exp(lift.get_mpz_t(), lift.get_mpz_t(), weights.unit);
      lift += weights.lift[i] - weights.lift[0];
    }
    m.back().push_back(lift);
  }
  return {-determinant(m), (Dim + 2) * p.shift()};
}

/// The vector y with center = p[0] + y / (2 d), for the simplex of points first .. first+Dim, by Cramer's rule
/// for 2 (p[i] - p[0]) . (center - p[0]) = lift[i-1].
template <int Dim>
std::vector<Integer> exact_center_numerator(const ExactPoints<Dim>& p, std::size_t first,
                                            const std::vector<Integer>& lift) {
  std::vector<Integer> y;
  for (std::size_t k = 0; k < Dim; ++k) {
    Matrix m;
    for (std::size_t i = 1; i <= Dim; ++i) {
      m.push_back(p.difference(first + i, first));
      m.back()[k] = lift[i - 1];
    }
    y.push_back(determinant(m));
  }
  return y;
}
template <int Dim>
Integer exact_volume(const ExactPoints<Dim>& p, std::size_t first) {
  Matrix m;
  for (std::size_t i = 1; i <= Dim; ++i) m.push_back(p.difference(first + i, first));
  return determinant(m);
}
template <int Dim>
std::vector<Integer> exact_lifts(const ExactPoints<Dim>& p, std::size_t first) {
  std::vector<Integer> lift;
  for (std::size_t i = 1; i <= Dim; ++i) {
    const auto v = p.difference(first + i, first);
    lift.push_back(inner(v, v));
  }
  return lift;
}

/// |x-c|^2 - r^2 for the smallest sphere (c,r) through the facet p[0..Dim-1], times the squared area of the
/// facet (3D: the normal n = u x v; 2D: 1). From c - p[0] = (|u|^2 v x n + |v|^2 n x u) / (2 n.n), or u/2 in
/// the plane.
template <int Dim>
Exact exact_diametral(const ExactPoints<Dim>& p) {
  const auto u = p.difference(1, 0);
  const auto w = p.difference(Dim, 0);
  if constexpr (Dim == 2) {
    return {inner(w, w) - inner(u, w), 2 * p.shift()};
  } else {
    const auto v = p.difference(2, 0);
    const auto cross = [](const std::vector<Integer>& a, const std::vector<Integer>& b) {
      return std::vector<Integer>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                  a[0] * b[1] - a[1] * b[0]};
    };
    const auto n = cross(u, v);
    const auto vn = cross(v, n);
    const auto nu = cross(n, u);
    const Integer uu = inner(u, u);
    const Integer vv = inner(v, v);
    return {inner(n, n) * inner(w, w) - uu * inner(vn, w) - vv * inner(nu, w), 6 * p.shift()};
  }
}

/// The side of the facet p[0..Dim-1] on which the orthocenter of the weighted simplex lies: the sign of the
/// barycentric coordinate of the apex, orient(facet, center) / orient(facet, apex). The center, relative to
/// p[0], is y / (2 d) and orient(facet, apex) = d, so that d enters squared.
template <int Dim>
int exact_perturbed_flow(const ExactPoints<Dim>& p) {
  const TinyWeights weights(p.ranks(), p.bits(), 2 * Dim + 2);
  std::vector<Integer> lift = exact_lifts<Dim>(p, 0);
  for (std::size_t i = 0; i < Dim; ++i) {
    mpz_mul_2exp(lift[i].get_mpz_t(), lift[i].get_mpz_t(), weights.unit);
    lift[i] += weights.lift[i + 1] - weights.lift[0];
  }
  Matrix m;
  for (std::size_t i = 1; i < Dim; ++i) m.push_back(p.difference(i, 0));
  m.push_back(exact_center_numerator<Dim>(p, 0, lift));
  return sgn(determinant(m));
}

/// |z1-z2|^2 - r1^2 - r2^2 times (2 d1 d2)^2, for the simplices p[0..Dim] and p[Dim+1..].
template <int Dim>
Exact exact_orthogonality(const ExactPoints<Dim>& p) {
  constexpr std::size_t kSecond = Dim + 1;
  const auto y1 = exact_center_numerator<Dim>(p, 0, exact_lifts<Dim>(p, 0));
  const auto y2 = exact_center_numerator<Dim>(p, kSecond, exact_lifts<Dim>(p, kSecond));
  const Integer d1 = exact_volume<Dim>(p, 0);
  const Integer d2 = exact_volume<Dim>(p, kSecond);
  // z1 - z2 = e + y1 / (2 d1) - y2 / (2 d2), over the common denominator 2 d1 d2.
  const auto e = p.difference(0, kSecond);
  Integer distance = 0;
  for (std::size_t k = 0; k < Dim; ++k) {
    const Integer c = 2 * d1 * d2 * e[k] + d2 * y1[k] - d1 * y2[k];
    distance += c * c;
  }
  const Integer value = distance - d2 * d2 * inner(y1, y1) - d1 * d1 * inner(y2, y2);
  return {value, (4 * Dim + 2) * p.shift()};
}

}  // namespace sinkmesh::test
