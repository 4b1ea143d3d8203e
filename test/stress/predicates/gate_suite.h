// SPDX-License-Identifier: MIT
//
// What the input gate promises, for any doubles.
#pragma once

#include <memory>

#include "test/stress/suite.h"

namespace sinkmesh::stress {

/// Dim is 2 or 3.
template <int Dim>
std::unique_ptr<Suite> make_gate_suite();

}  // namespace sinkmesh::stress
