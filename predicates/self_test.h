// SPDX-License-Identifier: MIT
//
// Does this build, in this process, compute what the proofs of the predicates assume?
#pragma once

#include <string>

namespace sinkmesh {

/// Tests rounding to nearest, gradual underflow, the absence of fused operations, and known signs of every
/// predicate. A library linked with -ffast-math can switch on flush-to-zero for the whole process, so programs
/// call this at start.
/// @return what is wrong, in one line; empty if nothing is. Microseconds.
std::string predicates_self_test();

}  // namespace sinkmesh
