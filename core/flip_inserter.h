// SPDX-License-Identifier: MIT
//
// Insertion by flips [EG01, 4.3; PS, 3].
#pragma once

#include "core/complex.h"
#include "core/location.h"
#include "predicates/staged.h"

namespace sinkmesh {

/// Inserts one vertex after the other by subdividing the simplex that holds it and flipping until all is
/// Delaunay. Holds working memory only; keep one and reuse it.
template <int Dim>
class FlipInserter {
 public:
  /// Inserts v, whose coordinates are in the complex already, at the place where walk_to() found it.
  /// Requires a Delaunay triangulation, and that v is at no corner.
  /// @throws CapacityError, std::bad_alloc before anything is changed.
  void insert(Complex<Dim>& complex, const Predicates<Dim>& predicates, const Location<Dim>& at, Vertex v);
};

}  // namespace sinkmesh
