// SPDX-License-Identifier: MIT
//
// What goes in: a closed surface in space, a closed polygon in the plane.
#pragma once

#include <cstdint>
#include <vector>

#include "predicates/point.h"

namespace sinkmesh {

/// Facets over an indexed set of points. Units and ids are the user's.
template <int Dim>
struct Surface {
  using Facet = std::array<std::uint32_t, Dim>;

  std::vector<Point<Dim>> points;
  std::vector<Facet> facets;
};
using Surface2 = Surface<2>;
using Surface3 = Surface<3>;

}  // namespace sinkmesh
