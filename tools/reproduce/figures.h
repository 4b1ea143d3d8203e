// SPDX-License-Identifier: MIT
//
// Figures 1 to 7 of [EG01], for the plane: each one <svg> element, computed by the library.
#pragma once

#include <string>

#include "refine/surface.h"

namespace sinkmesh::reproduce {

// Every function returns the same text for the same input: an <svg> with id "figure-1" ... "figure-7", a title
// and a description, below 400 kB for the paper's data. `usa` is the polygon of the USA data set.

/// Figure 1: level sets of pi_S under the Voronoi diagram, of phi_S under the Delaunay triangulation.
std::string figure_level_sets();
/// Figure 2: sinks and their ancestor sets in the stable subcomplex of a polygon.
std::string figure_watersheds(const Surface2& usa);
/// Figure 3: the graph of phi over the polygon, upside down, as a terraced landscape.
std::string figure_graph_of_phi(const Surface2& usa);
/// Figure 4: the flow relation between two triangles, and in the triangulation they are from.
std::string figure_flow_relation();
/// Figure 5: the prestar and the star of a point, and their flowers.
std::string figure_flowers();
/// Figure 6: the first sinks of the incremental schedule; none, 4, 12, 15 of them.
std::string figure_first_sinks(const Surface2& usa);
/// Figure 7: the meshes of the block schedule, with sinks and with circumcenters.
std::string figure_block_meshes(const Surface2& usa);

}  // namespace sinkmesh::reproduce
