// SPDX-License-Identifier: MIT
//
// Sinks and watersheds of a triangulation as data of its cells.
#pragma once

#include "core/triangulation.h"
#include "refine/mesh.h"

namespace sinkmesh::program {

struct FlowCounts {
  std::size_t sinks = 0;
  std::size_t to_omega_only = 0;  ///< simplices from which no sink is reached
};

/// Adds three fields to hull_mesh(triangulation). Sinks are numbered 0, 1, ... in the order of their cells.
///   watershed  the sink to which the steepest flow from the cell leads, -1 if all leads out of the hull
///   sink       the number of the sink that the cell is, or -1
///   sinks      how many sinks the cell flows to; in the plane at most one
/// Formats with one number per cell take the first.
template <int Dim>
FlowCounts add_flow_fields(const Triangulation<Dim>& triangulation, Mesh<Dim>& mesh);

}  // namespace sinkmesh::program
