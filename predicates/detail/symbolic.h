// SPDX-License-Identifier: MIT
//
// The last stage of the perturbed predicates: simulation of simplicity in the lifted coordinate [EM90; PS, 2].
//
// Every point carries the weight -eps_rank, eps_0 >> eps_1 >> ... > 0, ranked by the lexicographic order of the
// coordinates. Both predicates are affine in the weights, so their sign at a tie is that of the first nonzero
// coefficient, in the order of the ranks, negated because the weights are negative. The ranks only choose where
// to look: a coefficient keeps the original order of the points, and no parity of a permutation enters.
#pragma once

#include <array>
#include <cstddef>

#include "predicates/error.h"
#include "predicates/polynomials.h"

namespace sinkmesh::detail {

/// Visits the points in increasing rank, finding each only when it is asked for: the first one or two decide.
template <std::size_t Dim, std::size_t N>
class ByRank {
 public:
  explicit ByRank(const std::array<const std::array<double, Dim>*, N>& points) : points_(points) {}

  /// The index of the next point; at most N calls.
  std::size_t next() {
    std::size_t lowest = N;
    for (std::size_t i = 0; i < N; ++i) {
      if (!visited_[i] && (lowest == N || precedes(*points_[i], *points_[lowest]))) lowest = i;
    }
    visited_[lowest] = true;
    return lowest;
  }

 private:
  static bool precedes(const std::array<double, Dim>& p, const std::array<double, Dim>& q) {
    for (std::size_t k = 0; k + 1 < Dim; ++k) {
      if (p[k] != q[k]) return p[k] < q[k];
    }
    return p[Dim - 1] < q[Dim - 1];
  }

  const std::array<const std::array<double, Dim>*, N>& points_;
  std::array<bool, N> visited_{};
};

/// For a simplex of positive volume, corners first, cospherical with the last point x. The coefficient of x is
/// the volume, that of corner i minus the volume with x in place of i. The points of the two lowest ranks
/// always decide: if both coefficients vanished, all points would lie in one plane [PS, 2].
/// @param orient  sign of the volume of a simplex.
template <int Dim, class Orient>
int in_sphere_at_tie(const Points<InSphere<Dim>>& points, Orient orient) {
  ByRank<Dim, Dim + 2> by_rank(points);
  int sign = 0;
  for (int rank = 0; rank < 2 && sign == 0; ++rank) {
    const std::size_t i = by_rank.next();
    if (i == Dim + 1) return -1;
    Corners<Dim> replaced;
    for (std::size_t j = 0; j <= Dim; ++j) replaced[j] = points[j == i ? Dim + 1 : j];
    sign = orient(replaced);
  }
  SINKMESH_ASSERT(sign != 0);
  return sign;
}

/// The points that FacetNormals takes for corner i of the facet.
template <int Dim>
Points<FacetNormals<Dim>> facet_normals_at(const Points<Diametral<Dim>>& points, std::size_t i) {
  if constexpr (Dim == 2) {
    return {points[i], points[1 - i], points[2]};
  } else {
    return {points[i], points[(i + 1) % 3], points[(i + 2) % 3], points[3]};
  }
}

/// For a simplex of nonzero volume, facet first, whose apex lies on the diametral sphere of the facet. The
/// coefficient of corner i is -N_i . N_apex, hence negative for the apex itself; they sum to 0, so one of the
/// first three decides.
/// @param normals  sign of FacetNormals.
template <int Dim, class Normals>
int flow_at_tie(const Points<Diametral<Dim>>& points, Normals normals) {
  ByRank<Dim, Dim + 1> by_rank(points);
  int sign = 0;
  for (int rank = 0; rank < Dim && sign == 0; ++rank) {
    const std::size_t i = by_rank.next();
    if (i == Dim) return 1;
    sign = normals(facet_normals_at<Dim>(points, i));
  }
  SINKMESH_ASSERT(sign != 0);
  return sign;
}

}  // namespace sinkmesh::detail
