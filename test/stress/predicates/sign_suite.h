// SPDX-License-Identifier: MIT
//
// One suite for each polynomial: every way to its sign, every stage alone, its laws and its tie rule, against
// exact integers.
#pragma once

#include "test/stress/suite.h"

namespace sinkmesh::stress {

/// All of them.
Suites make_sign_suites();

}  // namespace sinkmesh::stress
