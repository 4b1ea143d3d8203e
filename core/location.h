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

/// The walk itself, for those that want to stop on the way.
/// @param is_end     asked at each solid simplex: whether to stop there.
/// @param may_leave  asked at each facet that the walk wants to cross, as the half-facet of the simplex before
///                   it: if it may not, the walk stops there.
template <int Dim, class IsEnd, class MayLeave>
Location<Dim> visibility_walk(const Complex<Dim>& complex, const Predicates<Dim>& predicates,
                              const PointArg<Dim>& p, Simplex start, IsEnd&& is_end, MayLeave&& may_leave) {
  constexpr int kShortWalk = 4;
  Location<Dim> at;
  at.simplex = complex.is_ghost(start) ? complex.neighbor(start, Dim) : start;
  int entry = -1;
  for (;;) {
    ++at.steps;
    if (at.steps > kShortWalk) {
      // Where a long walk goes next is not in the cache, and waiting for it would be most of its time.
      const auto* const records = complex.records().data();
      for (const std::uint32_t mate : records[at.simplex.index()].mate) {
        __builtin_prefetch(&records[mate / Complex<Dim>::kCorners]);
      }
    }
    if (is_end(at.simplex)) return at;
    const Corners<Dim> corners = complex.corners(at.simplex);
    HalfFacet exit;
    // The facets are asked in a turning order: always the same first facet would draw the walk along one
    // direction.
    for (int k = 0; k <= Dim; ++k) {
      const int i = (k + at.steps) % (Dim + 1);
      at.sign[static_cast<std::size_t>(i)] =
          1;  // p was strictly beyond the facet of entry, seen from the other side
      if (i == entry) continue;
      Corners<Dim> seen = corners;
      seen[static_cast<std::size_t>(i)] = &p;
      const int side = predicates.orient(seen);
      if (side < 0) {
        exit = Complex<Dim>::half_facet(at.simplex, i);
        break;
      }
      at.sign[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(side);
    }
    if (exit.is_null() || !may_leave(exit)) return at;
    const HalfFacet next = complex.mate(exit);
    at.simplex = Complex<Dim>::simplex_of(next);
    entry = Complex<Dim>::corner_of(next);
    if (complex.is_ghost(at.simplex)) {
      at.sign = {};
      return at;
    }
  }
}

/// The same walk, but it stops at the first simplex in conflict with p, which is half the way for a prestar's
/// sake. Requires that p is no vertex.
template <int Dim>
Location<Dim> walk_to_conflict(const Complex<Dim>& complex, const Predicates<Dim>& predicates,
                               const PointArg<Dim>& p, Simplex start);

}  // namespace sinkmesh
