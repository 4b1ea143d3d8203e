// SPDX-License-Identifier: MIT
//
// Walking around a ridge: a vertex in the plane, an edge in space.
#pragma once

#include <vector>

#include "core/complex.h"

namespace sinkmesh {

/// A face of codimension 2, as the face of `simplex` that lacks the corners number `first` and `second`.
struct Ridge {
  Simplex simplex;
  int first;
  int second;
};

/// The simplices around a ridge, ghosts included, in cyclic order: the ridge's own simplex first, then the one
/// across the facet opposite its corner `first`, and so on; each shares a facet with the next, and the last
/// with the first. Their centers in this order are the corners of the dual Voronoi polygon (core/dual.h); the
/// polygon is unbounded iff there is a ghost. Linear in the result.
template <int Dim>
std::vector<Simplex> simplices_around(const Complex<Dim>& complex, const Ridge& ridge) {
  std::vector<Simplex> result;
  Simplex at = ridge.simplex;
  int exit = ridge.first;
  // Every simplex has two corners off the ridge: the one shared with the next simplex, and the one opposite it.
  Vertex shared = complex.corner(at, ridge.second);
  do {
    result.push_back(at);
    const HalfFacet entry = complex.mate(Complex<Dim>::half_facet(at, exit));
    at = Complex<Dim>::simplex_of(entry);
    exit = complex.index_of(at, shared);
    shared = complex.apex(entry);
  } while (at != ridge.simplex);
  return result;
}

}  // namespace sinkmesh
