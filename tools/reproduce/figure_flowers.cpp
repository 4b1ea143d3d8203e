// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/star.h"
#include "refine/quality.h"
#include "tools/reproduce/detail/planar.h"
#include "tools/reproduce/figures.h"

namespace sinkmesh::reproduce {
namespace {

struct Example {
  Point2 x;
  std::vector<Simplex> prestar;
};

// A point with a large prestar whose flower stays among the points: of the centers of the triangles' incircles
// the one with the most triangles, if several, with the smallest balls.
Example find_example(Triangulation<2>& triangulation, const Box<2>& box) {
  Example best;
  double best_spread = HUGE_VAL;
  for (const Simplex s : detail::solid_triangles(triangulation.complex())) {
    const Point2 x = detail::incircle(detail::triangle(triangulation, s)).center;
    const Point2 gated = triangulation.gate().in(x);
    triangulation.announce(gated);
    const std::vector<Simplex> set = prestar(triangulation, gated, s);
    double spread = 0;
    bool is_amid = true;
    for (const Simplex t : set) {
      const detail::Ball ball = detail::delaunay_ball(triangulation, t);
      const double r = std::sqrt(ball.radius2);
      spread = std::max(spread, r);
      is_amid = is_amid && box.contains({ball.center[0] - r, ball.center[1] - r}) &&
                box.contains({ball.center[0] + r, ball.center[1] + r});
    }
    if (!is_amid) continue;
    if (set.size() > best.prestar.size() || (set.size() == best.prestar.size() && spread < best_spread)) {
      best = {x, set};
      best_spread = spread;
    }
  }
  return best;
}

Box<2> box_of_balls(const Triangulation<2>& triangulation, std::span<const Simplex> set) {
  Box<2> box;
  for (const Simplex s : set) {
    const detail::Ball ball = detail::delaunay_ball(triangulation, s);
    const double r = std::sqrt(ball.radius2);
    box.include({ball.center[0] - r, ball.center[1] - r});
    box.include({ball.center[0] + r, ball.center[1] + r});
  }
  return box;
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
  const Example example = find_example(before, detail::bounding_box(points));
  Triangulation<2> after(points);
  const std::vector<Simplex> star_of_x = star(after.complex(), after.insert(example.x).vertex);
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
  Box<2> world = box_of_balls(after, star_of_x);
  world.include(box_of_balls(before, example.prestar).low);
  world.include(box_of_balls(before, example.prestar).high);

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
