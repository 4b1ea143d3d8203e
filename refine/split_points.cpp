// SPDX-License-Identifier: MIT
//
// Where points on the boundary go [BR, 5].
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "core/mix.h"
#include "core/vector.h"
#include "predicates/input_gate.h"
#include "refine/conformer.h"

namespace sinkmesh {
namespace {

using Kind = Feature::Kind;

// Slightly more than 1, as the coordinates have it: points that would be placed in one pattern would be the
// corners of flat simplices, and what it takes to get rid of those makes the next pattern. Far below the 1 -
// cos(theta) by which a mirror image at an angle theta is better than the point itself, and below the quarter
// of a squared length by which shells leave each other alone.
template <int Dim>
double apart(const Point<Dim>& p) {
  return 1 + std::ldexp(static_cast<double>(hash_point<Dim>(p) >> 11), -53 - 20);
}

}  // namespace

// ------------------------------------------------------------------------------------------------
//  On segments and patches.

// A power of two away from a corner at one end, so that pieces of segments that meet there at a small angle
// become equally long and leave each other alone; unless the culprit, or, if there is none, the angles there,
// have nothing to do with that. Else where the culprit is nearest, if pieces of features that run side by side
// may be the reason; not at a corner from which both come. Else the middle.
template <int Dim>
double Conformer<Dim>::split_position(const SubSegment& s, Vertex culprit) const {
  const auto& features = boundary_->features();
  const double tu = features.position(s.u, s.segment);
  const double tv = features.position(s.v, s.segment);
  const bool is_corner_u = tu == 0 || tu == 1;
  const bool is_corner_v = tv == 0 || tv == 1;
  if (is_corner_u != is_corner_v) {
    const Vertex corner = is_corner_u ? s.u : s.v;
    if (Dim == 2 || (culprit.is_null() ? features.is_sharp_at(s.segment, corner)
                                       : features.has_corner(features.vertex(culprit).on, corner))) {
      const double length = features.length(s.segment);
      const double shell = std::exp2(std::floor(std::log2(std::abs(tu - tv) * length * (2.0 / 3)))) / length;
      const auto away = [&](double part) { return (is_corner_u ? tu : tv) == 0 ? part : 1 - part; };
      return away(Dim == 2 ? shell : shell * apart<Dim>(features.point_at(s.segment, away(shell))));
    }
  }
  if (Dim == 3 && projects_ && !culprit.is_null() && features.is_on_boundary(culprit) &&
      !boundary_->has_edge(s.u, s.v) && !(is_corner_u && comes_from(culprit, s.u)) &&
      !(is_corner_v && comes_from(culprit, s.v))) {
    const auto& ends = features.segments()[s.segment].ends;
    const Point<Dim> along = complex().point(ends[1]) - complex().point(ends[0]);
    const double t = dot(complex().point(culprit) - complex().point(ends[0]), along) / dot(along, along);
    const auto [low, high] = std::minmax(tu, tv);
    const double part = (t - low) / (high - low);
    if (part > 0.2 && part < 0.8) return low + part * apart<Dim>(complex().point(culprit)) * (high - low);
  }
  return (tu + tv) / 2;
}

// Whether v lies on a patch that has the corner.
template <int Dim>
bool Conformer<Dim>::comes_from(Vertex v, Vertex corner) const {
  const auto& features = boundary_->features();
  const std::vector<std::uint32_t> patches = features.patches_at(v);
  return std::any_of(patches.begin(), patches.end(), [&](std::uint32_t patch) {
    return features.has_corner({Kind::patch, patch}, corner);
  });
}

// The mirror image of q over a segment that its patch shares with that of f, in the plane of f [BR, Lemma 2].
template <int Dim>
std::optional<Point<Dim>> Conformer<Dim>::mirror_image(SubFacet f, Vertex q) const {
  if constexpr (Dim == 2) {
    return std::nullopt;
  } else {
    const auto& features = boundary_->features();
    const std::uint32_t patch = boundary_->sub_facets()[f].owner;
    const Point3& p = complex().point(q);
    if (features.is_on_patch(q, patch)) return std::nullopt;
    std::optional<std::uint32_t> nearest;
    for (const std::uint32_t other : features.patches_at(q)) {
      for (const std::uint32_t s : features.patches()[other].segments) {
        const auto& at = features.patches_at_segment(s);
        if (std::find(at.begin(), at.end(), patch) == at.end()) continue;
        const auto key = [&](std::uint32_t x) {
          const auto& e = features.segments()[x].ends;
          return std::tuple(features.distance2(p, {Kind::segment, x}), complex().point(e[0]),
                            complex().point(e[1]));
        };
        if (!nearest || key(s) < key(*nearest)) nearest = s;
      }
    }
    if (!nearest) return std::nullopt;
    const auto& ends = features.segments()[*nearest].ends;
    const Point3& a = complex().point(ends[0]);
    const Point3 along = complex().point(ends[1]) - a;
    const double t = dot(p - a, along) / dot(along, along);
    Point3 foot = a;
    for (std::size_t k = 0; k < 3; ++k) foot[k] += t * along[k];
    const Plane& plane = features.patches()[patch].plane;
    Point3 out = cross(plane.normal, along);
    Point3 middle{};
    for (const Point3* corner : boundary_->corner_points(f)) {
      for (std::size_t k = 0; k < 3; ++k) middle[k] += (*corner)[k] / 3;
    }
    const double sign = dot(middle - foot, out) > 0 ? 1 : -1;
    if (sign * dot(p - foot, out) <= 0) return std::nullopt;  // no acute angle
    // A little farther, or two such pairs would be the corners of a trapezoid: cocircular.
    const double scale = sign * apart<3>(p) * std::sqrt(squared_distance(p, foot) / dot(out, out));
    for (std::size_t k = 0; k < 3; ++k) foot[k] += scale * out[k];
    return foot;
  }
}

// As far from a corner as q is and as two corners of f are, in the plane of f [BR, Lemma 3].
template <int Dim>
std::optional<Point<Dim>> Conformer<Dim>::sphere_point(SubFacet f, Vertex q) const {
  if constexpr (Dim == 2) {
    return std::nullopt;
  } else {
    const auto& features = boundary_->features();
    const auto& corners = boundary_->sub_facets()[f].corners;
    const Plane& plane = features.patches()[boundary_->sub_facets()[f].owner].plane;
    const Point3& p = complex().point(q);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex v = corners[k];
      if (collars_->radius(v) != 0) continue;  // arcs are divided there
      if (features.vertex(v).on.kind != Kind::corner || !features.has_corner(features.vertex(q).on, v))
        continue;
      const Point3& center = complex().point(v);
      const double radius2 = squared_distance(p, center);
      const auto is_equal = [&](Vertex u) {
        return std::abs(squared_distance(complex().point(u), center) - radius2) <= 2e-6 * radius2;
      };
      if (!is_equal(corners[(k + 1) % 3]) || !is_equal(corners[(k + 2) % 3])) continue;
      Point3 way = p - center;
      const double height = dot(way, plane.normal);
      for (std::size_t i = 0; i < 3; ++i) way[i] -= height * plane.normal[i];
      const double length2 = dot(way, way);
      if (length2 < radius2 / 4) continue;
      Point3 x = center;
      for (std::size_t i = 0; i < 3; ++i) x[i] += way[i] * std::sqrt(radius2 / length2);
      return x;
    }
    return std::nullopt;
  }
}

