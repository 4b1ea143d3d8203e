// SPDX-License-Identifier: MIT
//
// Figures 6 and 7: what the schedules make of the USA data set.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "refine/quality.h"
#include "refine/refine.h"
#include "tools/reproduce/detail/planar.h"
#include "tools/reproduce/figures.h"

namespace sinkmesh::reproduce {
namespace {

constexpr double kRatio = 1.0;  // rho_0 of [EG01, 5.2]

using Ids = std::pair<std::uint32_t, std::uint32_t>;

std::vector<Segment> segments_between(const Mesh2& mesh, const Frame& frame, std::vector<Ids> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<Segment> segments;
  for (const auto& [a, b] : ids) segments.emplace_back(frame(mesh.points[a]), frame(mesh.points[b]));
  return segments;
}

bool is_low_quality(const Mesh2& mesh, const Mesh2::Simplex& s) {
  return shape<2>({&mesh.points[s[0]], &mesh.points[s[1]], &mesh.points[s[2]]}).ratio2() > kRatio * kRatio;
}

void draw_mesh(SvgCanvas& canvas, const Frame& frame, const Mesh2& mesh, std::size_t num_input, double dot) {
  std::vector<std::vector<Point2>> low;
  std::vector<Ids> edges;
  for (const Mesh2::Simplex& s : mesh.simplices) {
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(std::minmax(s[i], s[(i + 1) % 3]));
    if (is_low_quality(mesh, s)) {
      low.push_back({frame(mesh.points[s[0]]), frame(mesh.points[s[1]]), frame(mesh.points[s[2]])});
    }
  }
  std::vector<Ids> outline;
  for (const Mesh2::Facet& facet : mesh.boundary) outline.emplace_back(facet[0], facet[1]);
  canvas.polygons(low, "tint");
  canvas.segments(segments_between(mesh, frame, edges), "thin");
  canvas.segments(segments_between(mesh, frame, outline), "bold");
  for (std::size_t p = num_input; p < mesh.points.size(); ++p) {
    canvas.circle(frame(mesh.points[p]), dot, "mark");
  }
}

void draw_common_legend(SvgCanvas& canvas, double y, const char* points) {
  using Kind = LegendEntry::Kind;
  const std::vector<LegendEntry> legend = {{Kind::dot, "mark", points},
                                           {Kind::area, "tint", "low quality: r/ℓ above 1"}};
  draw_legend(canvas, {14, y}, legend);
}

std::string count_of(std::size_t n, const std::string& thing) {
  return std::to_string(n) + " " + thing + (n == 1 ? "" : "s");
}

}  // namespace

std::string figure_first_sinks(const Surface2& usa) {
  constexpr std::array<std::size_t, 4> kSinks = {0, 4, 12, 15};
  SurfaceMesher2 mesher(usa);
  static_cast<void>(mesher.find_domain());
  const std::size_t num_vertices = mesher.num_vertices();

  SvgCanvas canvas(
      "figure-6", 1200, 860, "The first sinks of the incremental schedule",
      "The USA data set before adding any sinks and after incrementally adding 4, 12 and 15 sinks, "
      "worst ratio first. Triangles of low quality are tinted, new vertices are marked.");
  canvas.rule(".thin", "stroke-width:.7");
  canvas.rule(".bold", "stroke-width:1.6");
  for (std::size_t k = 0; k < kSinks.size(); ++k) {
    if (kSinks[k] > 0) {
      static_cast<void>(mesher.refine({.max_ratio = kRatio, .max_vertices = num_vertices + kSinks[k]}));
    }
    const Mesh2 mesh = mesher.mesh();
    const Point2 corner = {k % 2 == 0 ? 10.0 : 610.0, k < 2 ? 10.0 : 420.0};
    const Frame frame(detail::bounding_box(usa.points), {corner, {corner[0] + 580, corner[1] + 360}});
    draw_mesh(canvas, frame, mesh, usa.points.size(), 5);
    const std::size_t added = mesh.points.size() - usa.points.size();
    canvas.text({corner[0] + 290, corner[1] + 388},
                (added == 0 ? "no sink" : count_of(added, "sink")) + ": " +
                    count_of(mesh.simplices.size(), "triangle") + ", " +
                    std::to_string(mesher.statistics(kRatio).low_quality()) + " of low quality",
                "text", Anchor::middle);
  }
  draw_common_legend(canvas, 850, "sinks added");
  return canvas.take();
}

std::string figure_block_meshes(const Surface2& usa) {
  SvgCanvas canvas("figure-7", 1200, 460, "The USA data set, refined in blocks",
                   "The triangulations after block-scheduled sink-insertion and circumcenter-insertion, with "
                   "ratios r/l of at most 1 wherever the boundary allows. Triangles that remain of low quality "
                   "are tinted.");
  canvas.rule(".thin", "stroke-width:.6");
  canvas.rule(".bold", "stroke-width:1.5");
  double x = 10;
  for (const Insert insert : {Insert::sink, Insert::circumcenter}) {
    SurfaceMesher2 mesher(usa);
    static_cast<void>(mesher.find_domain());
    static_cast<void>(mesher.refine({.max_ratio = kRatio, .insert = insert, .schedule = Schedule::block}));
    const Frame frame(detail::bounding_box(usa.points), {{x, 10}, {x + 580, 380}});
    const Mesh2 mesh = mesher.mesh();
    draw_mesh(canvas, frame, mesh, usa.points.size(), 2.2);
    canvas.text({x + 290, 410},
                (insert == Insert::sink ? "sinks: " : "circumcenters: ") +
                    count_of(mesh.simplices.size(), "triangle") + ", " +
                    std::to_string(mesher.statistics(kRatio).low_quality()) + " of low quality",
                "text", Anchor::middle);
    x += 600;
  }
  draw_common_legend(canvas, 446, "points added");
  return canvas.take();
}

}  // namespace sinkmesh::reproduce
