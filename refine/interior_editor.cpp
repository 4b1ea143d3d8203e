// SPDX-License-Identifier: MIT
#include "refine/interior_editor.h"

#include <algorithm>

#include "core/location.h"
#include "predicates/circumcenter.h"
#include "refine/quality.h"

namespace sinkmesh {

template <int Dim>
InteriorEditor<Dim>::InteriorEditor(Triangulation<Dim>& triangulation, Domain<Dim>& domain, Flow<Dim>& flow,
                                    Boundary<Dim>* boundary, std::uint32_t num_given)
    : triangulation_(&triangulation),
      domain_(&domain),
      flow_(&flow),
      boundary_(boundary),
      num_given_(num_given) {
  for (const Simplex s : complex().simplices()) {
    if (!domain.is_inside(s)) continue;
    separation2_ = std::min(separation2_, shape<Dim>(complex().corners(s)).shortest2);
  }
}

template <int Dim>
const std::vector<Simplex>& InteriorEditor<Dim>::star(Vertex v) {
  star_.clear();
  star_walk_(complex(), v, [this](Simplex s) {
    star_.push_back(s);
    return false;
  });
  return star_;
}

template <int Dim>
bool InteriorEditor<Dim>::is_movable(Vertex v) {
  if (v.is_infinite() || v.index() < num_given_ || complex().incident_simplex(v).is_null()) return false;
  return !star_walk_(complex(), v, [&](Simplex s) {
    if (!domain_->is_inside(s)) return true;
    for (int i = 0; i <= Dim; ++i) {
      if (complex().corner(s, i) != v && domain_->is_wall(Complex<Dim>::half_facet(s, i))) return true;
    }
    return false;
  });
}

template <int Dim>
const std::vector<Simplex>& InteriorEditor<Dim>::remove(Vertex v) {
  const Region region = domain_->region(complex().incident_simplex(v));
  const std::vector<Simplex>& fresh = triangulation_->remove(v);
  domain_->fill(fresh, region, [this](HalfFacet outer) {
    if (boundary_ != nullptr) boundary_->refresh(outer);
  });
  for (const Simplex s : fresh) flow_->forget(s);
  return fresh;
}

// The simplex of the region of `near` that holds x, or null. On a wall it is one of the two.
template <int Dim>
Simplex InteriorEditor<Dim>::locate(const Point<Dim>& x, Simplex near) {
  const Location<Dim> at = triangulation_->locate(x, near);
  return at.is_at_corner() || domain_->region(at.simplex) != domain_->region(near) ? Simplex() : at.simplex;
}

template <int Dim>
bool InteriorEditor<Dim>::has_center_inside(const Corners<Dim>& corners, Simplex near) {
  Point<Dim> center;
  if (!circumcenter(corners, center)) return false;
  triangulation_->announce(center);
  const Location<Dim> at = triangulation_->locate(center, near);
  if (domain_->region(at.simplex) == domain_->region(near)) return true;
  // On a wall it is inside, from whichever side the walk came.
  for (int i = 0; i <= Dim; ++i) {
    const HalfFacet h = Complex<Dim>::half_facet(at.simplex, i);
    const Simplex beyond = complex().neighbor(at.simplex, i);
    if (at.support() != 0 && at.sign[static_cast<std::size_t>(i)] == 0 && domain_->is_wall(h) &&
        domain_->region(beyond) == domain_->region(near)) {
      return true;
    }
  }
  return false;
}

template <int Dim>
Vertex InteriorEditor<Dim>::insert(const Point<Dim>& x, Simplex near, Vertex v) {
  const Simplex start = locate(x, near);
  SINKMESH_ASSERT(!start.is_null());
  triangulation_->grow_prestar(cavity_, x, start);
  const Region region = domain_->region(start);
  if (v.is_null()) {
    v = triangulation_->substitute_star(cavity_, x);
  } else {
    triangulation_->substitute_star(cavity_, x, v);
  }
  domain_->inherit(cavity_, region);
  for (std::size_t i = 0; i < cavity_.num_facets(); ++i) {
    flow_->forget(cavity_.star(i));
    const HalfFacet outer(cavity_.facet(i).outer);
    if (boundary_ != nullptr && domain_->is_wall(outer)) boundary_->refresh(outer);
  }
  return v;
}

template class InteriorEditor<2>;
template class InteriorEditor<3>;

}  // namespace sinkmesh
