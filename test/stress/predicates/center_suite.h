// SPDX-License-Identifier: MIT
//
// What circumcenter() and the constructions promise about their rounded results.
#pragma once

#include <memory>

#include "test/stress/suite.h"

namespace sinkmesh::stress {

/// Dim is 2 or 3.
template <int Dim>
std::unique_ptr<Suite> make_center_suite();

}  // namespace sinkmesh::stress
