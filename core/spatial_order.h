// SPDX-License-Identifier: MIT
//
// The order in which bulk loading inserts points: biased random rounds, each along a Hilbert curve.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "predicates/point.h"

namespace sinkmesh {

/// The order of insertion of a point set, and which points are copies of others.
struct InsertionOrder {
  /// Indices of distinct points. A function of the set of points: it does not depend on their order in the
  /// input.
  std::vector<std::uint32_t> order;

  struct Duplicate {
    std::uint32_t copy;
    std::uint32_t original;  ///< the first of the equal points
  };
  std::vector<Duplicate> duplicates;  ///< by increasing copy
};

/// Rounds: the last holds 7/8 of the points, the one before 7/8 of the rest, and so on (a biased randomised
/// insertion order, Amenta, Choi, Rote 2003); a hash of the coordinates decides, so there is no seed. Within a
/// round the points follow a Hilbert curve through their box; points that share a cell of the curve are ordered
/// again along a curve of their own box. Equal points meet on the way and are reported.
///
/// @param points  finite coordinates, -0.0 excluded (equal points have equal bits).
/// @param box     holds all points.
/// Cost: linear, but for sets that are clustered through many orders of magnitude.
template <int Dim>
InsertionOrder insertion_order(std::span<const Point<Dim>> points, const Box<Dim>& box);

}  // namespace sinkmesh
