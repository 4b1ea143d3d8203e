// SPDX-License-Identifier: MIT
//
// A surface as a case. A row is a point and its id; the facets, triples or pairs of ids, are a setting. When
// shrinking leaves out rows, edges are contracted: what was closed stays closed.
#pragma once

#include "refine/surface.h"
#include "test/stress/case.h"

namespace sinkmesh::stress {

template <int Dim>
void set_surface(Case& c, const Surface<Dim>& surface);

/// A missing vertex gives way to the least of its neighbors; facets that collapse, and pairs that coincide, are
/// left out, and so are points without facets.
/// @throws CaseError if rows or facets are none.
template <int Dim>
Surface<Dim> surface_of(const Case& c);

/// Whether it can be meshed: no error found by check_surface(), and no coordinate rounded by the gate.
template <int Dim>
bool is_meshable(const Surface<Dim>& surface);

/// The same for the surface of a case.
template <int Dim>
bool has_meshable_surface(const Case& c);

}  // namespace sinkmesh::stress
