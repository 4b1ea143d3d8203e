// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "core/dual.h"
#include "refine/flow.h"
#include "refine/quality.h"
#include "tools/reproduce/detail/planar.h"

#include <fmt/format.h>
#include "tools/reproduce/figures.h"

namespace sinkmesh::reproduce {
namespace {

Point2 middle(const Segment& s) { return {(s.first[0] + s.second[0]) / 2, (s.first[1] + s.second[1]) / 2}; }

// The half-edges across which triangles flow.
std::vector<HalfFacet> find_crossings(Flow<2>& flow, const std::vector<Simplex>& solid) {
  std::vector<HalfFacet> crossings;
  for (const Simplex s : solid) {
    for (int i = 0; i < 3; ++i) {
      const HalfFacet h = Complex<2>::half_facet(s, i);
      if (flow.crosses(h)) crossings.push_back(h);
    }
  }
  return crossings;
}

// The crossing that shows best what the relation is: into a sink, from a triangle that is not flat and whose
// center is far beyond the edge.
HalfFacet clearest(const Triangulation<2>& triangulation, Flow<2>& flow,
                   const std::vector<HalfFacet>& crossings) {
  const Complex<2>& complex = triangulation.complex();
  HalfFacet best = crossings.front();
  double best_score = -1;
  for (const HalfFacet h : crossings) {
    const Simplex from = Complex<2>::simplex_of(h);
    const Simplex to = Complex<2>::simplex_of(complex.mate(h));
    if (!flow.is_sink(to)) continue;
    const Segment shared = detail::edge(triangulation, h);
    const Point2 center = detail::delaunay_ball(triangulation, from).center;
    const Point2 next = detail::delaunay_ball(triangulation, to).center;
    const double beyond = std::sqrt(detail::distance2(center, middle(shared)));
    const double apart = std::sqrt(detail::distance2(center, next));
    const double length = std::sqrt(detail::distance2(shared.first, shared.second));
    const double score = std::min({beyond / length, apart / length, angles<2>(complex.corners(from)).min / 90,
                                   angles<2>(complex.corners(to)).min / 90});
    if (score > best_score) {
      best = h;
      best_score = score;
    }
  }
  return best;
}

// A line through the middle of a segment and at a right angle to it: the bisector of its ends.
Segment bisector(const Segment& s, double half_length) {
  const Point2 m = middle(s);
  const Point2 d = {s.second[1] - s.first[1], s.first[0] - s.second[0]};
  const double scale = half_length / std::hypot(d[0], d[1]);
  return {{m[0] - scale * d[0], m[1] - scale * d[1]}, {m[0] + scale * d[0], m[1] + scale * d[1]}};
}

std::string name(const std::string& letter, const std::string& index = {}) {
  std::string text = "<tspan class=\"it\">" + letter + "</tspan>";
  if (!index.empty()) text += "<tspan class=\"it index\" dy=\"6\">" + index + "</tspan>";
  return text;
}

// Two triangles, their circumcenters, and the bisector of their common edge, on which both lie.
void draw_pair(SvgCanvas& canvas, const Triangulation<2>& triangulation, HalfFacet h, const Box<2>& picture) {
  const Complex<2>& complex = triangulation.complex();
  const Simplex from = Complex<2>::simplex_of(h);
  const Simplex to = Complex<2>::simplex_of(complex.mate(h));
  const detail::Ball ball = detail::delaunay_ball(triangulation, from);
  const double radius = std::sqrt(ball.radius2);
  Box<2> world = detail::bounding_box(detail::triangle(triangulation, to));
  world.include({ball.center[0] - radius, ball.center[1] - radius});
  world.include({ball.center[0] + radius, ball.center[1] + radius});
  const Frame frame(world, picture);

  canvas.polygon(detail::place(frame, detail::triangle(triangulation, to)), "fill-2");
  canvas.polygon(detail::place(frame, detail::triangle(triangulation, from)), "fill-1");
  canvas.ellipses(detail::place_balls(frame, triangulation, std::span<const Simplex>(&from, 1)), "dashed");
  const std::array<Simplex, 2> both = {from, to};
  canvas.segments(detail::place(frame, detail::edges(triangulation, detail::edges_of(complex, both))), "bold");
  const Segment shared = detail::edge(triangulation, h);
  const Segment line = bisector({frame(shared.first), frame(shared.second)}, 1000);
  const std::vector<std::vector<Point2>> window = {
      {picture.low, {picture.high[0], picture.low[1]}, picture.high, {picture.low[0], picture.high[1]}}};
  canvas.begin_clip(canvas.define_clip(window));
  canvas.segments({&line, 1}, "dashed");
  canvas.end_clip();

  const DualEdge<2> dual = dual_edge(triangulation, h);
  const Point2 z_from = frame(dual.start);
  const Point2 z_to = frame(dual.end);
  const Segment voronoi = {z_from, z_to};
  canvas.segments({&voronoi, 1}, "voronoi");

  // The arrow runs beside the bisector, names are on the other side of it, or of the arrow.
  const Point2 inner = frame(detail::incircle(detail::triangle(triangulation, from)).center);
  const double length = std::hypot(z_to[0] - z_from[0], z_to[1] - z_from[1]);
  const Point2 along = {(z_to[0] - z_from[0]) / length, (z_to[1] - z_from[1]) / length};
  const double side = along[0] * (inner[1] - z_from[1]) - along[1] * (inner[0] - z_from[0]) > 0 ? -1 : 1;
  const Point2 beside = {-side * along[1], side * along[0]};
  const Anchor anchor = beside[0] < 0 ? Anchor::end : Anchor::start;
  constexpr double kReach = 105;
  const Point2 start = {inner[0] - 16 * beside[0], inner[1] - 16 * beside[1]};
  canvas.arrow(start, {start[0] + kReach * along[0], start[1] + kReach * along[1]}, 16, "flow");

  for (const Simplex s : both) {
    for (const Point2& p : detail::triangle(triangulation, s)) canvas.circle(frame(p), 5, "dot");
  }
  canvas.circle(z_from, 6, "mark");
  canvas.circle(z_to, 6, "mark");
  for (const auto& [z, index] : {std::pair(z_from, "τ"), std::pair(z_to, "σ")}) {
    canvas.text({z[0] + 14 * beside[0], z[1] + 14 * beside[1] + 7}, name("z", index), "text name", anchor);
  }
  canvas.text({inner[0] + 10 * beside[0], inner[1] + 10 * beside[1] + 7}, name("τ"), "text name",
              Anchor::middle);
  // Towards the corner that the triangles do not share.
  const Point2 m = middle({frame(shared.first), frame(shared.second)});
  const Point2 apex = frame(triangulation.point(complex.apex(complex.mate(h))));
  canvas.text({0.4 * m[0] + 0.6 * apex[0], 0.4 * m[1] + 0.6 * apex[1] + 8}, name("σ"), "text name",
              Anchor::middle);
}

// The whole relation: an arrow for every pair, across the middle of the common edge.
void draw_relation(SvgCanvas& canvas, const Triangulation<2>& triangulation, Flow<2>& flow,
                   const std::vector<Simplex>& solid, const std::vector<HalfFacet>& crossings, HalfFacet pair,
                   const Box<2>& picture) {
  const Complex<2>& complex = triangulation.complex();
  std::vector<Point2> points;
  for (const Simplex s : solid) {
    for (const Point2& p : detail::triangle(triangulation, s)) points.push_back(p);
  }
  const Frame frame(detail::bounding_box(points), picture);
  std::vector<Simplex> sinks;
  std::copy_if(solid.begin(), solid.end(), std::back_inserter(sinks),
               [&](Simplex s) { return flow.is_sink(s); });
  canvas.polygons(detail::place(frame, detail::triangles(triangulation, sinks)), "fill-2");
  canvas.segments(detail::place(frame, detail::edges(triangulation, detail::edges_of(complex, solid))), "thin");
  const std::array<Simplex, 2> both = {Complex<2>::simplex_of(pair),
                                       Complex<2>::simplex_of(complex.mate(pair))};
  canvas.segments(detail::place(frame, detail::edges(triangulation, detail::edges_of(complex, both))), "bold");
  for (const Simplex s : sinks) {
    canvas.circle(frame(detail::delaunay_ball(triangulation, s).center), 4.5, "mark");
  }
  for (const HalfFacet h : crossings) {
    const auto [p, q] = detail::edge(triangulation, h);
    const detail::Ball circle = detail::incircle(detail::triangle(triangulation, Complex<2>::simplex_of(h)));
    const double half = std::clamp(0.8 * frame.scale() * std::sqrt(circle.radius2), 8.0, 13.0);
    // Half-edges are counterclockwise seen from outside, that is, outside is on their left.
    const Segment across = bisector({frame(q), frame(p)}, half);
    canvas.arrow(across.first, across.second, 9, "flow");
  }
  for (const Point2& p : points) canvas.circle(frame(p), 3.5, "dot");
}

}  // namespace

std::string figure_flow_relation() {
  const Triangulation<2> triangulation(detail::sample_points());
  Flow<2> flow(triangulation);
  const std::vector<Simplex> solid = detail::solid_triangles(triangulation.complex());
  const std::vector<HalfFacet> crossings = find_crossings(flow, solid);
  const HalfFacet pair = clearest(triangulation, flow, crossings);

  SvgCanvas canvas(
      "figure-4", 1000, 510, "The flow relation",
      "Left: triangle tau precedes triangle sigma, because they share an edge and the circumcenter "
      "of tau lies on sigma's side of it; both centers lie on the bisector of the edge. Right: the "
      "triangulation these two are from, with its " +
          std::to_string(crossings.size()) +
          " pairs as arrows; arrows out of the hull lead to omega. Triangles without successor, the "
          "sinks, are shaded.");
  canvas.rule(".name", "font-size:26px");
  canvas.rule(".voronoi", "fill:none;stroke:var(--c-ink);stroke-width:2");
  canvas.rule(".index", "font-size:19px");
  draw_pair(canvas, triangulation, pair, {{14, 14}, {460, 450}});
  draw_relation(canvas, triangulation, flow, solid, crossings, pair, {{510, 24}, {980, 450}});
  canvas.text({237, 494},
              name("τ ≺ σ") + ": the circumcenter of " + name("τ") + " is on " + name("σ") + "’s side", "text",
              Anchor::middle);
  canvas.text({745, 494}, fmt::format("all {} pairs; shaded: sinks", crossings.size()), "text", Anchor::middle);
  return canvas.take();
}

}  // namespace sinkmesh::reproduce
