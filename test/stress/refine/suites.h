// SPDX-License-Identifier: MIT
//
// The suites of stress_refine, in the plane and in space.
#pragma once

#include <memory>

#include "test/stress/suite.h"

namespace sinkmesh::stress {

/// Refinements to the end, or to a generous limit, looked at from outside and repeated.
template <int Dim>
std::unique_ptr<Suite> make_mesh_suite();

/// Refinements that a budget or a cancellation ends at a random moment, then continued.
template <int Dim>
std::unique_ptr<Suite> make_stop_suite();

/// The same surface with points and facets in another order: the same mesh.
template <int Dim>
std::unique_ptr<Suite> make_numbering_suite();

}  // namespace sinkmesh::stress
