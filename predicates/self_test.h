// SPDX-License-Identifier: MIT
//
// A start-up check of the arithmetic that the exact signs rest on [PS, 14].
#pragma once

#include <string>

namespace sinkmesh {

/// Detects, in this process and for the current thread: fused multiplications, flush-to-zero, a rounding mode
/// other than to nearest, and wrong signs of known vectors. Shared objects linked with -ffast-math can switch
/// on flush-to-zero for the whole process. Not called by the library; programs call it once.
/// @return empty if all is well, otherwise one line that names what is wrong.
std::string predicates_self_test();

}  // namespace sinkmesh
