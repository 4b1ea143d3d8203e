// SPDX-License-Identifier: MIT
//
// Sets of simplices around a face or a point: star, prestar, closure, boundary [EG01, 2.1, 4.1].
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/triangulation.h"

namespace sinkmesh {

// A set of simplices of all dimensions is stood for by its Dim-simplices, ghosts included: those of the star of
// a vertex or of a prestar determine the rest. Of Pt x = Cl I - Cl E [EG01, 4.1] they are I, and a lower
// simplex belongs to it iff all its Dim-dimensional cofaces are in I.

/// The Dim-simplices that have all vertices of `face` as corners, in the order of a search from `start`, which
/// must be one of them. Linear in the result.
template <int Dim>
std::vector<Simplex> star(const Complex<Dim>& complex, std::span<const Vertex> face, Simplex start);

/// The star of a vertex that is in the complex.
template <int Dim>
std::vector<Simplex> star(const Complex<Dim>& complex, Vertex v) {
  return star(complex, std::span<const Vertex>(&v, 1), complex.incident_simplex(v));
}

/// The prestar of a point: the simplices in conflict with it, those that its insertion would replace by its
/// star. Empty if x is a vertex. For a point strictly inside the hull none is a ghost.
///
/// Conflict is perturbed (in_conflict()): for x cospherical with a simplex it is the choice that insertion
/// makes.
/// @param triangulation  is as before at the return; x has been announced to its predicates.
/// @param x              gated coordinates.
/// Cost: location and one search.
template <int Dim>
std::vector<Simplex> prestar(Triangulation<Dim>& triangulation, const PointArg<Dim>& x, Simplex hint = {});

/// The vertices of the closure of a set, increasing, infinity first if it is there.
template <int Dim>
std::vector<Vertex> closure_vertices(const Complex<Dim>& complex, std::span<const Simplex> set);

/// The facets that belong to one simplex of the set only, as half-facets of that one, in its order. For an
/// ancestor set, the bold edges of [EG01, Figure 2]. Log-linear.
template <int Dim>
std::vector<HalfFacet> boundary(const Complex<Dim>& complex, std::span<const Simplex> set);

}  // namespace sinkmesh
