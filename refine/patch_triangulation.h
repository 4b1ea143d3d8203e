// SPDX-License-Identifier: MIT
//
// The sub-facets of a patch as a triangulation in its plane: division, flips, walks [BR, 3].
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "refine/boundary.h"

namespace sinkmesh {

/// Edits the sub-facets of a surface in space so that those of each patch stay Delaunay in its plane. All signs
/// are those of exact projections to a coordinate plane. Sub-facets that are made are appended to `created`;
/// some of them may be gone again at the return.
class PatchTriangulation {
 public:
  explicit PatchTriangulation(Boundary<3>& boundary) : boundary_(&boundary) {}

  /// Divides a sub-segment, and the sub-facets at it, at x.
  void divide(const SubSegment& sub_segment, Vertex x, std::vector<SubFacet>& created);
  /// Divides a sub-facet at x, a point in its interior (k = 3), or the two at its side opposite corner k.
  void divide(SubFacet f, std::size_t k, Vertex x, std::vector<SubFacet>& created);

  /// Lawson's flips, from all sides of f: an edge within a patch gives way to the other diagonal if a diametral
  /// sphere of its sub-facets holds the apex of the other one and that is better the other way. If both ways
  /// are good, or both bad, the one that is in the triangulation stays.
  /// @return whether there was any.
  bool flip_around(SubFacet f, std::vector<SubFacet>& created) { return flip_from({f}, created); }
  /// From all sub-facets.
  void flip_all();
  /// Takes the other diagonal of the two sub-facets at a side of f.
  /// @return false if they are not in one patch, or not strictly convex in projection, or if three points of
  ///         one segment would become a sub-facet.
  bool flip(SubFacet f, std::size_t k, std::vector<SubFacet>& created);

  /// Where a walk ended.
  struct Location {
    SubFacet facet;
    /// 3: the point is in the interior of the sub-facet; else on its side opposite this corner.
    std::size_t side = 3;
    /// The sub-segment that bars the way, or on which the point is.
    std::optional<SubSegment> barrier;
  };
  /// Walks from f towards a point in projection. Empty if the walk goes astray, in a patch that rounding has
  /// folded, or if the point is a corner.
  std::optional<Location> walk(SubFacet f, const Point2& x) const;

 private:
  struct Diagonal;

  Point2 projected(SubFacet f, Vertex v) const;
  std::optional<Diagonal> diagonal(SubFacet f, std::size_t k) const;
  bool should_flip(const Diagonal& diagonal);
  void exchange(const Diagonal& diagonal, std::vector<SubFacet>& created);
  bool flip_from(std::vector<SubFacet> stack, std::vector<SubFacet>& created);

  const Complex<3>& complex() const { return boundary_->triangulation().complex(); }

  Boundary<3>* boundary_;
};

}  // namespace sinkmesh