// ------------------------------------------------------------------------------------------------
//  On collars.

// From both ends, where there are collars; the shortest segments first, because what is known of a vertex
// depends on those before it.
template <int Dim>
void Conformer<Dim>::divide_at_collars() {
  const auto& features = boundary_->features();
  std::vector<SegmentEntry> segments;
  for (std::uint32_t s = 0; s < features.segments().size(); ++s) {
    const auto& ends = features.segments()[s].ends;
    if (collars_->radius(ends[0]) + collars_->radius(ends[1]) > 0)
      segments.push_back(entry_of({ends[0], ends[1], s}));
  }
  std::sort(segments.begin(), segments.end());
  for (const SegmentEntry& entry : segments) {
    SubSegment rest = entry.segment;
    const double length = features.length(rest.segment);
    for (const Vertex end : {rest.u, rest.v}) {
      const double part = collars_->radius(end) / length;
      if (part == 0) continue;
      const double t = end == rest.v ? 1 - part : part;
      const auto w = Vertex(static_cast<std::uint32_t>(complex().num_vertices()));
      if (insert_on_segment(rest, t, {}, 0)) (end == rest.v ? rest.v : rest.u) = w;
    }
  }
}

// That of a collar, if the sub-facet has one; of several that of the least coordinates.
template <int Dim>
std::optional<Vertex> Conformer<Dim>::collared_corner(SubFacet f) const {
  std::optional<Vertex> least;
  if (collars_->empty()) return least;
  for (const Vertex v : boundary_->sub_facets()[f].corners) {
    if (collars_->radius(v) != 0 && (!least || complex().point(v) < complex().point(*least))) least = v;
  }
  return least;
}

