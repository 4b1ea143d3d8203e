// SPDX-License-Identifier: MIT
//
// A landscape seen from the south, its height -phi: phi decreases from bottom to top, as in the paper. It is
// built of terraces. The points of height t or more are a union of discs (figure_level_sets.cpp), in the
// oblique projection a union of ellipses; the projection of a layer hides exactly those parts of lower ones
// that lie behind it, so drawing from bottom to top is drawing from back to front.
#include <algorithm>
#include <cmath>
#include <vector>

#include "refine/flow.h"
#include "refine/refine.h"
#include "tools/reproduce/detail/planar.h"

#include <fmt/format.h>
#include "tools/reproduce/figures.h"

namespace sinkmesh::reproduce {
namespace {

constexpr int kLayers = 56;
constexpr double kForeshortening = 0.62;  // of the north-south axis
constexpr double kTop = 250;              // height of the highest sink, in the picture

struct Patch {
  std::vector<Point2> corners;
  detail::Ball ball;
  double height;  // the largest of -phi
  bool is_sink;
};

// The square distance of a point from a triangle.
double distance2_to(const std::vector<Point2>& triangle, const Point2& p) {
  bool is_inside = true;
  double nearest = HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2& a = triangle[i];
    const Point2& b = triangle[(i + 1) % 3];
    const Point2 u = {b[0] - a[0], b[1] - a[1]};
    const Point2 v = {p[0] - a[0], p[1] - a[1]};
    if (u[0] * v[1] - u[1] * v[0] < 0) is_inside = false;
    const double t = std::clamp((u[0] * v[0] + u[1] * v[1]) / (u[0] * u[0] + u[1] * u[1]), 0.0, 1.0);
    nearest = std::min(nearest, detail::distance2(p, {a[0] + t * u[0], a[1] + t * u[1]}));
  }
  return is_inside ? 0 : nearest;
}

std::vector<Patch> find_patches(const Triangulation<2>& triangulation, const std::vector<Simplex>& inside) {
  Flow<2> flow(triangulation);
  std::vector<Patch> patches;
  for (const Simplex s : inside) {
    const std::vector<Point2> corners = detail::triangle(triangulation, s);
    const detail::Ball ball = detail::delaunay_ball(triangulation, s);
    patches.push_back({corners, ball, ball.radius2 - distance2_to(corners, ball.center), flow.is_sink(s)});
  }
  return patches;
}

// From the ground to the picture; heights go straight up.
class Oblique {
 public:
  Oblique(const Frame& frame, double height_scale) : frame_(frame), height_scale_(height_scale) {}

  Point2 operator()(const Point2& p, double height = 0) const {
    const Point2 q = frame_({p[0], kForeshortening * p[1]});
    return {q[0], q[1] - lift(height)};
  }
  double lift(double height) const { return height_scale_ * height; }
  double scale() const { return frame_.scale(); }

 private:
  Frame frame_;
  double height_scale_;
};

void draw_layer(SvgCanvas& canvas, const Oblique& view, int clip, const std::vector<Patch>& patches,
                double height, const std::string& colour) {
  std::vector<Ellipse> discs;
  for (const Patch& patch : patches) {
    // A disc that misses its own triangle adds nothing to the union: others cover what it has of the domain.
    if (patch.height <= height) continue;
    const double radius = view.scale() * std::sqrt(patch.ball.radius2 - height);
    discs.push_back({view(patch.ball.center), radius, kForeshortening * radius});
  }
  canvas.begin_clip(clip, view.lift(height));
  canvas.ellipses(discs, "layer " + colour);
  canvas.end_clip();
}

// On an edge of length l, at the distance s from one end, the height is s (l-s), whichever triangle one asks.
// The part of the edges between two heights, to be drawn between their layers.
std::vector<Segment> seams(const Oblique& view, const std::vector<Segment>& edges, double low, double high) {
  std::vector<Segment> result;
  for (const auto& [p, q] : edges) {
    const double length2 = detail::distance2(p, q);
    if (length2 / 4 <= low) continue;
    // As fractions of the edge: s (1-s) l^2 = height.
    const auto fraction = [&](double height) {
      return (1 - std::sqrt(std::max(0.0, 1 - 4 * height / length2))) / 2;
    };
    const double s = fraction(low);
    const double t = fraction(high);
    const auto at = [&, &p = p, &q = q](double u) {
      return view({p[0] + u * (q[0] - p[0]), p[1] + u * (q[1] - p[1])}, u * (1 - u) * length2);
    };
    if (t >= 0.5) {
      result.emplace_back(at(s), at(0.5));
      result.emplace_back(at(0.5), at(1 - s));
    } else {
      result.emplace_back(at(s), at(t));
      result.emplace_back(at(1 - t), at(1 - s));
    }
  }
  return result;
}

}  // namespace

std::string figure_graph_of_phi(const Surface2& usa) {
  SurfaceMesher2 mesher(usa);
  static_cast<void>(mesher.find_domain());
  const Triangulation<2>& triangulation = mesher.triangulation();
  const std::vector<Simplex> inside = mesher.domain().simplices();
  const std::vector<Patch> patches = find_patches(triangulation, inside);
  double top = 0;
  for (const Patch& patch : patches) top = std::max(top, patch.height);

  SvgCanvas canvas(
      "figure-3", 1000, 570, "The graph of phi",
      "The graph of phi over the USA data set, seen from the south, with function values decreasing "
      "from bottom to top: " +
          std::to_string(patches.size()) + " paraboloid patches, one for each triangle, cut into " +
          std::to_string(kLayers) + " terraces. The summits are the sinks; the vertices are at the bottom.");
  canvas.use_ramp(kLayers);
  canvas.rule(".layer", "stroke:#000;stroke-opacity:.28;stroke-width:.7;paint-order:stroke");
  canvas.rule(".seam", "fill:none;stroke:var(--c-ink);stroke-width:.9;stroke-opacity:.75");

  Box<2> ground;
  for (const Point2& p : usa.points) ground.include({p[0], kForeshortening * p[1]});
  const Oblique view(Frame(ground, {{12, 95}, {988, 555}}), kTop / top);
  std::vector<std::vector<Point2>> shore = detail::outline(triangulation, mesher.domain().boundary());
  for (std::vector<Point2>& polygon : shore) {
    for (Point2& p : polygon) p = view(p);
  }
  const int clip = canvas.define_clip(shore);
  const std::vector<Segment> edges =
      detail::edges(triangulation, detail::edges_of(triangulation.complex(), inside));
  canvas.polygons(shore, fmt::format("layer l{}", kLayers - 1));
  for (int k = 0; k < kLayers; ++k) {
    const double height = top * k / kLayers;
    if (k > 0) draw_layer(canvas, view, clip, patches, height, fmt::format("l{}", kLayers - 1 - k));
    const double above = top * (k + 1) / kLayers;
    canvas.segments(seams(view, edges, height, above), "seam");
    for (const Patch& patch : patches) {
      const double summit = patch.ball.radius2;
      if (patch.is_sink && height < summit && summit <= above) {
        canvas.circle(view(patch.ball.center, summit), 3.4, "mark");
      }
    }
  }
  draw_ramp(canvas, {{715, 36}, {935, 58}}, kLayers, "φ: min", "0");
  const LegendEntry sinks = {LegendEntry::Kind::dot, "mark", "sinks, the minima of φ"};
  draw_legend(canvas, {711, 92}, {&sinks, 1});
  return canvas.take();
}

}  // namespace sinkmesh::reproduce
