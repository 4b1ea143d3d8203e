// SPDX-License-Identifier: MIT
#include "tools/reproduce/shaded_view.h"

#include <cmath>
#include <vector>

#include "refine/quality.h"
#include "tools/reproduce/render.h"

namespace sinkmesh::reproduce {
namespace {

constexpr Perceived kSurface{0.86, 0.03, 235};
constexpr Perceived kSurfaceBesideCut{0.84, 0.004, 240};
// Enough to see the shapes of the tetrahedra, not so much that a colour is taken for another one of the scale.
constexpr double kReliefOnCut = 0.45;

double ratio(const Mesh3& mesh, std::uint32_t simplex) {
  Corners<3> corners{};
  for (std::size_t i = 0; i < 4; ++i) corners[i] = &mesh.points[mesh.simplices[simplex][i]];
  return std::sqrt(shape<3>(corners).ratio2());
}

}  // namespace

Image surface_view(const Surface3& surface, const View& view, int width, int height) {
  std::vector<Face> faces;
  faces.reserve(surface.facets.size());
  for (const auto& facet : surface.facets) faces.push_back({facet, to_light(kSurface)});
  return render(surface.points, faces, Projection(view, surface.points, width, height), width, height);
}

Image cut_view(const Mesh3& mesh, const Cut& cut, const View& view, const RatioScale& scale, int width,
               int height) {
  std::vector<Face> faces;
  for (const VisibleFace& face : visible_faces(mesh, kept_simplices(mesh, cut))) {
    if (face.on_cut) {
      faces.push_back({face.corners, ratio_colour(scale.position(ratio(mesh, face.simplex))), kReliefOnCut});
    } else {
      faces.push_back({face.corners, to_light(kSurfaceBesideCut)});
    }
  }
  std::vector<Point3> kept;
  for (const Point3& p : mesh.points) {
    if (cut.keeps(p)) kept.push_back(p);
  }
  return render(mesh.points, faces, Projection(view, kept, width, height), width, height);
}

}  // namespace sinkmesh::reproduce
