// SPDX-License-Identifier: MIT
//
// Makes a polygon with fewer vertices whose edges are Delaunay and stable.
#pragma once

#include <cstddef>
#include <vector>

#include "predicates/point.h"

namespace sinkmesh::models {

/// A polygon with that many vertices on a closed curve, in the same direction. Every edge is in the Delaunay
/// triangulation of the vertices, and the apex of its inner triangle is strictly outside its diametral circle,
/// so that no flow leads out; exactly, by predicates.
///
/// The curve's most important points come first (Visvalingam, Whyatt 1993); then every edge that is not as it
/// should be is divided at the corner of the curve nearest to its middle, or on the curve's straight piece if
/// no corner is left. The number of important points is the largest for which this does not give too many
/// vertices; the rest are single points, by importance, that can be added without harm.
///
/// @param curve     a simple polygon, counterclockwise, with more than 3 points.
/// @param vertices  at least 10; there may be fewer in the result if no single point is harmless.
/// Cost: O(log n) times a dozen triangulations of the result; 0.3 s for 2,000 vertices.
std::vector<Point2> simplify_outline(const std::vector<Point2>& curve, std::size_t vertices);

}  // namespace sinkmesh::models
