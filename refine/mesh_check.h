// SPDX-License-Identifier: MIT
//
// Whether a mesh, from whatever source, is what it claims to be: exact signs, no complex needed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "refine/mesh.h"
#include "refine/quality.h"

namespace sinkmesh {

/// Something that a face-to-face mesh must not have.
struct MeshDefect {
  enum class Kind : std::uint8_t {
    not_finite,       ///< a coordinate is infinite or not a number
    bad_corner,       ///< a corner is no vertex of the mesh, or the same vertex twice
    flat,             ///< volume exactly zero
    inverted,         ///< volume negative
    duplicate_point,  ///< two vertices at the same place, both used
    crowded_facet,    ///< a facet of more than two simplices
    same_side,        ///< two simplices on the same side of the facet that they share
    overlap,          ///< a simplex reaches into a part of the mesh that it is not connected with
  };

  Kind kind;
  /// The ids involved, counted from 0, and coordinates.
  std::string message;
};

/// A few words for a kind of defect.
const char* name(MeshDefect::Kind kind);

/// What check_mesh() found.
template <int Dim>
struct MeshCheck {
  explicit MeshCheck(double max_ratio) : quality(max_ratio) {}

  /// All of them, by kind and then by id.
  std::vector<MeshDefect> defects;
  bool ok() const { return defects.empty(); }

  std::size_t vertices = 0;         ///< corners of simplices
  std::size_t unused_points = 0;    ///< the others
  std::size_t boundary_facets = 0;  ///< facets of one simplex
  std::size_t interior_facets = 0;  ///< facets of two
  std::size_t components = 0;       ///< connected through facets
  std::size_t rounded_points = 0;   ///< by the input gate, before any sign was taken
  /// Of the simplices that are not flat.
  QualityStatistics quality;
  /// Of the same. Inner vertices are those of no boundary facet.
  AngleCensus angles;

  // -- the rest is known for a mesh without defects only

  /// Interior facets with the apex of one simplex strictly inside the circumsphere of the other.
  std::size_t facets_not_delaunay = 0;
  /// Interior facets whose simplices have the same circumsphere.
  std::size_t cospherical_facets = 0;
  /// Simplices with a vertex of the mesh strictly inside their circumspheres, and the first of them.
  std::size_t simplices_not_delaunay = 0;
  std::size_t first_not_delaunay = 0;
  /// Simplices that contain their circumcenters, ties resolved as in the flow relation [EG01, 3.3].
  std::size_t sinks = 0;
  /// Boundary facets beyond which the circumcenter of their simplex lies, strictly; without any, the mesh is a
  /// stable subcomplex if it is Delaunay [EG01, 5.1].
  std::size_t unstable_facets = 0;

  bool is_delaunay() const { return ok() && simplices_not_delaunay == 0; }
};

/// Checks a mesh exactly: positive volumes, face-to-face, parts apart from each other, Delaunay. What is taken
/// for granted is that the boundary of one facet-connected part does not cross itself; check_surface() of it
/// tells.
///
/// "Delaunay" is meant in the set of the vertices of the mesh, also across its boundary: an empty circumsphere
/// for each simplex, ties allowed. The triangulation of the vertices decides it: a simplex that is not in it
/// may still be one of several ways to divide cospherical points, and then no neighbor of its corners is
/// strictly inside.
///
/// @throws InputError if coordinates are too small for exact signs (input_gate.h).
/// Cost: sorting the facets, and one Delaunay triangulation of the vertices.
template <int Dim>
MeshCheck<Dim> check_mesh(const Mesh<Dim>& mesh, double max_ratio = 2.0);

}  // namespace sinkmesh
