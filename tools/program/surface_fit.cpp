// SPDX-License-Identifier: MIT
#include "tools/program/surface_fit.h"

#include "core/triangulation.h"
#include "refine/domain.h"
#include "refine/flow.h"

namespace sinkmesh::program {

template <int Dim>
SurfaceFit fit(const Surface<Dim>& surface, double max_ratio) {
  constexpr std::uint32_t kUnused = ~std::uint32_t{0};
  std::vector<std::uint32_t> number(surface.points.size(), kUnused);
  std::vector<Point<Dim>> points;
  std::vector<typename Domain<Dim>::Facet> facets;
  for (const auto& facet : surface.facets) {
    typename Domain<Dim>::Facet& vertices = facets.emplace_back();
    for (std::size_t k = 0; k < Dim; ++k) {
      std::uint32_t& n = number[facet[k]];
      if (n == kUnused) {
        n = static_cast<std::uint32_t>(points.size());
        points.push_back(surface.points[facet[k]]);
      }
      vertices[k] = Vertex(n);
    }
  }

  SurfaceFit result(max_ratio);
  result.vertices = points.size();
  const Triangulation<Dim> triangulation(points);
  Domain<Dim> domain(triangulation);
  result.missing = domain.label_facets(facets, surface.seeds);
  if (!result.missing.empty()) return result;
  Flow<Dim> flow(triangulation);
  for (const HalfFacet h : domain.boundary()) result.unstable += flow.crosses(h) ? 1 : 0;
  for (const Simplex s : domain.simplices()) {
    result.quality.template add<Dim>(triangulation.complex().corners(s));
  }
  const auto peeled = domain.peel(flow);
  result.peeled_simplices = peeled.simplices;
  result.peeled_facets = peeled.facets;
  return result;
}

template SurfaceFit fit(const Surface<2>&, double);
template SurfaceFit fit(const Surface<3>&, double);

}  // namespace sinkmesh::program
