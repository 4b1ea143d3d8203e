// SPDX-License-Identifier: MIT
//
// Text as people read it, and where it goes.
#pragma once

#include <string_view>

#include "tools/text/numbers.h"

namespace sinkmesh::program {

using text::count;
using text::duration;
using text::grouped;
using text::measure;
using text::megabytes;
using text::simplices;

/// Writes to standard output, or standard error.
/// @throws FileError if standard output takes no more.
void print(std::string_view text, bool to_standard_error = false);

}  // namespace sinkmesh::program
