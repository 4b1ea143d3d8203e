// SPDX-License-Identifier: MIT
//
// Makes a triangulation hold a surface, and keeps it so: boundary refinement [BR, 4, 5].
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <vector>

#include "core/triangulation.h"
#include "refine/boundary.h"
#include "refine/collars.h"
#include "refine/domain.h"
#include "refine/flow.h"
#include "refine/patch_triangulation.h"

namespace sinkmesh {

/// Inserts points on the boundary until every sub-facet is a facet of the triangulation and Gabriel: no apex,
/// on either side, strictly inside its diametral sphere. Then no flow crosses the boundary, in or out, and the
/// prestar of a point outside all these spheres does not cross it either [BR, 12, Lemma 4].
///
/// Why it ends: no point is inserted nearer to a vertex than the floor, so there are finitely many. Sub-facets
/// that could only be mended by a nearer one are left, and reported. Nothing better is proven for surfaces with
/// angles below 70.5 degrees [BR, 9]; shells, mirror images and sphere points keep the floor out of sight, and
/// where they do not, a new start with collars.
template <int Dim>
class Conformer {
 public:
  /// @param lambda  edges shorter than this times their distance from the place where two features meet are
  ///                rungs.
  /// @param floor   no two vertices get closer; gated.
  /// @param collars  see there; outlives this.
  /// @param projects  whether a missing sub-segment is divided where its culprit is nearest. That needs fewer
  ///                points in most models, and too many in some, where middles line up by themselves.
  Conformer(Triangulation<Dim>& triangulation, Domain<Dim>& domain, Flow<Dim>& flow, Boundary<Dim>& boundary,
            const Collars& collars, double lambda, double floor, bool projects);

  double lambda() const { return lambda_; }
  /// For the points to come.
  void set_lambda(double lambda) { lambda_ = lambda; }

  /// Flips the input, queues what is not conforming, and divides segments where they leave collars.
  void start();
  /// Works until the queues are empty, or a sub-facet has to be given up, because a point would come nearer to
  /// a vertex than the floor: where that happens, points breed points, and going on would only make more of
  /// them.
  /// @param may_continue  asked before each point.
  /// @return false if it said no, or a sub-facet was given up.
  bool conform(const std::function<bool()>& may_continue);
  /// The sub-facets that have been given up.
  const std::vector<SubFacet>& unconformed() const { return given_up_; }

  /// Puts a point near the center of a sub-facet, on it or on a sub-segment that is in the way.
  /// @param distance2  the least squared distance of the point from all vertices
  /// @return whether a point was inserted; then call conform() and label_new().
  bool split(SubFacet f, double distance2) { return split_at_center(f, {}, distance2); }

  /// Remembers the regions on both sides of all patches and segments; after Domain::label().
  void remember_regions();
  /// Gives regions to the simplices that are new since the last call: from neighbours that have one, from the
  /// patches and segments at them, and from ghosts. Requires a conforming surface.
  /// @return those that are inside.
  std::vector<Simplex> label_new();
  /// Called for each inside simplex that is about to be replaced; may be empty.
  std::function<void(Simplex)> on_removal;

  /// Whether all vertices of a simplex lie on one patch: it is flat, but for rounding.
  bool is_on_one_patch(Simplex s) const;
  /// Moves a flat inside simplex out, by taking its two other facets for the two sub-facets that it has; where
  /// that would not be conforming, or its sub-facets are not two, divides one of them [BR, 8].
  /// @return whether the mesh has changed; then call conform() and label_new().
  bool expel(Simplex s);

  std::size_t points_on_segments() const { return points_on_segments_; }
  std::size_t points_on_patches() const { return points_on_patches_; }

 private:
  struct Entry {
    double radius2;
    std::uint64_t tie;
    SubFacet facet;
    std::uint32_t birth;
    bool operator<(const Entry& other) const {
      return radius2 != other.radius2 ? radius2 < other.radius2 : tie < other.tie;
    }
  };
  struct SegmentEntry {
    double length2;
    std::uint64_t tie;
    SubSegment segment;
    bool operator<(const SegmentEntry& other) const {
      return length2 != other.length2 ? length2 < other.length2 : tie < other.tie;
    }
  };

  const Complex<Dim>& complex() const { return triangulation_->complex(); }
  SegmentEntry entry_of(const SubSegment& s) const;
  Entry entry_of(SubFacet f) const;
  void enqueue(SubFacet f);
  void enqueue_created();
  void mend(const SubSegment& sub_segment);
  void mend(SubFacet f);
  Vertex culprit(SubFacet f);
  bool split_segment(const SubSegment& sub_segment, Vertex culprit, double distance2);
  bool insert_on_segment(const SubSegment& sub_segment, double t, Vertex culprit, double distance2);
  void divide_at_collars();
  std::optional<Vertex> collared_corner(SubFacet f) const;
  bool is_inside_collar(std::uint32_t patch, const Point<Dim>& x) const;
  Point<Dim> point_on_arc(SubFacet f, Vertex corner) const;
  bool split_arc(SubFacet f, Vertex corner, Vertex culprit, double distance2);
  double split_position(const SubSegment& sub_segment, Vertex culprit) const;
  bool comes_from(Vertex v, Vertex corner) const;
  bool split_at_center(SubFacet f, Vertex culprit, double distance2);
  bool insert_alike(SubFacet f, Vertex culprit);
  bool insert_on_patch(const PatchTriangulation::Location& at, const Point<Dim>& x, Vertex culprit,
                       double distance2);
  std::vector<SubFacet> destroyed_by(const PatchTriangulation::Location& at, const Point<Dim>& x) const;
  double distance2_of_segments(const PatchTriangulation::Location& at, const Point<Dim>& x) const;
  void sort_by_size(std::vector<SubFacet>& facets) const;
  std::optional<SubSegment> encroached_segment(const std::vector<SubFacet>& destroyed,
                                               const Point<Dim>& x) const;
  std::optional<Point<Dim>> mirror_image(SubFacet f, Vertex q) const;
  std::optional<Point<Dim>> sphere_point(SubFacet f, Vertex q) const;
  Vertex insert(const Point<Dim>& x, Simplex hint, double distance2);
  void settle(Vertex v, const Feature& on, double t, Vertex culprit);
  std::size_t side_of(SubFacet f, HalfFacet h) const;

  Triangulation<Dim>* triangulation_;
  Domain<Dim>* domain_;
  Flow<Dim>* flow_;
  Boundary<Dim>* boundary_;
  const Collars* collars_;
  double lambda_;
  double floor2_;
  bool projects_;

  Cavity<Dim> cavity_;
  double nearest2_ = 0;  // squared distance of the last point from its nearest vertex
  std::priority_queue<SegmentEntry> segment_queue_;
  std::priority_queue<Entry> facet_queue_;
  std::vector<SubFacet> given_up_;
  std::vector<SubFacet> created_;
  std::vector<Simplex> fresh_;
  std::vector<std::array<typename Domain<Dim>::Region, 2>> regions_;  // by owner of sub-facets
  std::size_t points_on_segments_ = 0;
  std::size_t points_on_patches_ = 0;
};

extern template class Conformer<2>;
extern template class Conformer<3>;

}  // namespace sinkmesh
