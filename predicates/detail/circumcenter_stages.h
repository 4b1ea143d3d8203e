// SPDX-License-Identifier: MIT
//
// The two ways to a correctly rounded circumcenter, each alone.
#pragma once

#include "predicates/point.h"

namespace sinkmesh::detail {

enum class CenterResult {
  kInside,   ///< the center was set
  kOutside,  ///< it does not lie in [-2, 2]^Dim
  kUnknown   ///< this way could not decide
};

/// Exact integers of 64-bit differences, then a quotient in twice the working precision with an error bound;
/// kUnknown where a coordinate might round either way.
template <int Dim>
CenterResult certified_circumcenter(const Corners<Dim>& s, Point<Dim>& center);

/// Long division of integers on the gate's grid. Never kUnknown.
template <int Dim>
CenterResult exact_circumcenter(const Corners<Dim>& s, Point<Dim>& center);

}  // namespace sinkmesh::detail
