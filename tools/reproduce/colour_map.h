// SPDX-License-Identifier: MIT
//
// Colours of the ratio r/l, and the bar that explains them.
#pragma once

#include <string>

#include "tools/reproduce/colour.h"

namespace sinkmesh::reproduce {

/// From ratios to [0, 1], logarithmic on both sides of the bound: the ratio of the regular tetrahedron,
/// sqrt(3/8), goes to 0; the bound to 1/2; `worst` and all beyond to 1. Pictures that are compared share one
/// scale.
struct RatioScale {
  double bound = 2;   ///< above it, a tetrahedron is of low quality
  double worst = 20;  ///< more than the bound

  double position(double ratio) const;
};

/// The colour at a position in [0, 1] of the scale: blue, from pale to strong, below 1/2; orange, from bright
/// to dark brown, above. Lightness falls evenly all the way, so that the order can be seen without seeing hues;
/// blue against orange says "good or bad" to colour-blind eyes, too.
Light ratio_colour(double position);

/// A horizontal bar with ticks, as an <svg> for a page; text has the colour of the text around it.
std::string colour_bar_svg(const RatioScale& scale);

}  // namespace sinkmesh::reproduce
