// SPDX-License-Identifier: MIT
//
// From a surface to a refined mesh: the whole in one call, and the steps for callers that want to look in
// between.
#pragma once

#include <memory>

#include "core/triangulation.h"
#include "refine/domain.h"
#include "refine/improvement.h"
#include "refine/mesh.h"
#include "refine/options.h"
#include "refine/surface.h"

namespace sinkmesh {

/// The domain bounded by a surface: the Delaunay triangulation of its vertices, and the maximal stable
/// subcomplex of what lies inside. Movable, not copyable.
template <int Dim>
class SurfaceMesher {
 public:
  /// Triangulates the vertices used by the facets. Requires a surface for which check_surface() finds no error.
  /// @throws InputError, DegenerateInput, CapacityError as Triangulation does.
  explicit SurfaceMesher(const Surface<Dim>& surface);
  SurfaceMesher(SurfaceMesher&&) noexcept;
  SurfaceMesher& operator=(SurfaceMesher&&) noexcept;
  ~SurfaceMesher();

  /// Finds what the surface bounds, after dividing facets until all are Delaunay and stable (boundary mode
  /// `refine`), or after peeling to the maximal stable subcomplex (`fixed`). Call it once.
  /// @param options  boundary, and the budgets; conforming obeys them, too.
  /// @return what was done; unless ok() there is no domain.
  /// @throws FacetError with mode `fixed` if facets of the surface are no facets of the triangulation (how
  ///         many, and the first); with any mode if the surface crosses itself, or two facets meet at less than
  ///         a thousandth of a degree. InputError if it bounds nothing, or in mode `fixed` nothing stable.
  BoundaryResult find_domain(const RefineOptions& options = {});

  /// Inserts Steiner points until no simplex of the domain has r/l above options.max_ratio, or none can be
  /// inserted; see Refiner. Can be called again, with other options.
  RefineResult refine(const RefineOptions& options);

  /// After refine(): takes points away and moves others, as far as the options ask for it; obeys the budgets.
  /// Lets neither the number of simplices of low quality nor the largest r/l grow; keeps the boundary and all
  /// vertices on it, the Delaunay property, stability, and the shortest edge. Can be called again.
  /// @throws InputError as refine() does.
  Improvement improve(const RefineOptions& options);

  /// After refine(), or improve(): each simplex of low quality that remains, the worst ratio first. Linear.
  std::vector<Leftover<Dim>> leftovers() const;
  /// After improve() with options.slivers: each simplex with an angle below options.min_dihedral, the smallest
  /// first. Linear.
  std::vector<Sliver<Dim>> slivers() const;

  /// Points of the surface that belong to no facet: they are left out, for a loose vertex inside of
  /// circumspheres would contradict that the mesh is Delaunay.
  std::size_t num_unused_points() const;

  /// Of the domain as it is now. Linear.
  QualityStatistics statistics(double max_ratio) const;
  AngleCensus angle_census() const;
  /// Vertices of the domain as it is now.
  std::size_t num_vertices() const;
  /// Of the simplices of the domain, by their coordinates in the units of the input: equal for equal meshes,
  /// whatever the numbering.
  std::uint64_t hash() const;
  /// The domain as plain arrays, in the units of the input. The points of the surface come first, in their
  /// order but without the unused ones; then the Steiner points. Fields: of simplices their "region", counted
  /// from 1, and its "tag" if the surface has region seeds; of boundary facets the "parent", the facet of the
  /// surface of which they are a part, and its "tag" if facets have tags.
  Mesh<Dim> mesh() const;

  const Triangulation<Dim>& triangulation() const;
  const Domain<Dim>& domain() const;
  /// Bytes held by the complex and its annotations.
  std::size_t bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};
using SurfaceMesher2 = SurfaceMesher<2>;
using SurfaceMesher3 = SurfaceMesher<3>;

/// The solid simplices of a triangulation as plain arrays, in the units of the input; the boundary is its hull.
template <int Dim>
Mesh<Dim> hull_mesh(const Triangulation<Dim>& triangulation);

/// All of it: checks the surface, finds the domain, refines, improves, and returns the mesh.
/// @throws InputError with the first defect of the surface; see also SurfaceMesher.
template <int Dim>
Mesh<Dim> refine(const Surface<Dim>& surface, const RefineOptions& options = {});

}  // namespace sinkmesh
