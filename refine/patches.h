// SPDX-License-Identifier: MIT
//
// Which facets of a surface in space lie in one plane: its patches [BR, 2].
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/complex.h"
#include "refine/boundary_features.h"

namespace sinkmesh {

/// A facet of a surface with its patch; turned so that it is counterclockwise in the projection of the patch.
struct PatchFacet {
  std::array<Vertex, 3> vertices;
  std::uint32_t patch;
};

/// A facet of a surface, or a part of one.
struct PlacedFacet {
  std::array<Vertex, 3> vertices;
  std::uint32_t parent;  ///< facet of the surface
};

/// The facets without needles: where a facet has a corner within `flat` of its longest edge, and that edge has
/// exactly one other facet, with the same tag, the two exchange their common edge for the other diagonal. What
/// was the needle has no area, and the other facet becomes two. The surface moves by less than `flat`.
std::vector<PlacedFacet> without_needles(const Complex<3>& complex,
                                         std::span<const std::array<Vertex, 3>> facets,
                                         std::span<const std::int64_t> tags, double flat);

/// Two facets at one edge.
struct Fold {
  std::uint32_t first;
  std::uint32_t second;
  double angle;  ///< between them, in radians

  /// The two facets need about 1 / angle^2 points to be Delaunay: that would be too many.
  bool is_too_sharp() const { return angle < 0x1p-16; }
};

/// The two facets that meet at the smallest angle, if there are two. Rounded. Log-linear.
std::optional<Fold> sharpest_fold(const Complex<3>& complex, std::span<const std::array<Vertex, 3>> facets);

/// Divides the facets into patches: maximal sets, connected through edges of exactly two facets with the same
/// tag, all of whose vertices lie within `flat` of the plane of the largest facet, and which do not fold in
/// projection. Grown from the largest facet first, ties by coordinates: the order of the file does not matter.
/// @param tags  one per facet of the surface, or none.
/// @param flat  a distance; 0: exactly coplanar facets only.
/// @param planes  receives the facet and the plane of each patch.
/// @return one entry for each facet.
/// Cost: log-linear.
std::vector<PatchFacet> find_patches(const Complex<3>& complex, std::span<const PlacedFacet> facets,
                                     std::span<const std::int64_t> tags, double flat,
                                     std::vector<BoundaryFeatures<3>::Patch>& planes);

}  // namespace sinkmesh
