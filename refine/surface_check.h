// SPDX-License-Identifier: MIT
//
// What is wrong with a surface: every defect, by kind, with ids and coordinates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "refine/surface.h"

namespace sinkmesh {

/// In the plane read "segment" for facet and "vertex" for edge.
enum class SurfaceDefectKind : std::uint8_t {
  index_out_of_range,        ///< a facet refers to a vertex that does not exist
  not_finite,                ///< a vertex has an infinite or undefined coordinate
  repeated_vertex,           ///< a facet has a vertex twice
  degenerate_facet,          ///< the corners of a facet are collinear, exactly; in the plane: equal
  duplicate_vertex,          ///< vertices with equal coordinates; -0 equals 0
  duplicate_facet,           ///< facets with the same vertices, in any order
  open_edge,                 ///< in space, an edge of one facet only: the surface is not closed
  self_intersection,         ///< two facets have more in common than a vertex or an edge
  inconsistent_orientation,  ///< two neighbors run along their common edge in the same direction
  nonmanifold_edge,          ///< note: an edge of more than two facets, as where an internal facet ends
  nonmanifold_vertex,        ///< note: the facets around a vertex form more than one fan: parts touch there
  dangling_end,              ///< note: in the plane, a vertex of one segment only
  unused_vertex,             ///< note: no facet uses the vertex
  inside_out,                ///< note: closed and consistent, but the normals point inward
};

enum class SurfaceSeverity : std::uint8_t {
  note,         ///< worth knowing, and no obstacle: the surface can be meshed
  orientation,  ///< refinement decides inside by parity and does not mind; whoever needs normals does
  error,        ///< the surface cannot be meshed
};

struct SurfaceDefect {
  SurfaceDefectKind kind{};
  /// Ascending; except that the two vertices of an edge stand in the order of the first facet.
  std::vector<std::uint32_t> facets;
  std::vector<std::uint32_t> vertices;
  /// One line: what, where, with ids and coordinates.
  std::string message;
};

SurfaceSeverity severity(SurfaceDefectKind kind);
/// "open edge".
std::string_view name_of(SurfaceDefectKind kind);
/// What to do about it, as a clause: "close the hole".
std::string_view advice(SurfaceDefectKind kind);

/// What to look for: self-intersections are most of the cost, and none are possible where all facets are in one
/// triangulation.
enum class SurfaceChecks : std::uint8_t { all, without_intersections };

/// Every defect, ordered by kind and then by ids: the same surface gives the same list. Facets with an index
/// out of range or a repeated vertex take no part in what concerns edges and vertices. Works on any arrays;
/// never throws but for lack of memory.
///
/// Collinearity is exact: decided by the signs of orient2d in the coordinate planes, after scaling the facet by
/// a power of two. Coordinates smaller than the facet's largest by a factor beyond 2^400 may be lost in that.
/// For self-intersections see self_intersections.h: one defect for each pair.
/// Cost: O(n log n); about 0.1 s for 270,000 triangles, and 0.3 s for self-intersections if there are none.
template <int Dim>
[[nodiscard]] std::vector<SurfaceDefect> check_surface(const Surface<Dim>& surface,
                                                       SurfaceChecks checks = SurfaceChecks::all);

/// Counts of a surface. In the plane, edges are the vertices that segments share, and euler_characteristic that
/// of the curve.
struct SurfaceSummary {
  std::size_t vertices = 0;  ///< used by a facet
  std::size_t edges = 0;
  std::size_t facets = 0;      ///< those that take part: indices in range, no vertex twice
  std::size_t components = 0;  ///< connected by shared vertices
  std::int64_t euler_characteristic = 0;
  /// Closed, every edge has two facets and every vertex one fan; in space also oriented consistently, so that
  /// the genus means something.
  bool is_manifold = false;
  /// Sum over the components, of a manifold in space; otherwise 0.
  std::int64_t genus = 0;
  /// Volume, in the plane area, in units of the input; positive if the normals point outward. Rounded, and 0
  /// unless closed and consistently oriented.
  double signed_volume = 0;
};

/// Cost: as check_surface.
template <int Dim>
[[nodiscard]] SurfaceSummary summarize_surface(const Surface<Dim>& surface);

}  // namespace sinkmesh
