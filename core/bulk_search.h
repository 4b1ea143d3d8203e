// SPDX-License-Identifier: MIT
//
// For bulk loading: a simplex in conflict with the next point, from where the last one was inserted.
#pragma once

#include "core/cavity.h"
#include "core/complex.h"

namespace sinkmesh {

/// Finds conflicts for points that come one after the other along a curve. What it finds does not decide what
/// the triangulation is, only how long the way is [SN, 3.2]:
/// - On most input the last star is next to the next point.
/// - On surface-like input stars reach across the whole solid, and a walk from a far-reaching simplex is long;
///   the simplex of smallest reach stays near the surface, where the next point is.
/// - If the surface is convex, a point lies beyond the hull of those before, and the way over the hull is the
///   shortest; inside, all those that reach across would have to be crossed.
/// Looking at a star costs time, so it is done only after a long walk, or a way over the hull.
template <int Dim>
class BulkSearch {
 public:
  /// A simplex in conflict with p, which is no vertex.
  Simplex find(const Complex<Dim>& complex, const Predicates<Dim>& predicates, const Point<Dim>& p);
  /// Chooses where to start for the next point. Call it after each insertion.
  /// @param cavity  of the point v, which has been inserted.
  void settle(const Complex<Dim>& complex, const Cavity<Dim>& cavity, Vertex v);
  /// Simplices visited inside by the last find(); 0 if the conflict was found over the hull.
  int last_walk() const { return steps_; }

 private:
  bool find_over_hull(const Complex<Dim>& complex, const Predicates<Dim>& predicates, const Point<Dim>& p);

  Simplex at_{0};
  int steps_ = 0;              // see last_walk()
  int trust_in_the_hull_ = 0;  // grows with each way over the hull that leads to a conflict, falls with others
};

extern template class BulkSearch<2>;
extern template class BulkSearch<3>;

}  // namespace sinkmesh
