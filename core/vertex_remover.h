// SPDX-License-Identifier: MIT
//
// Removal of a vertex: the inverse of insertion, D = (D_x - St x) + Pt x [EG01, 4.1].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/cavity.h"
#include "core/complex.h"
#include "core/retriangulator.h"
#include "core/star_linker.h"
#include "core/star_walk.h"

namespace sinkmesh {

/// Replaces stars of vertices by prestars. Holds working memory only; keep one and reuse it.
///
/// The star of x is the same in the Delaunay complex of all vertices and in that of its link's vertices and x
/// alone: its cell in the Voronoi diagram is cut out by its neighbours, the vertices of the link; and the
/// perturbation depends on the points only [PS, 2]. So the simplices that the insertion of x into the Delaunay
/// complex of the link's vertices would replace fill the hole, and they are those that the Delaunay complex
/// without x has there. The same holds with any other vertices besides those of the link.
template <int Dim>
class VertexRemover {
 public:
  /// @param v  is a vertex in a Delaunay complex; afterwards it keeps its id and is in no simplex.
  /// @return false if the other vertices lie in one hyperplane: nothing has changed.
  /// @throws CapacityError, std::bad_alloc before anything is changed.
  /// Cost: that of inserting the vertices of the link into an empty complex; n log n for n of them, if they are
  ///       not in special position.
  bool remove(Complex<Dim>& complex, const Predicates<Dim>& predicates, Vertex v);
  /// Finds out what remove() would put in, and changes nothing. The same result, exceptions and cost.
  bool plan(const Complex<Dim>& complex, const Predicates<Dim>& predicates, Vertex v);
  /// The corners of the simplices that the last plan, or removal, has found, ghosts included.
  std::span<const typename Retriangulator<Dim>::Corners> planned() const { return fresh_; }
  /// The simplices that the last removal has put in, ghosts included.
  const std::vector<Simplex>& created() const { return retriangulator_.created(); }

 private:
  void collect_star(const Complex<Dim>& complex, Vertex v);
  void collect_link(const Complex<Dim>& complex, Vertex v);
  bool add_witness(const Complex<Dim>& complex, Vertex v);
  bool triangulate_link(const Complex<Dim>& complex, const Predicates<Dim>& predicates);
  void find_prestar(const Predicates<Dim>& predicates, const Point<Dim>& x);

  StarWalk<Dim> walk_;
  Retriangulator<Dim> retriangulator_;
  std::vector<Simplex> star_;
  std::vector<Vertex> link_;          // finite vertices, increasing
  std::vector<Point<Dim>> points_;    // theirs
  std::vector<std::uint32_t> order_;  // of link_, in which they are in small_
  Complex<Dim> small_;                // the Delaunay complex of the link's vertices
  Cavity<Dim> cavity_;
  StarLinker<Dim> linker_;
  std::vector<typename Retriangulator<Dim>::Corners> fresh_;
};

extern template class VertexRemover<2>;
extern template class VertexRemover<3>;

}  // namespace sinkmesh
