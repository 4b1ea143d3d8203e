// SPDX-License-Identifier: MIT
//
// Random surfaces that can be meshed.
#pragma once

#include "refine/surface.h"
#include "test/stress/suite.h"

namespace sinkmesh::stress {

/// Boxes, wedges, spires, plates, hulls, several regions; polygons, stars, combs, planar graphs: placed by
/// exact and by rounded maps. Each can be meshed (surface_case.h), and has no unused points.
template <int Dim>
Surface<Dim> random_surface(Random& random);

}  // namespace sinkmesh::stress
