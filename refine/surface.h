// SPDX-License-Identifier: MIT
//
// What goes in: surfaces that bound solids in space, a straight-line graph in the plane.
#pragma once

#include <cstdint>
#include <vector>

#include "predicates/point.h"

namespace sinkmesh {

/// Facets over an indexed set of points. Units and ids are the user's.
template <int Dim>
struct Surface {
  using Facet = std::array<std::uint32_t, Dim>;

  /// A point that stands for the region which holds it.
  struct RegionSeed {
    Point<Dim> point;
    std::int64_t tag = 0;
  };

  std::vector<Point<Dim>> points;
  std::vector<Facet> facets;

  /// One per facet, or none at all. The pieces of a facet carry its tag; facets with different tags are never
  /// joined to one patch.
  std::vector<std::int64_t> facet_tags = {};
  /// If there is any hole or region, every bounded region is inside but those that hold one of `holes`; else
  /// parity decides (Domain).
  std::vector<Point<Dim>> holes = {};
  std::vector<RegionSeed> regions = {};
};
using Surface2 = Surface<2>;
using Surface3 = Surface<3>;

}  // namespace sinkmesh