// Whether a collar of a corner of the patch would have x inside. No center is, that destroys no sub-facet at
// the corner: the ball between both would have no vertex inside, so they would become neighbours.
template <int Dim>
bool Conformer<Dim>::is_inside_collar(std::uint32_t patch, const Point<Dim>& x) const {
  if (collars_->empty()) return false;
  const auto& corners = boundary_->features().patches()[patch].corners;
  return std::any_of(corners.begin(), corners.end(), [&](Vertex v) {
    return squared_distance(x, complex().point(v)) < std::pow(collars_->radius(v), 2);
  });
}

// On the collar, between the two sides of a sub-facet at its corner: a power of two away from a side that is
// part of a segment, if only one is; else in the middle. Exactly on it: short arcs would feel the least
// difference.
template <int Dim>
Point<Dim> Conformer<Dim>::point_on_arc(SubFacet f, Vertex corner) const {
  const auto& corners = boundary_->sub_facets()[f].corners;
  const Point<Dim>& center = complex().point(corner);
  const double radius = collars_->radius(corner);
  std::array<Point<Dim>, 2> sides;
  std::array<bool, 2> is_segment{};
  std::size_t n = 0;
  for (const Vertex v : corners) {
    if (v == corner) continue;
    const Point<Dim> way = complex().point(v) - center;
    const double length = std::sqrt(dot(way, way));
    for (std::size_t k = 0; k < Dim; ++k) sides[n][k] = way[k] / length;
    is_segment[n++] = boundary_->sub_facets().segment_of(corner, v) != SubFacets<3>::kNone;
  }
  if (is_segment[1]) std::swap(sides[0], sides[1]);
  const double chord = std::sqrt(squared_distance(sides[0], sides[1]));
  const double angle = 2 * std::asin(std::min(1.0, chord / 2));
  double part = 0.5;
  if (is_segment[0] != is_segment[1]) {
    const double shell = std::exp2(std::floor(std::log2(chord * radius * (2.0 / 3)))) / radius;
    part = 2 * std::asin(shell / 2) / angle;
  }
  // Spherical interpolation; of a straight angle it would be noise, but no sub-facet has one.
  Point<Dim> way{};
  for (std::size_t k = 0; k < Dim; ++k) {
    way[k] = std::sin((1 - part) * angle) * sides[0][k] + std::sin(part * angle) * sides[1][k];
  }
  Point<Dim> x = center;
  const double scale = radius / std::sqrt(dot(way, way));
  for (std::size_t k = 0; k < Dim; ++k) x[k] += scale * way[k];
  return x;
}

template class Conformer<2>;
template class Conformer<3>;

}  // namespace sinkmesh
