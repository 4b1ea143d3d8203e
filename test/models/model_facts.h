// SPDX-License-Identifier: MIT
//
// What the tests of the models measure.
#pragma once

#include <cmath>
#include <vector>

#include "core/triangulation.h"
#include "predicates/circumcenter.h"
#include "refine/domain.h"
#include "refine/flow.h"
#include "refine/quality.h"
#include "refine/surface.h"
#include "refine/surface_check.h"

namespace sinkmesh::test {

struct Ratios {
  double min;
  double average;
  double max;
};

template <int Dim>
struct ModelFacts {
  std::vector<SurfaceDefect> defects;  // notes included
  SurfaceSummary summary;
  Ratios surface{};  // r/l of the facets
  /// Of the Delaunay triangulation of the points; if facets are missing, the rest is unknown.
  std::size_t missing_facets = 0;
  std::size_t interior_points = 0;
  std::size_t peeled = 0;                 ///< simplices from which the flow leads out
  std::size_t circumcenters_outside = 0;  ///< of simplices inside
  QualityStatistics quality{Dim == 2 ? 1.0 : 2.0};
};

template <int Dim>
Ratios facet_ratios(const Surface<Dim>& surface) {
  Ratios ratios{HUGE_VAL, 0, 0};
  for (const auto& facet : surface.facets) {
    FacetCorners<Dim> corners;
    for (std::size_t k = 0; k < Dim; ++k) corners[k] = &surface.points[facet[k]];
    const double ratio = std::sqrt(facet_shape<Dim>(corners).ratio2());
    ratios.min = std::min(ratios.min, ratio);
    ratios.max = std::max(ratios.max, ratio);
    ratios.average += ratio / static_cast<double>(surface.facets.size());
  }
  return ratios;
}

template <int Dim>
ModelFacts<Dim> facts_of(const Surface<Dim>& surface) {
  ModelFacts<Dim> facts;
  facts.defects = check_surface(surface);
  facts.summary = summarize_surface(surface);
  facts.surface = facet_ratios(surface);
  facts.interior_points = surface.points.size() - facts.summary.vertices;

  const Triangulation<Dim> triangulation(surface.points);
  Domain<Dim> domain(triangulation);
  std::vector<typename Domain<Dim>::Facet> facets;
  for (const auto& facet : surface.facets) {
    for (std::size_t k = 0; auto& vertex : facets.emplace_back()) vertex = Vertex(facet[k++]);
  }
  facts.missing_facets = domain.label_facets(facets).size();
  if (facts.missing_facets != 0) return facts;
  for (const Simplex s : domain.simplices()) {
    facts.quality.template add<Dim>(triangulation.complex().corners(s));
    Point<Dim> center;
    if (!circumcenter(triangulation.complex().corners(s), center) ||
        !domain.is_inside(triangulation.locate(center, s).simplex)) {
      ++facts.circumcenters_outside;
    }
  }
  Flow<Dim> flow(triangulation);
  facts.peeled = domain.peel(flow).simplices;
  return facts;
}

}  // namespace sinkmesh::test
