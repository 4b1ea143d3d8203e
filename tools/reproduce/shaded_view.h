// SPDX-License-Identifier: MIT
//
// The two kinds of pictures of models in space: a surface from outside, and a look into a mesh.
#pragma once

#include "refine/mesh.h"
#include "refine/surface.h"
#include "tools/reproduce/colour_map.h"
#include "tools/reproduce/cut.h"
#include "tools/reproduce/image.h"
#include "tools/reproduce/view.h"

namespace sinkmesh::reproduce {

/// The surface, flat shaded, in neutral colour, with its edges where they can be told apart.
/// @throws InputError as Projection.
Image surface_view(const Surface3& surface, const View& view, int width, int height);

/// The tetrahedra that the cut keeps: faces on the cut in the colour of the ratio r/l of their tetrahedron,
/// faces of the surface neutral. The picture is fitted to the vertices that the cut keeps, and inside a surface
/// refinement changes nothing about their extent: pictures of a mesh before and after cover each other.
/// @throws InputError as Projection.
Image cut_view(const Mesh3& mesh, const Cut& cut, const View& view, const RatioScale& scale, int width,
               int height);

}  // namespace sinkmesh::reproduce
