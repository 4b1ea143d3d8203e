// SPDX-License-Identifier: MIT
//
// Faces, light and edges to a picture.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "tools/reproduce/colour.h"
#include "tools/reproduce/image.h"
#include "tools/reproduce/view.h"

namespace sinkmesh::reproduce {

/// A flat triangle. Corners are counterclockwise seen from outside; from inside it is seen, too, but darker.
struct Face {
  std::array<std::uint32_t, 3> corners;
  Light colour;
  /// How much the light changes the colour: 1 for matter, less where the colour has to be recognised.
  double relief = 1;
};

/// Edges show where triangles are large enough in the picture. The background is transparent; at most 256
/// colours. Deterministic. Cost: linear in the number of faces, and in the area of the picture.
Image render(std::span<const Point3> points, std::span<const Face> faces, const Projection& projection,
             int width, int height);

}  // namespace sinkmesh::reproduce
