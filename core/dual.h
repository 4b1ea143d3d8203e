// SPDX-License-Identifier: MIT
//
// The Voronoi diagram, read off the Delaunay triangulation [EG01, 2.2, 2.3].
#pragma once

#include <vector>

#include "core/around.h"
#include "core/star.h"
#include "core/triangulation.h"

namespace sinkmesh {

// A face of dimension k is dual to a Voronoi polyhedron of dimension Dim-k, whose corners are dual to the solid
// simplices of the star of the face:
//
//   simplex  vertex    dual_vertex(triangulation, s)
//   facet    edge      dual_edge(triangulation, h)
//   ridge    polygon   simplices_around(complex, ridge): its corners, in cyclic order
//   any      polytope  star(complex, face, start):       its corners, in no order
//
// It is unbounded iff there is a ghost among them, which stands for the direction of the dual ray of its hull
// facet. In degenerate sets several simplices have the same center: edges of length 0 are among the dual edges,
// and the Voronoi diagram is what remains when they are contracted.

/// The circumcenter of a solid simplex, in the units of the input. Within [-2,2]^Dim of the gate (in the plane
/// and in space everything but the centers of flat simplices near the hull) the exact one rounded once, to
/// nearest even, to a double on the gate's grid; otherwise wrong by less than one unit in the last place;
/// infinite where that is no double.
template <int Dim>
Point<Dim> dual_vertex(const Triangulation<Dim>& triangulation, Simplex s);

/// A segment between two Voronoi vertices, or a ray.
template <int Dim>
struct DualEdge {
  Point<Dim> start;        ///< the center of `from`
  Point<Dim> end;          ///< the center of `to`; not set for a ray
  Point<Dim> direction{};  ///< of a ray: the outer normal of the hull facet, in no unit; not set for a segment
  Simplex from;            ///< solid
  Simplex to;              ///< a ghost for a ray

  bool is_ray = false;
};

/// The edge dual to a facet that does not hold the vertex at infinity. It starts at the simplex of h, if that
/// is solid; a hull facet gives the same ray from either side. Coordinates of a direction are wrong by less
/// than 2^-52 of themselves, their signs are exact.
///
/// A segment need not meet its facet; the simplex of h flows across h iff the start of the edge lies beyond it.
template <int Dim>
DualEdge<Dim> dual_edge(const Triangulation<Dim>& triangulation, HalfFacet h);

}  // namespace sinkmesh
