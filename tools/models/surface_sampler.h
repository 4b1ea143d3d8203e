// SPDX-License-Identifier: MIT
//
// Triangulates the surface of an implicitly given solid.
#pragma once

#include <cstddef>

#include "refine/surface.h"
#include "tools/models/implicit_solid.h"

namespace sinkmesh::models {

/// A triangulated surface with about `triangles` facets, all Delaunay among its vertices, none crossed by the
/// flow, and oriented outward.
///
/// A tetrahedron of the Delaunay triangulation of points on the surface counts as inside if its circumcenter is
/// inside the solid; the facets between inside and outside are the surface's triangles, and the dual edge of
/// each crosses the surface of the solid at the center of an empty ball. Starting with the seeds, the center of
/// the ball that is largest in units of the wanted size is inserted, until there are enough points: that
/// spreads them evenly, so triangles come out well shaped. Then centers of facets through which the flow leads
/// out are inserted until there are none.
///
/// @throws std::logic_error if the result is no topological sphere, which too few triangles for the solid's
///         features lead to.
/// Cost: O(n log n) in practice; 75,000 triangles take seconds.
Surface3 sample_surface(const ImplicitSolid& solid, std::size_t triangles);

}  // namespace sinkmesh::models
