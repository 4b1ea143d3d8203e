// SPDX-License-Identifier: MIT
//
// Fewer colours, smaller files.
#pragma once

#include <cstddef>

#include "tools/reproduce/image.h"

namespace sinkmesh::reproduce {

/// Divides the colours that occur into at most `max_colours` boxes, and replaces each by the mean of its box.
/// Transparent and opaque pixels stay exactly that. Deterministic. Cost: n log n in the number of pixels.
/// @param max_colours  at least 3.
void reduce_colours(Image& image, std::size_t max_colours = 256);

}  // namespace sinkmesh::reproduce
