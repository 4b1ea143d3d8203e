// SPDX-License-Identifier: MIT
//
// The perturbed Delaunay complex of a few points, from its definition: the lower side of the convex hull of the
// lifted points. Shares no code and no formula with the predicates or the complex. Two versions: small integers
// with symbolic weights, fast enough for ten thousand clouds; any doubles with explicit weights, which checks
// the first.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "predicates/point.h"
#include "test/support/exact_signs.h"

namespace sinkmesh::test {

/// Ids of the corners of a simplex, or of the vertices of a facet, by increasing id.
template <std::size_t N>
using IdSet = std::array<std::uint32_t, N>;

inline int sign_of(std::int64_t x) { return (x > 0) - (x < 0); }

/// (Dim! times) the signed volume, in 64-bit integers: exact for integers of at most 1000.
inline std::int64_t integer_volume(const Point2& a, const Point2& b, const Point2& c) {
  const auto d = [](double x, double y) { return static_cast<std::int64_t>(x) - static_cast<std::int64_t>(y); };
  return d(b[0], a[0]) * d(c[1], a[1]) - d(b[1], a[1]) * d(c[0], a[0]);
}
inline std::int64_t integer_volume(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  std::int64_t m[3][3];
  const Point3* const rows[] = {&b, &c, &d};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      m[i][k] = static_cast<std::int64_t>((*rows[i])[k]) - static_cast<std::int64_t>(a[k]);
    }
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}
template <int Dim>
std::int64_t integer_volume(const std::array<Point<Dim>, Dim + 1>& p) {
  return std::apply([](const auto&... q) { return integer_volume(q...); }, p);
}

/// Calls visit(IdSet<N>) for all subsets of 0..n-1 with N elements.
template <std::size_t N, class Visit>
void for_all_subsets(std::uint32_t n, Visit&& visit) {
  IdSet<N> set;
  std::iota(set.begin(), set.end(), 0U);
  if (n < N) return;
  for (;;) {
    visit(set);
    std::size_t k = N;
    while (k > 0 && set[k - 1] == n - N + (k - 1)) --k;
    if (k == 0) return;
    ++set[k - 1];
    for (; k < N; ++k) set[k] = set[k - 1] + 1;
  }
}

/// Signs of Dim+2 lifted points, for distinct points with integer coordinates of at most 250. Everything is
/// done in the order of ranks: the height of the point of rank r is |p|^2 + eps_r with eps_0 >> eps_1 >> ...
template <int Dim>
class LiftedSigns {
 public:
  explicit LiftedSigns(const std::vector<Point<Dim>>& points) : id_(points.size()) {
    std::iota(id_.begin(), id_.end(), 0U);
    std::sort(id_.begin(), id_.end(), [&](auto i, auto j) { return points[i] < points[j]; });
    for (const std::uint32_t i : id_) {
      sorted_.push_back(points[i]);
      heights_.push_back(0);
      for (const double x : points[i]) {
        if (x != std::floor(x) || std::abs(x) > 250) throw std::logic_error("too large for the oracle");
        heights_.back() += static_cast<std::int64_t>(x) * static_cast<std::int64_t>(x);
      }
    }
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(id_.size()); }
  std::uint32_t id(std::uint32_t rank) const { return id_[rank]; }

  /// Signed volume of Dim+1 points given by rank.
  std::int64_t volume(const IdSet<Dim + 1>& ranks) const {
    std::array<Point<Dim>, Dim + 1> p;
    for (std::size_t i = 0; i <= Dim; ++i) p[i] = sorted_[ranks[i]];
    return integer_volume<Dim>(p);
  }

  /// Sign of the determinant of the rows (1, p, height) of Dim+2 points, given by increasing rank: expanded
  /// along the column of heights, whose cofactors are volumes. 0 only if all points lie in one hyperplane.
  int side(const IdSet<Dim + 2>& ranks) const {
    std::array<std::int64_t, Dim + 2> cofactor;
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < Dim + 2; ++i) {
      IdSet<Dim + 1> others;
      std::copy(ranks.begin(), ranks.begin() + static_cast<std::ptrdiff_t>(i), others.begin());
      std::copy(ranks.begin() + static_cast<std::ptrdiff_t>(i) + 1, ranks.end(),
                others.begin() + static_cast<std::ptrdiff_t>(i));
      cofactor[i] = ((i + Dim + 1) % 2 == 0 ? 1 : -1) * volume(others);
      sum += heights_[ranks[i]] * cofactor[i];
    }
    if (sum != 0) return sign_of(sum);
    for (const std::int64_t c : cofactor) {
      if (c != 0) return sign_of(c);
    }
    return 0;
  }

  /// Whether the point of rank e, not among the simplex, lies inside its perturbed circumsphere: its lifted
  /// point lies below the hyperplane of those of the simplex. Requires nonzero volume.
  bool is_inside(const IdSet<Dim + 1>& simplex, std::uint32_t e) const {
    IdSet<Dim + 2> all;
    const auto place = std::lower_bound(simplex.begin(), simplex.end(), e) - simplex.begin();
    std::copy(simplex.begin(), simplex.begin() + place, all.begin());
    all[static_cast<std::size_t>(place)] = e;
    std::copy(simplex.begin() + place, simplex.end(), all.begin() + place + 1);
    const int moved = (Dim + 1 - place) % 2 == 0 ? 1 : -1;  // e goes to the last row
    return moved * side(all) * sign_of(volume(simplex)) < 0;
  }

 private:
  std::vector<std::uint32_t> id_;  // by rank
  std::vector<Point<Dim>> sorted_;
  std::vector<std::int64_t> heights_;
};

