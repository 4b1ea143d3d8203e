// SPDX-License-Identifier: MIT
//
// The flower of a set of simplices: the union of their Delaunay balls [EG01, 4.1].
#pragma once

#include <cstdint>
#include <span>

#include "core/triangulation.h"

namespace sinkmesh {

/// Where a point lies with respect to the closed balls of a set of simplices.
enum class FlowerSide : std::int8_t {
  outside = -1,  ///< in no closed ball: not in the flower
  sphere = 0,    ///< in a closed ball, strictly inside none
  inside = 1,    ///< strictly inside a ball: in the interior of the flower
};

/// Exact, unperturbed. The flower, a union of closed balls, is `inside` and `sphere` together.
///
/// Is `sphere` its boundary? A point y on spheres with centers z_1, z_2, ... and inside none is in the interior
/// iff the open half-spaces {u : u.(z_i - y) > 0} hold every direction u: a short step along such a u leads
/// into ball i, and along any other out of it. This takes at least Dim+1 spheres through y whose centers
/// surround it. So it happens at vertices of S whose star is (nearly) all in the set, and otherwise only if y
/// is cospherical with Dim+1 simplices. A union of open balls is smaller there than the interior of the flower.
///
/// @param set  ghosts among them have no ball, and are passed over.
/// @param y    gated coordinates, covered by the predicates (Triangulation::announce()).
/// Cost: one in-sphere test for each simplex.
template <int Dim>
FlowerSide flower_side(const Triangulation<Dim>& triangulation, std::span<const Simplex> set,
                       const PointArg<Dim>& y);

}  // namespace sinkmesh
