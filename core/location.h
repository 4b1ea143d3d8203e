// SPDX-License-Identifier: MIT
//
// Point location: the visibility walk.
#pragma once

#include <array>
#include <cstdint>

#include "core/complex.h"
#include "predicates/staged.h"

namespace sinkmesh {

/// Where a point lies.
template <int Dim>
struct Location {
  /// The solid simplex whose closure holds the point, or a ghost whose hull facet the point lies strictly
  /// beyond.
  Simplex simplex;
  /// In a solid simplex: the signs of the barycentric coordinates, 0 or 1. All 1: in the interior; one 0: in
  /// the facet opposite that corner; a single 1: at that corner. In a ghost: all 0.
  std::array<std::int8_t, Dim + 1> sign{};
  /// Simplices visited on the way.
  int steps = 0;

  /// The number of signs that are 1.
  int support() const {
    int count = 0;
    for (const std::int8_t s : sign) count += s;
    return count;
  }
  bool is_at_corner() const { return support() == 1; }
};

/// Walks from `start` through facets that separate a simplex from p, strictly and exactly. In a Delaunay
/// triangulation this ends: every step goes up in the order of the powers of p, which has no cycle
/// (Edelsbrunner 1990, acyclicity in depth order); so no step is counted and nothing is random [PS, 10].
/// Requires that p is covered by the predicates, and a Delaunay triangulation.
template <int Dim>
Location<Dim> walk_to(const Complex<Dim>& complex, const Predicates<Dim>& predicates, const PointArg<Dim>& p,
                      Simplex start);

/// The same walk, but it stops at the first simplex in conflict with p, which is half the way for a prestar's
/// sake. Requires that p is no vertex.
template <int Dim>
Location<Dim> walk_to_conflict(const Complex<Dim>& complex, const Predicates<Dim>& predicates,
                               const PointArg<Dim>& p, Simplex start);

}  // namespace sinkmesh
