// SPDX-License-Identifier: MIT
//
// Side surfaces of prisms: rows of vertices around a cross-section, stacked along z.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "refine/surface.h"

namespace sinkmesh::models {

/// One piece of a closed cross-section, divided into `segments`.
struct SectionPiece {
  /// From the start, t = 0, to the end, t = 1, at constant speed; moved outward by the other argument.
  std::function<Point2(double t, double outward)> at;
  double length;
  int segments;
  /// The vertices between the ends are moved along by this fraction of a segment, and up by the other fraction
  /// of the distance of rows: opposite sides of a thin wall should not mirror each other.
  double shift_along = 0;
  double shift_up = 0;
  /// They are moved inward or outward by up to this length, so that those of a round piece are not cospherical.
  double roughness = 0;
};

/// The side of a prism from z = 0 to z = height, open at both ends, normals to the right of the section's
/// direction: outward if it runs counterclockwise.
struct Tube {
  std::vector<Point3> points;
  std::vector<Surface3::Facet> facets;
  /// The vertices at z = 0 and z = height, along the section.
  std::vector<std::uint32_t> bottom;
  std::vector<std::uint32_t> top;
};

/// Every other row is shifted by half a segment, but keeps the ends of each piece: its first and last segment
/// are longer by half. A piece of a single segment has rectangles.
/// @param has_corners  pieces meet in edges along z, whose vertices stay in place; if not, there must be one
///                     piece, and its rows are shifted as a whole.
///
/// Every vertex is moved by up to kTubeJitter of a segment along the section and, except in the first and
/// last row, of the rows' distance up or down: within its side, which stays as flat as it is. Without that,
/// vertices of opposite sides and of neighboring rows are cospherical.
Tube make_tube(const std::vector<SectionPiece>& section, bool has_corners, double height, int rows);
inline constexpr double kTubeJitter = 0.002;

/// Number of facets of that tube.
std::size_t tube_facets(const std::vector<SectionPiece>& section, bool has_corners, int rows);

}  // namespace sinkmesh::models
