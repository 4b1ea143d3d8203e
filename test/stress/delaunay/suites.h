// SPDX-License-Identifier: MIT
//
// The suites of stress_delaunay, in the plane and in space.
#pragma once

#include <memory>

#include "test/stress/suite.h"

namespace sinkmesh::stress {

/// Small clouds of any doubles: both engines against the complex by definition, in two orders.
template <int Dim>
std::unique_ptr<Suite> make_oracle_suite();

/// Points inserted one by one, by either engine, with every invariant checked after each: the complex must be
/// that of all points at once.
template <int Dim>
std::unique_ptr<Suite> make_insertion_suite();

/// Insertions, removals, locations, copies and looks at prestars in any order, with every invariant checked
/// after each, and the complex that of the points that are left.
template <int Dim>
std::unique_ptr<Suite> make_calls_suite();

/// Integer points: volumes and hull by integers.
template <int Dim>
std::unique_ptr<Suite> make_hull_suite();

/// Hundreds of points: the same hash from both engines, in any order; the same complex translated and scaled.
template <int Dim>
std::unique_ptr<Suite> make_order_suite();

/// A million points in space, by several degenerate shapes, one suite each.
Suites make_large_suites();

}  // namespace sinkmesh::stress
