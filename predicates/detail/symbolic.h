// SPDX-License-Identifier: MIT
//
// Simulation of simplicity in the lifted coordinate, for ties [EM90; PS, 2].
//
// Every point has the weight -eps_rank, rank by lexicographic order of the coordinates, eps_0 >> eps_1 >> ... >
// 0. Both perturbed polynomials are affine in the weights, so a tie is decided by the first point, in the order
// of ranks, whose coefficient is not zero: the sign is minus that of the coefficient.
#pragma once

#include <array>
#include <cstddef>

#include "predicates/point.h"

namespace sinkmesh::detail {

/// Calls coefficient(i) for the points by increasing rank until one is not zero.
/// @return minus its sign; 0 if all are zero.
template <class P, std::size_t N, class Coefficient>
int first_coefficient(const std::array<const P*, N>& points, Coefficient&& coefficient) {
  std::array<bool, N> done{};
  for (std::size_t round = 0; round < N; ++round) {
    std::size_t lowest = N;
    for (std::size_t i = 0; i < N; ++i) {
      if (!done[i] && (lowest == N || *points[i] < *points[lowest])) lowest = i;
    }
    done[lowest] = true;
    if (const int sign = coefficient(lowest)) return -sign;
  }
  return 0;
}

/// Ties of in_sphere: `points` are the corners of a simplex, then x. The coefficient of x is D, that of corner
/// i is minus D with corner i replaced by x; orient(corners) gives signs of D.
template <std::size_t N, class P, class Orient>
int in_sphere_tie(const std::array<const P*, N>& points, Orient&& orient) {
  return first_coefficient(points, [&](std::size_t i) {
    std::array<const P*, N - 1> corners;
    for (std::size_t k = 0; k + 1 < N; ++k) corners[k] = points[k == i ? N - 1 : k];
    return i == N - 1 ? orient(corners) : -orient(corners);
  });
}

/// Ties of the flow: `points` are the corners of a facet, then the apex. In space the coefficient of point i is
/// -N_apex . N_i, for the normals N of the facets opposite the points; in the plane the same with edges.
int flow_tie(const std::array<const Point2*, 3>& points);
int flow_tie(const std::array<const Point3*, 4>& points);

}  // namespace sinkmesh::detail
