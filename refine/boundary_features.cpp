// SPDX-License-Identifier: MIT
#include "refine/boundary_features.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/vector.h"
#include "predicates/constructions.h"
#include "predicates/input_gate.h"

namespace sinkmesh {

using Kind = Feature::Kind;

Plane Plane::through(const Point3& a, const Point3& b, const Point3& c) {
  if (b < a || c < a) return b < c ? through(b, c, a) : through(c, a, b);
  Plane plane;
  plane.origin = a;
  plane.normal = facet_normal<3>({&a, &b, &c});
  // Scaled first: squares of the normal of a needle may underflow.
  double largest = 0;
  for (const double x : plane.normal) largest = std::max(largest, std::abs(x));
  for (double& x : plane.normal) x /= largest;
  const double length = std::sqrt(dot(plane.normal, plane.normal));
  for (double& x : plane.normal) x /= length;
  const auto size = [&](int k) { return std::abs(plane.normal[static_cast<std::size_t>(k)]); };
  int dropped = 0;
  for (const int k : {1, 2}) dropped = size(k) > size(dropped) ? k : dropped;
  plane.dropped = static_cast<std::uint8_t>(dropped);
  plane.kept = {static_cast<std::uint8_t>((dropped + 1) % 3), static_cast<std::uint8_t>((dropped + 2) % 3)};
  if (plane.normal[plane.dropped] < 0) std::swap(plane.kept[0], plane.kept[1]);
  return plane;
}

Point3 Plane::lift(const Point2& p) const {
  Point3 q = origin;
  q[kept[0]] = p[0];
  q[kept[1]] = p[1];
  const double slope = normal[kept[0]] * (p[0] - origin[kept[0]]) + normal[kept[1]] * (p[1] - origin[kept[1]]);
  q[dropped] -= slope / normal[dropped];
  return on_grid<3>(q);
}

double Plane::distance(const Point3& p) const { return std::abs(dot(normal, p - origin)); }

template <int Dim>
std::uint32_t BoundaryFeatures<Dim>::add_segment(Vertex a, Vertex b) {
  // By coordinates: how points on it are rounded must not depend on the order of the input.
  if (complex_->point(b) < complex_->point(a)) std::swap(a, b);
  segments_.push_back({{a, b}});
  segment_patches_.emplace_back();
  return static_cast<std::uint32_t>(segments_.size() - 1);
}

template <int Dim>
void BoundaryFeatures<Dim>::add_patch(Patch patch) {
  const auto id = static_cast<std::uint32_t>(patches_.size());
  for (const std::uint32_t s : patch.segments) segment_patches_[s].push_back(id);
  for (const Vertex v : patch.corners) {
    if (v.index() >= corner_patches_.size()) corner_patches_.resize(complex_->num_vertices());
    corner_patches_[v.index()].push_back(id);
  }
  patches_.push_back(std::move(patch));
}

template <int Dim>
void BoundaryFeatures<Dim>::set_vertex(Vertex v, const BoundaryVertex& info) {
  if (v.index() >= vertices_.size()) vertices_.resize(complex_->num_vertices());
  vertices_[v.index()] = info;
}

template <int Dim>
void BoundaryFeatures<Dim>::set_corner(Vertex v) {
  set_vertex(v, {{Kind::corner, v.index()}});
}

template <int Dim>
void BoundaryFeatures<Dim>::forget_relaxed_radii() {
  for (BoundaryVertex& vertex : vertices_) vertex.relaxed2 = 0;
}

template <int Dim>
bool BoundaryFeatures<Dim>::is_on_segment(Vertex v, std::uint32_t segment) const {
  const Feature on = vertex(v).on;
  if (on.kind == Kind::segment) return on.id == segment;
  return on.kind == Kind::corner && has_corner({Kind::segment, segment}, v);
}

template <int Dim>
bool BoundaryFeatures<Dim>::is_on_patch(Vertex v, std::uint32_t patch) const {
  const Feature on = vertex(v).on;
  switch (on.kind) {
    case Kind::interior:
      return false;
    case Kind::corner:
      return has_corner({Kind::patch, patch}, v);
    case Kind::segment: {
      const auto& patches = segment_patches_[on.id];
      return std::find(patches.begin(), patches.end(), patch) != patches.end();
    }
    case Kind::patch:
      return on.id == patch;
  }
  return false;
}

template <int Dim>
double BoundaryFeatures<Dim>::position(Vertex v, std::uint32_t segment) const {
  if (vertex(v).on.kind == Kind::segment) return vertex(v).t;
  return v == segments_[segment].ends[0] ? 0 : 1;
}

template <int Dim>
Point<Dim> BoundaryFeatures<Dim>::point_at(std::uint32_t segment, double t) const {
  const Point<Dim>& a = complex_->point(segments_[segment].ends[0]);
  const Point<Dim>& b = complex_->point(segments_[segment].ends[1]);
  Point<Dim> x;
  for (std::size_t k = 0; k < Dim; ++k) x[k] = a[k] + t * (b[k] - a[k]);
  return on_grid<Dim>(x);
}

template <int Dim>
double BoundaryFeatures<Dim>::length(std::uint32_t segment) const {
  const auto& ends = segments_[segment].ends;
  return std::sqrt(squared_distance(complex_->point(ends[0]), complex_->point(ends[1])));
}

template <int Dim>
bool BoundaryFeatures<Dim>::has_corner(const Feature& feature, Vertex v) const {
  switch (feature.kind) {
    case Kind::interior:
      return false;
    case Kind::corner:
      return feature.id == v.index();
    case Kind::segment:
      return segments_[feature.id].ends[0] == v || segments_[feature.id].ends[1] == v;
    case Kind::patch:
      return std::binary_search(patches_[feature.id].corners.begin(), patches_[feature.id].corners.end(), v);
  }
  return false;
}

template <int Dim>
bool BoundaryFeatures<Dim>::is_sharp_at(std::uint32_t segment, Vertex end) const {
  constexpr double kCosine2 = 0.25;  // of 60 degrees
  const auto direction = [&](std::uint32_t s) {
    const auto& ends = segments_[s].ends;
    return complex_->point(ends[ends[0] == end ? 1 : 0]) - complex_->point(end);
  };
  const Point<Dim> along = direction(segment);
  const auto is_near = [&](std::uint32_t other) {
    if (other == segment || !has_corner({Kind::segment, other}, end)) return false;
    const Point<Dim> way = direction(other);
    const double product = dot(along, way);
    return product > 0 && product * product > kCosine2 * dot(along, along) * dot(way, way);
  };
  return std::any_of(
      segment_patches_[segment].begin(), segment_patches_[segment].end(), [&](std::uint32_t patch) {
        return std::any_of(patches_[patch].segments.begin(), patches_[patch].segments.end(), is_near);
      });
}

template <int Dim>
std::vector<std::uint32_t> BoundaryFeatures<Dim>::patches_at(Vertex v) const {
  const Feature on = vertex(v).on;
  switch (on.kind) {
    case Kind::interior:
      return {};
    case Kind::corner:
      return v.index() < corner_patches_.size() ? corner_patches_[v.index()] : std::vector<std::uint32_t>{};
    case Kind::segment:
      return segment_patches_[on.id];
    case Kind::patch:
      return {on.id};
  }
  return {};
}

template <int Dim>
double BoundaryFeatures<Dim>::distance2(const Point<Dim>& p, const Feature& feature) const {
  if (feature.kind == Kind::corner) return squared_distance(p, complex_->point(Vertex(feature.id)));
  const Point<Dim>& a = complex_->point(segments_[feature.id].ends[0]);
  const Point<Dim>& b = complex_->point(segments_[feature.id].ends[1]);
  const double t = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
  return squared_distance(p, point_at(feature.id, t));
}

// Corners and segments that both features have.
template <int Dim>
template <class Visit>
void BoundaryFeatures<Dim>::for_each_common(const Feature& f, const Feature& g, Visit&& visit) const {
  if (f.kind > g.kind) return for_each_common(g, f, visit);
  if (f.kind == Kind::segment) {
    for (const Vertex v : segments_[f.id].ends) {
      if (has_corner(g, v)) visit(Feature{Kind::corner, v.index()});
    }
    return;
  }
  const auto intersect = [](const auto& one, const auto& other, auto&& found) {
    const auto& small = one.size() < other.size() ? one : other;
    const auto& large = one.size() < other.size() ? other : one;
    for (const auto& x : small) {
      if (std::binary_search(large.begin(), large.end(), x)) found(x);
    }
  };
  const Patch& p = patches_[f.id];
  const Patch& q = patches_[g.id];
  intersect(p.segments, q.segments, [&](std::uint32_t s) { visit(Feature{Kind::segment, s}); });
  intersect(p.corners, q.corners, [&](Vertex v) { visit(Feature{Kind::corner, v.index()}); });
}

// The features that hold v and not the other vertex: what v lies on, and the patches around that.
template <int Dim>
std::vector<Feature> BoundaryFeatures<Dim>::features_without(Vertex v, Vertex other, Ends ends) const {
  std::vector<Feature> result;
  const Feature on = vertex(v).on;
  if (on.kind == Kind::corner && ends == Ends::no_corners) return result;
  if (on.kind == Kind::segment) result.push_back(on);
  for (const std::uint32_t patch : patches_at(v)) {
    if (!is_on_patch(other, patch)) result.push_back({Kind::patch, patch});
  }
  return result;
}

// Whether a segment sees a and b at less than 60 degrees from each other.
template <int Dim>
bool BoundaryFeatures<Dim>::is_acute(const Point<Dim>& a, const Point<Dim>& b, std::uint32_t segment) const {
  const Point<Dim>& u = complex_->point(segments_[segment].ends[0]);
  const Point<Dim> along = complex_->point(segments_[segment].ends[1]) - u;
  // Scalar products of the parts orthogonal to the segment.
  const auto across = [&](const Point<Dim>& p, const Point<Dim>& q) {
    return dot(p - u, q - u) - dot(p - u, along) * dot(q - u, along) / dot(along, along);
  };
  const double product = across(a, b);
  return product > 0 && 4 * product * product > across(a, a) * across(b, b);
}

// Where two features meet at an angle is the nearest place that they have in common; where that is a segment,
// and the angle acute, also the nearest corner, into which spirals run.
template <int Dim>
std::optional<Rung> BoundaryFeatures<Dim>::rung(Vertex p, Vertex q, double lambda, Ends ends) const {
  const Point<Dim>& a = complex_->point(p);
  const Point<Dim>& b = complex_->point(q);
  const double length2 = squared_distance(a, b);
  const auto is_short = [&](const std::optional<Rung>& rung) {
    return rung && length2 < lambda * lambda * rung->reach2;
  };
  const std::vector<Feature> of_q = features_without(q, p, ends);
  std::optional<Rung> result;
  for (const Feature& f : features_without(p, q, ends)) {
    for (const Feature& g : of_q) {
      if (f == g) continue;
      std::optional<Rung> corner;
      std::optional<Rung> nearest;
      for_each_common(f, g, [&](const Feature& common) {
        const Rung rung{f, g, common, std::min(distance2(a, common), distance2(b, common))};
        if (!nearest || rung.reach2 < nearest->reach2) nearest = rung;
        if (common.kind == Kind::corner && (!corner || rung.reach2 < corner->reach2)) corner = rung;
      });
      if (!is_short(nearest) && is_short(corner) && nearest->common.kind == Kind::segment &&
          is_acute(a, b, nearest->common.id)) {
        nearest = corner;
      }
      if (is_short(nearest) && (!result || nearest->reach2 < result->reach2)) result = nearest;
    }
  }
  return result;
}

template class BoundaryFeatures<2>;
template class BoundaryFeatures<3>;

}  // namespace sinkmesh
