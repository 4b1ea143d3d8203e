// SPDX-License-Identifier: MIT
//
// What the rest of the project does with what a reader returned.
#pragma once

#include "test/stress/suite.h"
#include "test/support/readers.h"

namespace sinkmesh::stress {

/// Writes it in every format that can hold it and reads it back; checks the surface, triangulates its points
/// and refines it, or checks the mesh. Whatever the arrays hold, each step succeeds or says why not.
/// @throws CheckFailed
void expect_usable(const test::Contents& contents, Counters& counters);

}  // namespace sinkmesh::stress
