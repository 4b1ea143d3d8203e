// SPDX-License-Identifier: MIT
#include "refine/parents.h"

#include <algorithm>
#include <cmath>

#include "core/vector.h"

namespace sinkmesh {
namespace {

// Ids from 1: a search finds larger ids than its own, which is 0.
template <int Dim>
std::vector<BoxOfFacet<Dim>> boxes_of(const Complex<Dim>& complex,
                                      std::span<const std::array<Vertex, Dim>> facets) {
  std::vector<BoxOfFacet<Dim>> boxes(facets.size());
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    for (const Vertex v : facets[f]) boxes[f].box.include(complex.point(v));
    boxes[f].facet = f + 1;
  }
  return boxes;
}

}  // namespace

template <int Dim>
Parents<Dim>::Parents(const Boundary<Dim>& boundary, std::span<const std::array<Vertex, Dim>> facets)
    : boundary_(&boundary), facets_(facets) {}

template <int Dim>
std::uint32_t Parents<Dim>::of(SubFacet f) {
  const auto& record = boundary_->sub_facets()[f];
  if constexpr (Dim == 3) {
    const BoundaryFeatures<3>& features = boundary_->features();
    const std::array<Vertex, Dim>& parent = facets_[record.parent];
    const bool is_whole = std::is_permutation(parent.begin(), parent.end(), record.corners.begin());
    if (is_whole || !features.patches()[record.owner].is_joined) return record.parent;
    const Complex<3>& complex = boundary_->triangulation().complex();
    if (!boxes_) boxes_.emplace(boxes_of<Dim>(complex, facets_));
    const Plane& plane = features.patches()[record.owner].plane;
    BoxOfFacet<3> query;
    Point3 center{};
    for (const Point3* p : boundary_->corner_points(f)) {
      query.box.include(*p);
      for (std::size_t k = 0; k < 3; ++k) center[k] += (*p)[k] / 3;
    }
    const Point2 c = plane.project(center);
    // How far inside the center is: the least of three areas, negative if outside. The rounding of the center
    // may put it out of all facets by a little.
    std::uint32_t best = record.parent;
    double most = -HUGE_VAL;
    boxes_->for_each_larger_id(query, [&](std::uint32_t id) {
      const auto& facet = facets_[id - 1];
      const bool is_here = std::all_of(facet.begin(), facet.end(),
                                       [&](Vertex v) { return features.is_on_patch(v, record.owner); });
      if (!is_here) return;
      std::array<Point2, 3> p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = plane.project(complex.point(facet[k]));
      const double turn = cross(p[1] - p[0], p[2] - p[0]) < 0 ? -1 : 1;
      double least = HUGE_VAL;
      for (std::size_t k = 0; k < 3; ++k) {
        least = std::min(least, turn * cross(p[(k + 1) % 3] - p[k], c - p[k]));
      }
      if (least > most || (least == most && id - 1 < best)) {
        most = least;
        best = id - 1;
      }
    });
    return best;
  }
  return record.parent;
}

template class Parents<2>;
template class Parents<3>;

}  // namespace sinkmesh
