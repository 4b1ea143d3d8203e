// SPDX-License-Identifier: MIT
#include "refine/refine.h"

#include <algorithm>
#include <string>

#include "core/mix.h"
#include "refine/refiner.h"
#include "refine/surface_check.h"

namespace sinkmesh {
namespace {

// The points that facets use, without gaps. Unused points of a surface must not become vertices of the mesh.
template <int Dim>
struct UsedPoints {
  std::vector<Point<Dim>> points;
  std::vector<std::uint32_t> input_id;  // of each
  std::vector<std::array<Vertex, Dim>> facets;

  explicit UsedPoints(const Surface<Dim>& surface) {
    std::vector<std::uint32_t> new_id(surface.points.size(), 0);
    for (const auto& facet : surface.facets) {
      for (const std::uint32_t p : facet) new_id[p] = 1;
    }
    for (std::uint32_t p = 0; p < new_id.size(); ++p) {
      if (new_id[p] == 0) continue;
      new_id[p] = static_cast<std::uint32_t>(points.size());
      points.push_back(surface.points[p]);
      input_id.push_back(p);
    }
    facets.reserve(surface.facets.size());
    for (const auto& facet : surface.facets) {
      std::array<Vertex, Dim> corners;
      for (std::size_t k = 0; k < Dim; ++k) corners[k] = Vertex(new_id[facet[k]]);
      facets.push_back(corners);
    }
  }
};

template <int Dim>
std::array<std::uint32_t, Dim + 1> corner_ids(const Complex<Dim>& complex, Simplex s) {
  std::array<std::uint32_t, Dim + 1> ids;
  for (int i = 0; i <= Dim; ++i) ids[static_cast<std::size_t>(i)] = complex.corner(s, i).index();
  return ids;
}

template <int Dim>
std::array<std::uint32_t, Dim> facet_ids(const Complex<Dim>& complex, HalfFacet h) {
  std::array<std::uint32_t, Dim> ids;
  const std::array<Vertex, Dim> vertices = complex.facet(h);
  for (std::size_t k = 0; k < Dim; ++k) ids[k] = vertices[k].index();
  return ids;
}

std::string count_of(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

}  // namespace

template <int Dim>
struct SurfaceMesher<Dim>::State {
  explicit State(const Surface<Dim>& surface)
      : surface_points(surface.points),
        seeds(surface.seeds),
        used(surface),
        triangulation(used.points),
        domain(triangulation),
        flow(triangulation) {}

