// SPDX-License-Identifier: MIT
#include "tools/program/surface_fit.h"

#include "core/triangulation.h"
#include "refine/domain.h"
#include "refine/flow.h"
#include "refine/used_points.h"

namespace sinkmesh::program {

template <int Dim>
SurfaceFit fit(const Surface<Dim>& surface, double max_ratio) {
  const UsedPoints<Dim> used(surface);
  SurfaceFit result(max_ratio);
  result.vertices = used.points.size();
  const Triangulation<Dim> triangulation(used.points);
  if constexpr (Dim == 3) {
    result.too_sharp = sharpest_fold(triangulation.complex(), used.facets);
    if (result.too_sharp && !result.too_sharp->is_too_sharp()) result.too_sharp.reset();
  }
  Domain<Dim> domain(triangulation);
  result.missing = domain.label_facets(used.facets, surface.seeds);
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
