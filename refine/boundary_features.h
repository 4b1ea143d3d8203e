// SPDX-License-Identifier: MIT
//
// Corners, segments and patches: the parts of the boundary, what lies on them, and where they meet [BR, 2].
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/complex.h"

namespace sinkmesh {

/// A part of the boundary. Corners are numbered as their vertices, segments and patches from 0.
struct Feature {
  enum class Kind : std::uint8_t { interior, corner, segment, patch };
  Kind kind = Kind::interior;
  std::uint32_t id = 0;

  friend auto operator<=>(const Feature&, const Feature&) = default;
};

/// What is known of a vertex of the boundary.
struct BoundaryVertex {
  Feature on;               ///< the smallest feature that holds it
  double t = 0;             ///< on a segment: from 0 at its first end to 1 at its last
  std::uint32_t level = 0;  ///< 0 for corners; else one more than that of its culprit, if it has one
  double relaxed2 = 0;      ///< squared relaxed radius [BR, 6]
  Vertex culprit = {};      ///< from which it was inherited, or null
};

/// An edge that is short only because two features meet at a small angle.
struct Rung {
  Feature first;
  Feature second;
  Feature common;
  double reach2;  ///< squared distance of the nearer end from the common feature
};

/// The plane of a patch. Projection drops one coordinate, and turns the normal towards the viewer.
struct Plane {
  Point3 origin{};
  Point3 normal{};  ///< of length 1, up to rounding
  std::array<std::uint8_t, 2> kept{};
  std::uint8_t dropped = 0;

  /// Of the facet abc, which is counterclockwise in the projection, exactly. Requires gated points that are not
  /// collinear.
  static Plane through(const Point3& a, const Point3& b, const Point3& c);

  Point2 project(const Point3& p) const { return {p[kept[0]], p[kept[1]]}; }
  /// The point of the plane with the same projection. Rounded: within 2^-52 of the largest coordinate.
  Point3 lift(const Point2& p) const;
  double distance(const Point3& p) const;
};

/// The features of a surface whose points are the first vertices of a complex, and the places of all vertices
/// on them. In the plane there are no patches.
template <int Dim>
class BoundaryFeatures {
 public:
  struct Segment {
    std::array<Vertex, 2> ends;  ///< ordered by coordinates
  };
  struct Patch {
    std::uint32_t facet = 0;  ///< of the surface, its largest
    Plane plane;
    std::vector<std::uint32_t> segments = {};  ///< around it, increasing
    std::vector<Vertex> corners = {};          ///< on it, increasing
    bool is_joined = false;                    ///< of several facets
  };

  explicit BoundaryFeatures(const Complex<Dim>& complex) : complex_(&complex) {}

  std::uint32_t add_segment(Vertex a, Vertex b);
  /// After its segments.
  void add_patch(Patch patch);
  void set_corner(Vertex v);
  void set_vertex(Vertex v, const BoundaryVertex& info);

  /// Sets all relaxed radii to 0.
  void forget_relaxed_radii();

  const std::vector<Segment>& segments() const { return segments_; }
  const std::vector<Patch>& patches() const { return patches_; }
  /// Of an inner vertex: `interior`, and zeros.
  const BoundaryVertex& vertex(Vertex v) const {
    return v.index() < vertices_.size() ? vertices_[v.index()] : interior_;
  }
  bool is_on_boundary(Vertex v) const { return vertex(v).on.kind != Feature::Kind::interior; }

  /// Whether v lies on the closed segment or patch, by the places that are stored, not by coordinates: rounded
  /// points of one segment are not collinear.
  bool is_on_segment(Vertex v, std::uint32_t segment) const;
  bool is_on_patch(Vertex v, std::uint32_t patch) const;
  /// The position of a vertex of the closed segment on it.
  double position(Vertex v, std::uint32_t segment) const;
  /// From the input ends, each coordinate rounded once: errors do not add up when pieces are divided again.
  Point<Dim> point_at(std::uint32_t segment, double t) const;
  double length(std::uint32_t segment) const;
  /// Whether a feature has v as a corner of its own.
  bool has_corner(const Feature& feature, Vertex v) const;
  /// Whether a patch at the segment has an angle below 60 degrees at that end of it.
  bool is_sharp_at(std::uint32_t segment, Vertex end) const;
  /// The patches that hold v.
  std::vector<std::uint32_t> patches_at(Vertex v) const;
  const std::vector<std::uint32_t>& patches_at_segment(std::uint32_t segment) const {
    return segment_patches_[segment];
  }
  /// Squared distance of a point from a corner or a segment.
  double distance2(const Point<Dim>& p, const Feature& feature) const;

  /// Whether the edge pq is a rung: p and q lie on two closed features, none of which holds both, that share a
  /// corner or a segment, and |pq| < lambda min(d(p,X), d(q,X)) for the nearest such X. If X is a segment, and
  /// the angle there is below 60 degrees, the nearest common corner may take its place.
  /// @param ends  a corner, which is given, excuses nothing, but can be part of the reason for what is there.
  enum class Ends : std::uint8_t { no_corners, any };
  std::optional<Rung> rung(Vertex p, Vertex q, double lambda, Ends ends = Ends::no_corners) const;

 private:
  std::vector<Feature> features_without(Vertex v, Vertex other, Ends ends) const;
  bool is_acute(const Point<Dim>& a, const Point<Dim>& b, std::uint32_t segment) const;
  template <class Visit>
  void for_each_common(const Feature& f, const Feature& g, Visit&& visit) const;

  const Complex<Dim>* complex_;
  std::vector<Segment> segments_;
  std::vector<std::vector<std::uint32_t>> segment_patches_;
  std::vector<Patch> patches_;
  std::vector<BoundaryVertex> vertices_;  // by id
  std::vector<std::vector<std::uint32_t>> corner_patches_;
  BoundaryVertex interior_;
};

}  // namespace sinkmesh
