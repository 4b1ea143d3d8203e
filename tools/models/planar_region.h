// SPDX-License-Identifier: MIT
//
// Triangulates a plane region without touching its outline.
#pragma once

#include <functional>
#include <vector>

#include "refine/mesh.h"

namespace sinkmesh::models {

/// A Delaunay triangulation of the region bounded by closed polygons, whose vertices come first in the result,
/// loop after loop, and then `interior_points` more, fewer if there is no room for them. No new point lies in
/// the diametral circle of a segment, so that the outline stays as it is.
///
/// The circumcenter of the triangle with the largest circumradius in units of `size` is inserted next, until
/// there are enough; thin triangles count as larger than they are.
///
/// @param loops  segments that are Delaunay, with nothing in their diametral circles.
/// @param size   wanted circumradius around a point, up to a common factor.
/// @throws std::logic_error if a segment is not Delaunay.
Mesh2 mesh_region(const std::vector<std::vector<Point2>>& loops,
                  const std::function<double(const Point2&)>& size, std::size_t interior_points);

}  // namespace sinkmesh::models
