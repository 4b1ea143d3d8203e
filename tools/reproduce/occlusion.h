// SPDX-License-Identifier: MIT
//
// Soft shadows in hollows, from a picture of depths alone: what lies behind its surroundings gets less light.
#pragma once

#include <vector>

namespace sinkmesh::reproduce {

/// One value per pixel of a picture.
struct Plane {
  int width;
  int height;
  std::vector<float> values;
};

/// How far each pixel lies behind the mean of its neighbourhood (before it: negative), in the units of depth.
///
/// @param depth    times coverage.
/// @param coverage 0 where there is nothing, 1 where a pixel is full; pixels that show nothing do not count.
/// @param radius   of the neighbourhood, in pixels: about the deviation of the bell that weights it.
/// Cost: linear, whatever the radius.
Plane behind_surroundings(const Plane& depth, const Plane& coverage, int radius);

}  // namespace sinkmesh::reproduce
