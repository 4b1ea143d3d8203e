// SPDX-License-Identifier: MIT
//
// A smaller case that fails in the same way.
#pragma once

#include <functional>

#include "test/stress/case.h"

namespace sinkmesh::stress {

/// Leaves out rows by delta debugging (A. Zeller, R. Hildebrandt: Simplifying and isolating failure-inducing
/// input, 2002), then makes numbers simpler: small integers, fewer bits, until neither helps any more.
/// @param c       a case that fails.
/// @param fails   whether another one is legal and fails in the same way.
/// @param seconds after which it stops with the best so far.
Case shrink(Case c, double seconds, const std::function<bool(const Case&)>& fails);

}  // namespace sinkmesh::stress
