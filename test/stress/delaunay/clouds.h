// SPDX-License-Identifier: MIT
//
// Clouds of all sizes for triangulations.
#pragma once

#include <vector>

#include "predicates/input_gate.h"
#include "test/stress/positions/positions.h"
#include "test/support/shapes.h"
#include "test/support/simplex_sets.h"

namespace sinkmesh::stress {

/// A few points: small integers, degenerate positions, exponents across the gate; on the grid of the gate,
/// distinct, in random order.
template <int Dim>
std::vector<Point<Dim>> small_cloud(std::size_t n, Random& random);

/// Up to about n points of a shape, or of up to four small positions that overlap. May have duplicates.
template <int Dim>
std::vector<Point<Dim>> cloud(std::size_t n, Random& random);

}  // namespace sinkmesh::stress
