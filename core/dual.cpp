// SPDX-License-Identifier: MIT
#include "core/dual.h"

#include "predicates/circumcenter.h"
#include "predicates/constructions.h"

namespace sinkmesh {

template <int Dim>
Point<Dim> dual_vertex(const Triangulation<Dim>& triangulation, Simplex s) {
  const Corners<Dim> corners = triangulation.complex().corners(s);
  Point<Dim> center;
  if (!circumcenter(corners, center)) center = vector_to_circumcenter<Dim>(corners, Point<Dim>{});
  return triangulation.gate().out(center);
}

template <int Dim>
DualEdge<Dim> dual_edge(const Triangulation<Dim>& triangulation, HalfFacet h) {
  const Complex<Dim>& complex = triangulation.complex();
  if (complex.is_ghost(Complex<Dim>::simplex_of(h))) h = complex.mate(h);
  DualEdge<Dim> edge;
  edge.from = Complex<Dim>::simplex_of(h);
  edge.to = Complex<Dim>::simplex_of(complex.mate(h));
  edge.start = dual_vertex(triangulation, edge.from);
  edge.is_ray = complex.is_ghost(edge.to);
  if (edge.is_ray) {
    edge.end = {};
    edge.direction = facet_normal<Dim>(complex.facet_corners(h));
  } else {
    edge.end = dual_vertex(triangulation, edge.to);
  }
  return edge;
}

template Point2 dual_vertex<2>(const Triangulation<2>&, Simplex);
template Point3 dual_vertex<3>(const Triangulation<3>&, Simplex);
template DualEdge<2> dual_edge<2>(const Triangulation<2>&, HalfFacet);
template DualEdge<3> dual_edge<3>(const Triangulation<3>&, HalfFacet);

}  // namespace sinkmesh
