// SPDX-License-Identifier: MIT
//
// Both functions are minima of functions |y-z|^2 - r^2, so the points with values up to t are a union of discs
// of square radius r^2 + t. Each level set is drawn as that union: exact, nothing is sampled.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/dual.h"
#include "refine/flow.h"
#include "tools/reproduce/detail/planar.h"

#include <fmt/format.h>
#include "tools/reproduce/figures.h"

namespace sinkmesh::reproduce {
namespace {

constexpr int kLevels = 12;

// Lighter as the values grow: the highest level, which covers `region`, first.
void draw_level_sets(SvgCanvas& canvas, const Frame& frame, const std::vector<detail::Ball>& balls, double low,
                     double high, const std::vector<std::vector<Point2>>& region) {
  canvas.polygons(region, fmt::format("l{}", kLevels - 1));
  for (int k = kLevels - 1; k > 0; --k) {
    const double level = low + (high - low) * k / kLevels;
    std::vector<Ellipse> discs;
    for (const detail::Ball& ball : balls) {
      const double radius = frame.scale() * std::sqrt(std::max(0.0, ball.radius2 + level));
      if (radius > 0) discs.push_back({frame(ball.center), radius, radius});
    }
    canvas.ellipses(discs, fmt::format("l{}", k - 1));
  }
}

std::vector<Segment> voronoi_edges(const Triangulation<2>& triangulation, double length_of_rays) {
  std::vector<Segment> result;
  const Complex<2>& complex = triangulation.complex();
  for (const HalfFacet h : detail::edges_of(complex, detail::solid_triangles(complex))) {
    DualEdge<2> dual = dual_edge(triangulation, h);
    if (dual.is_ray) {
      const double scale = length_of_rays / std::hypot(dual.direction[0], dual.direction[1]);
      for (std::size_t k = 0; k < 2; ++k) dual.end[k] = dual.start[k] + scale * dual.direction[k];
    }
    result.emplace_back(dual.start, dual.end);
  }
  return result;
}

}  // namespace

std::string figure_level_sets() {
  const std::vector<Point2> points = detail::sample_points();
  const Triangulation<2> triangulation(points);
  const Complex<2>& complex = triangulation.complex();
  const std::vector<Simplex> solid = detail::solid_triangles(complex);

  std::vector<detail::Ball> sites;
  for (const Point2& p : points) sites.push_back({p, 0});
  std::vector<detail::Ball> balls;
  for (const Simplex s : solid) balls.push_back(detail::delaunay_ball(triangulation, s));
  // Both functions have the same extremes, 0 and the values at the sinks.
  Flow<2> flow(triangulation);
  double largest = 0;
  const std::vector<Simplex> sinks = flow.sinks();
  for (const Simplex s : sinks) largest = std::max(largest, detail::delaunay_ball(triangulation, s).radius2);

  SvgCanvas canvas(
      "figure-1", 1000, 550, "Level sets of the two square distance functions",
      "Left: level sets of pi, the square distance to the nearest of " + std::to_string(points.size()) +
          " points, under their Voronoi diagram. Right: level sets of phi, the smallest weighted "
          "square distance to a Delaunay sphere, under their Delaunay triangulation. Shades get "
          "lighter as the values grow. Both functions have their extremes at the points and at the " +
          std::to_string(sinks.size()) + " sinks.");
  canvas.use_ramp(kLevels);
  const Box<2> world = detail::bounding_box(points);
  const auto draw_extremes = [&](const Frame& frame) {
    for (const Simplex s : sinks) {
      canvas.circle(frame(detail::delaunay_ball(triangulation, s).center), 4, "mark");
    }
    for (const Point2& p : points) canvas.circle(frame(p), 4.5, "dot");
  };

  const Frame left(world, {{24, 24}, {476, 436}});
  const std::vector<std::vector<Point2>> window = {{{10, 10}, {490, 10}, {490, 450}, {10, 450}}};
  canvas.begin_clip(canvas.define_clip(window));
  draw_level_sets(canvas, left, sites, 0, largest, window);
  canvas.segments(detail::place(left, voronoi_edges(triangulation, 4)), "thin");
  canvas.end_clip();
  draw_extremes(left);

  const Frame right(world, {{524, 24}, {976, 436}});
  const std::vector<std::vector<Point2>> hull =
      detail::place(right, detail::outline(triangulation, boundary(complex, std::span<const Simplex>(solid))));
  canvas.begin_clip(canvas.define_clip(hull));
  draw_level_sets(canvas, right, balls, -largest, 0, hull);
  canvas.end_clip();
  canvas.segments(detail::place(right, detail::edges(triangulation, detail::edges_of(complex, solid))), "thin");
  draw_extremes(right);

  canvas.text({12, 485}, "<tspan class=\"it\">π</tspan> and Voronoi diagram", "text");
  draw_ramp(canvas, {{350, 468}, {430, 490}}, kLevels, "0", "max");
  canvas.text({512, 485}, "<tspan class=\"it\">φ</tspan> and Delaunay triangulation", "text");
  draw_ramp(canvas, {{892, 468}, {970, 490}}, kLevels, "min", "0");
  using Kind = LegendEntry::Kind;
  const std::vector<LegendEntry> legend = {{Kind::dot, "dot", "points: minima of π, maxima of φ"},
                                           {Kind::dot, "mark", "sinks: maxima of π, minima of φ"}};
  draw_legend(canvas, {120, 534}, legend);
  return canvas.take();
}

}  // namespace sinkmesh::reproduce