/// The simplices of the Delaunay complex, in lexicographic order. Distinct points, integers of at most 250.
template <int Dim>
std::vector<IdSet<Dim + 1>> brute_force_delaunay(const std::vector<Point<Dim>>& points) {
  const LiftedSigns<Dim> signs(points);
  std::vector<IdSet<Dim + 1>> result;
  for_all_subsets<Dim + 1>(signs.size(), [&](const IdSet<Dim + 1>& simplex) {
    if (signs.volume(simplex) == 0) return;
    for (std::uint32_t e = 0; e < signs.size(); ++e) {
      if (std::find(simplex.begin(), simplex.end(), e) == simplex.end() && signs.is_inside(simplex, e)) return;
    }
    IdSet<Dim + 1> ids;
    for (std::size_t i = 0; i <= Dim; ++i) ids[i] = signs.id(simplex[i]);
    std::sort(ids.begin(), ids.end());
    result.push_back(ids);
  });
  std::sort(result.begin(), result.end());
  return result;
}

/// The same for any distinct doubles, in the integers of GMP, with explicit weights.
template <int Dim>
std::vector<IdSet<Dim + 1>> brute_force_delaunay_by_weights(const std::vector<Point<Dim>>& points) {
  const ExactPoints<Dim> exact(points);
  const TinyWeights weights(exact.ranks(), exact.bits(), Dim + 2);
  Matrix lifted;  // (p, height, 1)
  for (std::size_t i = 0; i < exact.size(); ++i) {
    lifted.push_back(exact[i]);
    Integer height = inner(exact[i], exact[i]);
    mpz_mul_2exp(height.get_mpz_t(), height.get_mpz_t(), weights.unit);
    lifted.back().push_back(height + weights.lift[i]);
    lifted.back().emplace_back(1);
  }
  const auto without_height = [](std::vector<Integer> row) {
    row.erase(row.begin() + Dim);
    return row;
  };

  std::vector<IdSet<Dim + 1>> result;
  for_all_subsets<Dim + 1>(static_cast<std::uint32_t>(points.size()), [&](const IdSet<Dim + 1>& simplex) {
    Matrix flat;
    Matrix rows;
    for (const std::uint32_t i : simplex) {
      flat.push_back(without_height(lifted[i]));
      rows.push_back(lifted[i]);
    }
    const int volume = sgn(determinant(flat));
    if (volume == 0) return;
    rows.emplace_back();
    for (std::uint32_t e = 0; e < points.size(); ++e) {
      if (std::find(simplex.begin(), simplex.end(), e) != simplex.end()) continue;
      rows.back() = lifted[e];
      // A point on the hyperplane at height 0 that is raised by h turns the determinant into -h times the
      // volume: the height stands one column before the last.
      if (sgn(determinant(rows)) * volume > 0) return;
    }
    result.push_back(simplex);
  });
  return result;
}

/// The facets that only one of the simplices has, in lexicographic order.
template <std::size_t N>
std::vector<IdSet<N - 1>> boundary_of(const std::vector<IdSet<N>>& simplices) {
  std::vector<IdSet<N - 1>> facets;
  for (const IdSet<N>& simplex : simplices) {
    for (std::size_t i = 0; i < N; ++i) {
      IdSet<N - 1> facet;
      std::remove_copy(simplex.begin(), simplex.end(), facet.begin(), simplex[i]);
      facets.push_back(facet);
    }
  }
  std::sort(facets.begin(), facets.end());
  std::vector<IdSet<N - 1>> single;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const bool has_twin =
        (i > 0 && facets[i - 1] == facets[i]) || (i + 1 < facets.size() && facets[i + 1] == facets[i]);
    if (!has_twin) single.push_back(facets[i]);
  }
  return single;
}

/// With one ghost for each facet of the boundary, in lexicographic order; infinity has the largest id.
template <std::size_t N>
std::vector<IdSet<N>> with_ghosts(std::vector<IdSet<N>> simplices) {
  for (const IdSet<N - 1>& facet : boundary_of(simplices)) {
    IdSet<N> ghost;
    std::copy(facet.begin(), facet.end(), ghost.begin());
    ghost.back() = ~std::uint32_t{0};
    simplices.push_back(ghost);
  }
  std::sort(simplices.begin(), simplices.end());
  return simplices;
}

}  // namespace sinkmesh::test
