// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <vector>

#include "refine/refine.h"
#include "refine/watershed.h"
#include "tools/reproduce/detail/planar.h"
#include "tools/reproduce/figures.h"

namespace sinkmesh::reproduce {
namespace {

// Edges between triangles of the domain that belong to different sinks, and the domain's boundary: a triangle
// outside can flow into the domain, but is not part of the subcomplex.
std::vector<HalfFacet> bounding_edges(const Triangulation<2>& triangulation, const Domain<2>& domain,
                                      Flow<2>& flow) {
  const Complex<2>& complex = triangulation.complex();
  std::vector<HalfFacet> bounding = domain.boundary();
  for (const HalfFacet h : watershed_boundaries(complex, find_watersheds(flow))) {
    const HalfFacet mate = complex.mate(h);
    if (domain.is_inside(Complex<2>::simplex_of(h)) && domain.is_inside(Complex<2>::simplex_of(mate))) {
      bounding.push_back(h);
    }
  }
  return bounding;
}

}  // namespace

std::string figure_watersheds(const Surface2& usa) {
  SurfaceMesher2 mesher(usa);
  static_cast<void>(mesher.find_domain());
  const Triangulation<2>& triangulation = mesher.triangulation();
  Flow<2> flow(triangulation);
  const std::vector<Simplex> inside = mesher.domain().simplices();
  std::vector<Simplex> sinks;
  std::copy_if(inside.begin(), inside.end(), std::back_inserter(sinks),
               [&](Simplex s) { return flow.is_sink(s); });
  const std::vector<HalfFacet> bounding = bounding_edges(triangulation, mesher.domain(), flow);

  SvgCanvas canvas("figure-2", 1000, 690, "Sinks and their ancestor sets",
                   "The stable subcomplex of the USA data set: " + std::to_string(inside.size()) +
                       " triangles, " + std::to_string(sinks.size()) +
                       " of which contain their own circumcenter; " + std::to_string(bounding.size()) +
                       " edges bound the ancestor sets of the sinks.");
  canvas.rule(".thin", "stroke-width:.8;stroke:var(--c-muted)");
  canvas.rule(".bold", "stroke-width:2.2");
  const Frame frame(detail::bounding_box(usa.points), {{12, 12}, {988, 640}});
  canvas.polygons(detail::place(frame, detail::triangles(triangulation, sinks)), "fill-2");
  const std::vector<HalfFacet> all = detail::edges_of(triangulation.complex(), inside);
  canvas.segments(detail::place(frame, detail::edges(triangulation, all)), "thin");
  canvas.segments(detail::place(frame, detail::edges(triangulation, bounding)), "bold");
  for (const Simplex s : sinks) {
    canvas.circle(frame(detail::delaunay_ball(triangulation, s).center), 3.6, "mark");
  }

  using Kind = LegendEntry::Kind;
  const std::vector<LegendEntry> legend = {
      {Kind::area, "fill-2", std::to_string(sinks.size()) + " sink triangles"},
      {Kind::dot, "mark", "their circumcenters, the sinks"},
      {Kind::line, "bold", "bounds of ancestor sets"}};
  draw_legend(canvas, {14, 676}, legend);
  return canvas.take();
}

}  // namespace sinkmesh::reproduce
