// SPDX-License-Identifier: MIT
//
// What must hold of a mesh, from its arrays alone: by definitions, in rationals where signs matter.
#pragma once

#include <vector>

#include "refine/mesh.h"
#include "refine/options.h"
#include "refine/surface.h"
#include "test/stress/suite.h"

namespace sinkmesh::stress {

/// What the checks know about the run that made a mesh.
struct Promise {
  RefineOptions options;
  BoundaryResult boundary;
  RefineResult result;
  bool is_improved = false;  ///< points have been moved since
  bool has_normals = true;   ///< the surface has, outward and into cavities, if it is consistent at all

  bool is_divided() const { return boundary.mode == BoundaryMode::refine; }
  bool is_done() const { return result.stop == Stop::no_candidate; }
  bool is_whole() const { return is_divided() || boundary.peeled_simplices == 0; }
};

/// Positive volumes, face to face, Delaunay, stable; the surface is there, with all its vertices, parents and
/// tags; regions end at it; its volume. In a boundary that is divided all facets are Gabriel.
/// @throws CheckFailed
template <int Dim>
void expect_sound(const Surface<Dim>& surface, const Mesh<Dim>& mesh, const Promise& promise,
                  Counters& counters);

/// No two vertices nearer than what the run says it kept, unless two of the input are.
/// @throws CheckFailed
template <int Dim>
void expect_separated(const Surface<Dim>& surface, const Mesh<Dim>& mesh, double separation);

/// What moving points and taking them away promises: the same boundary with the same parents, not more
/// simplices, not more of low quality, no larger r/l and no shorter edge.
/// @throws CheckFailed
template <int Dim>
void expect_no_worse(const Mesh<Dim>& before, const Mesh<Dim>& after, double max_ratio);

/// The simplices of low quality are those listed, each with a reason that is one.
/// @throws CheckFailed
template <int Dim>
void expect_leftovers(const Mesh<Dim>& mesh, const std::vector<Leftover<Dim>>& leftovers,
                      const Promise& promise, Counters& counters);

/// Of a finished run with a boundary that is divided: the way to no circumcenter leaves the mesh.
/// @throws CheckFailed
template <int Dim>
void expect_centers_inside(const Mesh<Dim>& mesh);

}  // namespace sinkmesh::stress
