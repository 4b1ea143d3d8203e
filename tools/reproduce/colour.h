// SPDX-License-Identifier: MIT
//
// Colours to compute with: light adds up linearly, eyes see roughly its cube root.
#pragma once

#include <array>

#include "tools/reproduce/image.h"

namespace sinkmesh::reproduce {

/// Linear light: red, green, blue in [0, 1], with the primaries of sRGB.
using Light = std::array<double, 3>;

/// A colour by what is seen: lightness in [0, 1], chroma (0 is grey), hue in degrees. Coordinates are polar
/// ones of the Oklab space (B. Ottosson, 2020), in which equal distances look about equal.
struct Perceived {
  double lightness;
  double chroma;
  double hue;
};

/// Clamped to the colours that a screen has.
Light to_light(const Perceived& colour);

/// The eye's response to the brightness of a colour, 0 to 1: CIE L*, divided by 100.
double luminance_seen(const Light& colour);

/// @param opacity  0 to 1.
Pixel to_pixel(const Light& colour, double opacity = 1);
Light to_light(const Pixel& pixel);

}  // namespace sinkmesh::reproduce
