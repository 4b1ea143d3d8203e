// SPDX-License-Identifier: MIT
//
// A picture of a mesh in the plane. Reads no file back: coordinates are rounded to a thousandth of a unit.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tools/io/detail/codecs.h"
#include "tools/io/detail/text_writer.h"

namespace sinkmesh::io_detail {
namespace {

constexpr double kSize = 1000;  // of the longer side, in units of the picture
constexpr double kMargin = 10;

// From the mesh to the picture, whose y axis points down.
class Frame {
 public:
  explicit Frame(const Mesh2& mesh) {
    for (const auto& simplex : mesh.simplices) {
      for (const std::uint32_t v : simplex) box_.include(mesh.points[v]);
    }
    if (mesh.simplices.empty()) box_.include({0, 0});
    // Halves first, so that no difference overflows.
    const double half = std::max(box_.high[0] / 2 - box_.low[0] / 2, box_.high[1] / 2 - box_.low[1] / 2);
    scale_ = half > 0 ? kSize / half / 2 : 0;
  }

  Point2 place(const Point2& p) const { return {length(p[0], box_.low[0]), length(box_.high[1], p[1])}; }
  double width() const { return length(box_.high[0], box_.low[0]); }
  double height() const { return length(box_.high[1], box_.low[1]); }

 private:
  double length(double high, double low) const {
    return std::round(1000 * 2 * (high / 2 - low / 2) * scale_) / 1000;
  }

  Box<2> box_;
  double scale_ = 0;
};

using Edge = std::pair<std::uint32_t, std::uint32_t>;

void draw(TextWriter& out, const Mesh2& mesh, const Frame& frame, const std::vector<Edge>& edges,
          const char* style) {
  out << "<path " << style << " d=\"";
  for (const auto& [a, b] : edges) {
    const Point2 p = frame.place(mesh.points[a]);
    const Point2 q = frame.place(mesh.points[b]);
    out << 'M' << p[0] << ' ' << p[1] << 'L' << q[0] << ' ' << q[1];
  }
  out << "\"/>\n";
}

}  // namespace

std::string encode_svg(const Mesh2& mesh) {
  std::vector<Edge> edges;
  for (const auto& simplex : mesh.simplices) {
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(std::minmax(simplex[i], simplex[(i + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<Edge> boundary;
  for (const auto& facet : mesh.boundary) boundary.emplace_back(facet[0], facet[1]);

  const Frame frame(mesh);
  TextWriter out;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" << -kMargin << ' ' << -kMargin << ' '
      << frame.width() + 2 * kMargin << ' ' << frame.height() + 2 * kMargin
      << "\" fill=\"none\" stroke=\"#567\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n"
      << "<title>" << mesh.simplices.size() << " triangles</title>\n";
  draw(out, mesh, frame, edges, "stroke-width=\"0.8\"");
  draw(out, mesh, frame, boundary, "stroke-width=\"2.5\"");
  out << "</svg>\n";
  return out.take();
}

}  // namespace sinkmesh::io_detail
