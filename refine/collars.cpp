// SPDX-License-Identifier: MIT
#include "refine/collars.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/vector.h"
#include "refine/corner_order.h"

namespace sinkmesh {
namespace {

using Kind = Feature::Kind;

/// Infinite if the foot of p in the plane of the triangle is outside: then an edge is nearer. A function of the
/// set of corners, not of their order.
double squared_distance_from_interior(const Point3& p, std::array<const Point3*, 3> triangle) {
  sort_corners(triangle);
  const Point3& a = *triangle[0];
  const Point3 normal = cross(*triangle[1] - a, *triangle[2] - a);
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3& u = *triangle[k];
    if (dot(cross(*triangle[(k + 1) % 3] - u, p - u), normal) < 0) return HUGE_VAL;
  }
  const double height = dot(p - a, normal);
  return height * height / dot(normal, normal);
}

/// From the features that do not have the corner.
double distance_of_others(Vertex v, const Boundary<3>& boundary, std::span<const Boundary<3>::Facet> facets) {
  const BoundaryFeatures<3>& features = boundary.features();
  const Complex<3>& complex = boundary.triangulation().complex();
  const Point3& p = complex.point(v);
  double least2 = HUGE_VAL;
  for (std::uint32_t s = 0; s < features.segments().size(); ++s) {
    for (const Vertex end : features.segments()[s].ends) {
      if (end != v) least2 = std::min(least2, squared_distance(p, complex.point(end)));
    }
    if (!features.has_corner({Kind::segment, s}, v)) {
      least2 = std::min(least2, features.distance2(p, {Kind::segment, s}));
    }
  }
  const std::vector<std::uint32_t> own = features.patches_at(v);
  for (const Boundary<3>::Facet& facet : facets) {
    const bool is_of_own_patch = std::any_of(own.begin(), own.end(), [&](std::uint32_t patch) {
      return std::all_of(facet.begin(), facet.end(), [&](Vertex corner) {
        return features.has_corner({Kind::patch, patch}, corner);
      });
    });
    if (is_of_own_patch) continue;
    least2 = std::min(least2,
                      squared_distance_from_interior(
                          p, {&complex.point(facet[0]), &complex.point(facet[1]), &complex.point(facet[2])}));
  }
  return std::sqrt(least2);
}

/// Corners with a sub-facet at them that is far smaller than their shortest segment.
std::set<Vertex> crowded_corners(const Boundary<3>& boundary) {
  constexpr double kCrowded2 = 0x1p-16;
  const Complex<3>& complex = boundary.triangulation().complex();
  std::map<Vertex, double> shortest2;
  for (const auto& segment : boundary.features().segments()) {
    const double length2 = squared_distance(complex.point(segment.ends[0]), complex.point(segment.ends[1]));
    for (const Vertex end : segment.ends) {
      double& least2 = shortest2.try_emplace(end, length2).first->second;
      least2 = std::min(least2, length2);
    }
  }
  std::set<Vertex> crowded;
  boundary.sub_facets().for_each([&](SubFacet f) {
    const auto& corners = boundary.sub_facets()[f].corners;
    for (const Vertex v : corners) {
      const auto segment = shortest2.find(v);
      if (segment == shortest2.end()) continue;
      const bool is_crowded = std::any_of(corners.begin(), corners.end(), [&](Vertex w) {
        return w != v && squared_distance(complex.point(v), complex.point(w)) < kCrowded2 * segment->second;
      });
      if (is_crowded) crowded.insert(v);
    }
  });
  return crowded;
}

}  // namespace

template <int Dim>
bool Collars::add_crowded(const Boundary<Dim>& boundary,
                          std::span<const typename Boundary<Dim>::Facet> facets) {
  constexpr double kPart = 0.4;
  bool has_added = false;
  if constexpr (Dim == 3) {
    for (const Vertex v : crowded_corners(boundary)) {
      if (radius(v) != 0) continue;
      radii_[v] = kPart * distance_of_others(v, boundary, facets);
      has_added = true;
    }
  }
  return has_added;
}

template bool Collars::add_crowded<2>(const Boundary<2>&, std::span<const Boundary<2>::Facet>);
template bool Collars::add_crowded<3>(const Boundary<3>&, std::span<const Boundary<3>::Facet>);

}  // namespace sinkmesh