  std::vector<Point<Dim>> surface_points;
  Seeds<Dim> seeds;
  UsedPoints<Dim> used;
  Triangulation<Dim> triangulation;
  Domain<Dim> domain;
  Flow<Dim> flow;
};

template <int Dim>
SurfaceMesher<Dim>::SurfaceMesher(const Surface<Dim>& surface) {
  if (surface.facets.empty()) throw InputError("the surface has no facet: it bounds nothing");
  state_ = std::make_unique<State>(surface);
}
template <int Dim>
SurfaceMesher<Dim>::SurfaceMesher(SurfaceMesher&&) noexcept = default;
template <int Dim>
SurfaceMesher<Dim>& SurfaceMesher<Dim>::operator=(SurfaceMesher&&) noexcept = default;
template <int Dim>
SurfaceMesher<Dim>::~SurfaceMesher() = default;

template <int Dim>
BoundaryResult SurfaceMesher<Dim>::find_domain(const RefineOptions& options) {
  require_valid(options);
  const std::vector<std::size_t> missing = state_->domain.label_facets(state_->used.facets, state_->seeds);
  if (!missing.empty()) {
    throw InputError(
        std::to_string(missing.size()) + " of " + count_of(state_->used.facets.size(), "facet", "facets") +
        " of the surface are not in the Delaunay triangulation of its vertices (the first is facet " +
        std::to_string(missing.front()) +
        "): divide them into smaller ones; where four vertices are on a circle, as on grids, take the other "
        "diagonal; and repair self-intersections, which show like this, too");
  }
  const typename Domain<Dim>::Peeled peeled = state_->domain.peel(state_->flow);
  if (state_->domain.simplices().empty()) {
    throw InputError("nothing stable is inside the surface: the flow leads out of it from everywhere (" +
                     std::to_string(peeled.simplices) + " of " +
                     count_of(peeled.simplices, "simplex", "simplices") +
                     "); divide its facets into smaller ones");
  }
  BoundaryResult result;
  result.regions = 1;
  result.peeled_simplices = peeled.simplices;
  result.peeled_facets = peeled.facets;
  return result;
}

template <int Dim>
RefineResult SurfaceMesher<Dim>::refine(const RefineOptions& options) {
  return Refiner<Dim>(state_->triangulation, state_->domain, state_->flow, options).run();
}

template <int Dim>
std::vector<Leftover<Dim>> SurfaceMesher<Dim>::leftovers() const {
  return {};
}

template <int Dim>
QualityStatistics SurfaceMesher<Dim>::statistics(double max_ratio) const {
  QualityStatistics statistics(max_ratio);
  for (const Simplex s : state_->domain.simplices()) {
    statistics.add<Dim>(state_->triangulation.complex().corners(s));
  }
  return statistics;
}

template <int Dim>
std::size_t SurfaceMesher<Dim>::num_vertices() const {
  const Complex<Dim>& complex = state_->triangulation.complex();
  std::vector<bool> used(complex.num_vertices(), false);
  for (const Simplex s : state_->domain.simplices()) {
    for (const std::uint32_t v : corner_ids<Dim>(complex, s)) used[v] = true;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

template <int Dim>
std::uint64_t SurfaceMesher<Dim>::hash() const {
  const Complex<Dim>& complex = state_->triangulation.complex();
  std::vector<Point<Dim>> points(complex.num_vertices());
  for (std::uint32_t v = 0; v < points.size(); ++v) points[v] = state_->triangulation.point(Vertex(v));
  SimplexSetHash<Dim> hash(points);
  for (const Simplex s : state_->domain.simplices()) hash.add(corner_ids<Dim>(complex, s));
  return hash.value();
}

template <int Dim>
Mesh<Dim> SurfaceMesher<Dim>::mesh() const {
  const Complex<Dim>& complex = state_->triangulation.complex();
  // Ids of the complex to ids of the mesh: input points keep theirs, Steiner points follow all of them.
  std::vector<std::uint32_t> id = state_->used.input_id;
  Mesh<Dim> mesh;
  mesh.points = state_->surface_points;
  for (auto v = static_cast<std::uint32_t>(id.size()); v < complex.num_vertices(); ++v) {
    id.push_back(static_cast<std::uint32_t>(mesh.points.size()));
    mesh.points.push_back(state_->triangulation.point(Vertex(v)));
  }
  for (const Simplex s : state_->domain.simplices()) {
    auto simplex = corner_ids<Dim>(complex, s);
    for (std::uint32_t& v : simplex) v = id[v];
    mesh.simplices.push_back(simplex);
  }
  for (const HalfFacet h : state_->domain.boundary()) {
    auto facet = facet_ids<Dim>(complex, h);
    for (std::uint32_t& v : facet) v = id[v];
    mesh.boundary.push_back(facet);
  }
  return mesh;
}

template <int Dim>
const Triangulation<Dim>& SurfaceMesher<Dim>::triangulation() const {
  return state_->triangulation;
}
template <int Dim>
const Domain<Dim>& SurfaceMesher<Dim>::domain() const {
  return state_->domain;
}
template <int Dim>
std::size_t SurfaceMesher<Dim>::bytes() const {
  return state_->triangulation.complex().bytes();
}

template <int Dim>
Mesh<Dim> hull_mesh(const Triangulation<Dim>& triangulation) {
  const Complex<Dim>& complex = triangulation.complex();
  Mesh<Dim> mesh;
  for (std::uint32_t v = 0; v < complex.num_vertices(); ++v)
    mesh.points.push_back(triangulation.point(Vertex(v)));
  for (const Simplex s : complex.simplices()) {
    if (complex.is_ghost(s)) {
      mesh.boundary.push_back(facet_ids<Dim>(complex, complex.mate(Complex<Dim>::half_facet(s, Dim))));
    } else {
      mesh.simplices.push_back(corner_ids<Dim>(complex, s));
    }
  }
  return mesh;
}

template <int Dim>
Mesh<Dim> refine(const Surface<Dim>& surface, const RefineOptions& options) {
  require_valid(options);
  for (const SurfaceDefect& defect : check_surface(surface)) {
    if (severity(defect.kind) == SurfaceSeverity::error) {
      throw InputError(defect.message + ": " + std::string(advice(defect.kind)));
    }
  }
  SurfaceMesher<Dim> mesher(surface);
  mesher.find_domain();
  mesher.refine(options);
  return mesher.mesh();
}

template class SurfaceMesher<2>;
template class SurfaceMesher<3>;
template Mesh<2> hull_mesh(const Triangulation<2>&);
template Mesh<3> hull_mesh(const Triangulation<3>&);
template Mesh<2> refine(const Surface<2>&, const RefineOptions&);
template Mesh<3> refine(const Surface<3>&, const RefineOptions&);

}  // namespace sinkmesh
