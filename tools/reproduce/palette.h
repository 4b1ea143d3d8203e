// SPDX-License-Identifier: MIT
//
// Fewer colours, smaller files.
#pragma once

#include <cstddef>

#include "tools/reproduce/image.h"

namespace sinkmesh::reproduce {

/// Replaces every colour by the mean of its box of a median cut into at most `max_colours` boxes of colours.
/// Transparent and opaque pixels stay exactly that. Deterministic. Cost: n log n in the number of colours.
void reduce_colours(Image& image, std::size_t max_colours = 256);

}  // namespace sinkmesh::reproduce
