// SPDX-License-Identifier: MIT
//
// What every triangulation starts from: Dim+1 affinely independent points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/complex.h"
#include "predicates/staged.h"

namespace sinkmesh {

/// Adds the points in the given order as vertices of an empty complex, and makes the solid simplex of the first
/// Dim+1 of them with its ghosts.
///
/// @param order  indices of distinct points. Those of Dim+1 affinely independent ones are moved to its front;
///               points that are passed over keep their order.
/// @return how many independent points there are. If not Dim+1, the points lie in one hyperplane, and the
///         complex stays empty.
template <int Dim>
std::size_t make_first_simplex(Complex<Dim>& complex, const Predicates<Dim>& predicates,
                               std::span<const Point<Dim>> points, std::vector<std::uint32_t>& order);

}  // namespace sinkmesh
