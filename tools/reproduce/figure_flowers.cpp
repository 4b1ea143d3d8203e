// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/star.h"
#include "tools/reproduce/detail/planar.h"
#include "tools/reproduce/figures.h"

namespace sinkmesh::reproduce {
namespace {

struct Example {
  Point2 x{};
  std::vector<Simplex> prestar;  // before x is inserted
  Triangulation<2> after;
  std::vector<Simplex> star;
};

std::vector<detail::Ball> balls_of(const Triangulation<2>& triangulation, std::span<const Simplex> set) {
  std::vector<detail::Ball> balls;
  for (const Simplex s : set) balls.push_back(detail::delaunay_ball(triangulation, s));
  return balls;
}

Box<2> box_of(const std::vector<detail::Ball>& balls) {
  Box<2> box;
  for (const detail::Ball& ball : balls) {
    const double r = std::sqrt(ball.radius2);
    box.include({ball.center[0] - r, ball.center[1] - r});
    box.include({ball.center[0] + r, ball.center[1] + r});
  }
  return box;
}

// By how much the flower grows on that side, of four, on which it grows the least; as a fraction of its size.
double growth(const Box<2>& before, const Box<2>& after) {
  double least = HUGE_VAL;
  for (std::size_t k = 0; k < 2; ++k) {
    least = std::min({least, before.low[k] - after.low[k], after.high[k] - before.high[k]});
  }
  return least / std::max(after.high[0] - after.low[0], after.high[1] - after.low[1]);
}

// Of the centers of the triangles' incircles one with at least four triangles in its prestar, with flowers that
// stay among the points, and grow on all sides.
Example find_example(Triangulation<2>& before, const std::vector<Point2>& points) {
  const Box<2> box = detail::bounding_box(points);
  Example best{.x = {}, .prestar = {}, .after = before, .star = {}};
  double most = 0;
  for (const Simplex s : detail::solid_triangles(before.complex())) {
    Example next{.x = detail::incircle(detail::triangle(before, s)).center,
                 .prestar = {},
                 .after = Triangulation<2>(points),
                 .star = {}};
    const Point2 gated = before.gate().in(next.x);
    before.announce(gated);
    next.prestar = prestar(before, gated, s);
    if (next.prestar.size() < 4) continue;
    next.star = star(next.after.complex(), next.after.insert(next.x).vertex);
    const Box<2> flower = box_of(balls_of(next.after, next.star));
    if (!box.contains(flower.low) || !box.contains(flower.high)) continue;
    const double grown = growth(box_of(balls_of(before, next.prestar)), flower);
    if (grown <= most) continue;
    most = grown;
    best = std::move(next);
  }
  return best;
}

void draw_triangulation(SvgCanvas& canvas, const Frame& frame, const Triangulation<2>& triangulation) {
  const std::vector<HalfFacet> all =
      detail::edges_of(triangulation.complex(), detail::solid_triangles(triangulation.complex()));
  canvas.segments(detail::place(frame, detail::edges(triangulation, all)), "thin");
}

void draw_set(SvgCanvas& canvas, const Frame& frame, const Triangulation<2>& triangulation,
              std::span<const Simplex> set) {
  canvas.segments(
      detail::place(frame, detail::edges(triangulation, detail::edges_of(triangulation.complex(), set))),
      "bold");
  for (const Simplex s : set) {
    for (const Point2& p : detail::triangle(triangulation, s)) canvas.circle(frame(p), 4.5, "dot");
  }
}

// The name of x stands in the widest gap between the edges of its star.
Point2 direction_of_gap(const Triangulation<2>& triangulation, std::span<const Simplex> star_of_x,
                        const Point2& x) {
  double shortest = HUGE_VAL;
  Point2 direction = {0, 1};
  for (const Simplex s : star_of_x) {
    // Of the two unit vectors along the edges the sum is the shorter the wider their angle.
    Point2 sum = {0, 0};
    for (const Point2& p : detail::triangle(triangulation, s)) {
      const double length = std::hypot(p[0] - x[0], p[1] - x[1]);
      if (length > 0) sum = {sum[0] + (p[0] - x[0]) / length, sum[1] + (p[1] - x[1]) / length};
    }
    const double length = std::hypot(sum[0], sum[1]);
    if (length > 0 && length < shortest) {
      shortest = length;
      direction = {sum[0] / length, sum[1] / length};
    }
  }
  return direction;
}

void draw_point(SvgCanvas& canvas, const Point2& at, const Point2& direction) {
  canvas.circle(at, 6, "mark");
  canvas.text({at[0] + 24 * direction[0], at[1] - 24 * direction[1] + 7}, "<tspan class=\"it\">x</tspan>",
              "name", Anchor::middle);
}

}  // namespace

std::string figure_flowers() {
  const std::vector<Point2> points = detail::sample_points();
  Triangulation<2> before(points);
  const Example example = find_example(before, points);
  const Triangulation<2>& after = example.after;
  const std::vector<Simplex>& star_of_x = example.star;
  const Point2 gap = direction_of_gap(after, star_of_x, example.x);

  SvgCanvas canvas(
      "figure-5", 1000, 570, "A prestar, a star, and their flowers",
      "Left: a Delaunay triangulation, a point x, and the " + std::to_string(example.prestar.size()) +
          " triangles of its prestar, with their Delaunay balls. Right: the triangulation after the "
          "insertion of x; bold edges bound the " +
          std::to_string(star_of_x.size()) +
          " triangles of its star. Shaded weakly: the flower of the prestar; strongly: what the flower of the "
          "star has more.");
  canvas.rule(".name", "font-size:26px");
  canvas.rule(".balls", "fill:none;stroke:var(--c-muted);stroke-width:1.2;stroke-dasharray:5 4");
  // The flower of the star covers that of the prestar [EG01, Flower Lemma].
  const Box<2> world = box_of(balls_of(after, star_of_x));

  const auto panel = [&](double left, auto&& draw) {
    const std::vector<std::vector<Point2>> window = {
        {{left, 10}, {left + 480, 10}, {left + 480, 480}, {left, 480}}};
    canvas.begin_clip(canvas.define_clip(window));
    draw(Frame(world, {{left + 12, 22}, {left + 468, 468}}));
    canvas.end_clip();
  };
  panel(10, [&](const Frame& frame) {
    const std::vector<Ellipse> balls = detail::place_balls(frame, before, example.prestar);
    canvas.ellipses(balls, "fill-1");
    canvas.polygons(detail::place(frame, detail::triangles(before, example.prestar)), "fill-2");
    canvas.ellipses(balls, "balls");
    draw_triangulation(canvas, frame, before);
    draw_set(canvas, frame, before, example.prestar);
    draw_point(canvas, frame(example.x), gap);
  });
  panel(510, [&](const Frame& frame) {
    canvas.ellipses(detail::place_balls(frame, after, star_of_x), "fill-3");
    canvas.ellipses(detail::place_balls(frame, before, example.prestar), "fill-1");
    draw_triangulation(canvas, frame, after);
    draw_set(canvas, frame, after, star_of_x);
    draw_point(canvas, frame(example.x), gap);
  });

  using Kind = LegendEntry::Kind;
  canvas.text({250, 512}, "prestar: " + std::to_string(example.prestar.size()) + " triangles, and their balls",
              "text", Anchor::middle);
  canvas.text({750, 512}, "star: " + std::to_string(star_of_x.size()) + " triangles, and both flowers", "text",
              Anchor::middle);
  const std::vector<LegendEntry> legend = {{Kind::area, "fill-2", "prestar"},
                                           {Kind::area, "fill-1", "flower of the prestar"},
                                           {Kind::area, "fill-3", "added by the flower of the star"}};
  draw_legend(canvas, {130, 554}, legend);
  return canvas.take();
}

}  // namespace sinkmesh::reproduce
