// SPDX-License-Identifier: MIT
#include "core/vertex_remover.h"

#include <algorithm>
#include <numeric>

#include "core/first_simplex.h"
#include "core/location.h"

namespace sinkmesh {

template <int Dim>
bool VertexRemover<Dim>::plan(const Complex<Dim>& complex, const Predicates<Dim>& predicates, Vertex v) {
  collect_star(complex, v);
  collect_link(complex, v);
  if (!triangulate_link(complex, predicates) &&
      !(add_witness(complex, v) && triangulate_link(complex, predicates))) {
    return false;
  }
  find_prestar(predicates, complex.point(v));
  return true;
}

template <int Dim>
bool VertexRemover<Dim>::remove(Complex<Dim>& complex, const Predicates<Dim>& predicates, Vertex v) {
  if (!plan(complex, predicates, v)) return false;
  retriangulator_.replace(complex, star_, fresh_);
  complex.set_incident(v, Simplex());
  return true;
}

template <int Dim>
void VertexRemover<Dim>::collect_star(const Complex<Dim>& complex, Vertex v) {
  star_.clear();
  walk_(complex, v, [&](Simplex s) {
    star_.push_back(s);
    return false;
  });
}

template <int Dim>
void VertexRemover<Dim>::collect_link(const Complex<Dim>& complex, Vertex v) {
  link_.clear();
  for (const Simplex s : star_) {
    for (int i = 0; i <= Dim; ++i) {
      const Vertex u = complex.corner(s, i);
      if (u != v && !u.is_infinite()) link_.push_back(u);
    }
  }
  std::sort(link_.begin(), link_.end());
  link_.erase(std::unique(link_.begin(), link_.end()), link_.end());
}

// The link's vertices lie in one hyperplane, and v, the apex of a pyramid over it, on the hull. The base of a
// solid simplex of the star is in that plane; so the apex of a solid simplex beyond the base is not. If there
// is none, all vertices but v are in the plane.
template <int Dim>
bool VertexRemover<Dim>::add_witness(const Complex<Dim>& complex, Vertex v) {
  for (const Simplex s : star_) {
    if (complex.is_ghost(s)) continue;
    const HalfFacet base = Complex<Dim>::half_facet(s, complex.index_of(s, v));
    const Vertex beyond = complex.apex(complex.mate(base));
    if (beyond.is_infinite()) continue;
    link_.push_back(beyond);
    return true;
  }
  return false;
}

template <int Dim>
bool VertexRemover<Dim>::triangulate_link(const Complex<Dim>& complex, const Predicates<Dim>& predicates) {
  points_.clear();
  for (const Vertex u : link_) points_.push_back(complex.point(u));
  order_.resize(link_.size());
  std::iota(order_.begin(), order_.end(), 0);
  small_.clear();
  if (make_first_simplex<Dim>(small_, predicates, points_, order_) <= Dim) return false;
  Simplex hint(0);
  for (std::uint32_t i = Dim + 1; i < order_.size(); ++i) {
    const Point<Dim> p = small_.point(Vertex(i));
    cavity_.grow(small_, predicates, p, walk_to_conflict(small_, predicates, p, hint).simplex);
    linker_.substitute(small_, cavity_, Vertex(i));
    hint = cavity_.star(0);
  }
  return true;
}

template <int Dim>
void VertexRemover<Dim>::find_prestar(const Predicates<Dim>& predicates, const Point<Dim>& x) {
  const Simplex start = small_.incident_simplex(Vertex::infinite());
  cavity_.grow(small_, predicates, x, walk_to_conflict(small_, predicates, x, start).simplex);
  fresh_.resize(cavity_.num_simplices());
  for (std::size_t n = 0; n < fresh_.size(); ++n) {
    for (int i = 0; i <= Dim; ++i) {
      const Vertex u = small_.corner(cavity_.simplex(n), i);
      fresh_[n][static_cast<std::size_t>(i)] = u.is_infinite() ? u : link_[order_[u.index()]];
    }
  }
}

template class VertexRemover<2>;
template class VertexRemover<3>;

}  // namespace sinkmesh
