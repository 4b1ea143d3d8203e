// SPDX-License-Identifier: MIT
//
// The boundary as a complex of its own, beside the triangulation that shall hold it [BR, 2, 3].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/star_walk.h"
#include "core/triangulation.h"
#include "refine/boundary_features.h"
#include "refine/domain.h"
#include "refine/options.h"
#include "refine/sub_facets.h"

namespace sinkmesh {

/// A part of a segment.
struct SubSegment {
  Vertex u;
  Vertex v;
  std::uint32_t segment;
};

/// Features and sub-facets of a surface. Keeps with each sub-facet where it is in the triangulation, and a wall
/// of the domain there; follows insertions.
///
/// Invariants:
///   B1  The sub-facets of a patch are a triangulation of its polygon, in projection, up to the rounding of
///       points on segments; those of a segment in the plane are a path from end to end.
///   B2  A sub-facet that is a facet of the triangulation has a wall there, on both sides; nothing else has.
template <int Dim>
class Boundary {
 public:
  using Facet = std::array<Vertex, Dim>;

  /// @param facets  of the surface; their vertices are the first of the triangulation.
  /// @param found   for each facet one half-facet of the triangulation, or null; see Domain::find().
  /// @param tags    one per facet, or none.
  /// @param flat    see BoundaryOptions; a gated distance here.
  /// Cost: linear in the complex, log-linear in the surface.
  Boundary(const Triangulation<Dim>& triangulation, Domain<Dim>& domain, std::span<const Facet> facets,
           std::span<const HalfFacet> found, std::span<const std::int64_t> tags, double flat);

  const BoundaryFeatures<Dim>& features() const { return features_; }
  const SubFacets<Dim>& sub_facets() const { return sub_facets_; }
  StarWalk<Dim>& star_walk() { return star_walk_; }
  const Triangulation<Dim>& triangulation() const { return *triangulation_; }

  bool is_missing(SubFacet f) const { return sub_facets_[f].at.is_null(); }
  /// The sub-facet of a wall.
  SubFacet at(HalfFacet wall) const { return sub_facets_.find(complex().facet(wall)); }
  FacetCorners<Dim> corner_points(SubFacet f) const;
  /// The apexes of a sub-facet, those that are not at infinity, that lie strictly inside its diametral sphere.
  std::vector<Vertex> encroaching_apexes(SubFacet f) const;
  /// Whether uv is an edge of the triangulation.
  bool has_edge(Vertex u, Vertex v);
  /// The sides of a sub-facet that are parts of segments; in the plane the sub-facet itself.
  std::vector<SubSegment> sub_segments(SubFacet f) const;

  /// The walls of all sub-facets; for Domain::label(). Requires that none is missing.
  std::vector<typename Domain<Dim>::Wall> walls() const;

  /// As the user knows it.
  BoundaryFeature describe(const Feature& feature) const;

  // -- following an insertion

  /// Before the prestar is replaced: what is in its closure.
  void before_insertion(const Cavity<Dim>& cavity);
  /// After: the walls of the new simplices, and which sub-facets are still there.
  /// @return the sub-facets in the closure of the prestar, present and missing.
  const std::vector<SubFacet>& after_insertion(const Cavity<Dim>& cavity);
  /// After an insertion that crossed no wall: the simplex on the other side of this one is new.
  void refresh(HalfFacet wall) { sub_facets_.set_at(at(wall), wall); }
  void set_vertex(Vertex v, const BoundaryVertex& info) { features_.set_vertex(v, info); }
  void forget_relaxed_radii() { features_.forget_relaxed_radii(); }

  /// What is needed to come back to this state after the triangulation has been built anew from its vertices of
  /// now.
  struct Snapshot {
    BoundaryFeatures<Dim> features;
    SubFacets<Dim> sub_facets;
    std::size_t num_vertices;
  };
  Snapshot snapshot() const { return {features_, sub_facets_, complex().num_vertices()}; }
  /// Looks for all sub-facets, and puts up their walls.
  void restore(const Snapshot& snapshot);

  // -- editing

  /// Looks for it in the triangulation, too.
  SubFacet add(const typename SubFacets<Dim>::Record& record);
  void remove(SubFacet f);
  /// Divides every sub-facet at the edge uv (in the plane: uv itself) at x, into two that keep its segment
  /// along the edge. They are appended to `created`.
  void divide_edge(Vertex u, Vertex v, Vertex x, std::vector<SubFacet>& created);

 private:
  const Complex<Dim>& complex() const { return triangulation_->complex(); }
  void place(SubFacet f, HalfFacet at);
  typename SubFacets<Dim>::Record canonical(typename SubFacets<Dim>::Record record) const;

  const Triangulation<Dim>* triangulation_;
  Domain<Dim>* domain_;
  BoundaryFeatures<Dim> features_;
  SubFacets<Dim> sub_facets_;
  StarWalk<Dim> star_walk_;
  std::vector<SubFacet> touched_;
};

extern template class Boundary<2>;
extern template class Boundary<3>;

}  // namespace sinkmesh
