// SPDX-License-Identifier: MIT
//
// Insertion by star substitution: D_x = (D - Pt x) + St x [EG01, 4.1].
#pragma once

#include <array>
#include <cstdint>

#include "core/cavity.h"

namespace sinkmesh {

/// Replaces prestars by stars. Holds working memory only; keep one and reuse it.
template <int Dim>
class StarLinker {
 public:
  /// Replaces the prestar in `cavity` by the star of v: one simplex on each facet of its boundary. v is corner
  /// 0 of all of them (in the plane, corner 1 of one of two ghosts, since infinity must be last). The slots of
  /// the prestar are used again, in its order; cavity.star(i) tells which simplex stands on cavity.facet(i).
  ///
  /// Cost: linear in the number of facets, without a hash [SN, 3.1]: each side facet of the star is written
  /// once into a table, at the place of its ridge as one of its two simplices sees it, and read once from the
  /// place as the other sees it. Stars with more than 255 vertices are linked by sorting.
  /// @throws CapacityError, std::bad_alloc; the prestar is then released and the complex as before.
  void substitute(Complex<Dim>& complex, Cavity<Dim>& cavity, Vertex v);

 private:
  static constexpr std::uint32_t kCorners = Complex<Dim>::kCorners;

  /// What is known of a simplex of the star before its slot, which may still hold one of the prestar, is
  /// written.
  struct Planned {
    std::array<std::uint32_t, Dim> corner;  // the facet, counterclockwise seen from outside the prestar
    std::array<std::uint32_t, Dim> local;   // numbers of these vertices within the star
    std::uint32_t outer;
    std::uint32_t slot;
  };
  /// A side facet of the star under the sorted slots of its ridge.
  struct Side {
    std::uint64_t ridge;
    std::uint32_t half_facet;
  };

  void make_room(Complex<Dim>& complex, Cavity<Dim>& cavity);
  void plan(Complex<Dim>& complex, Cavity<Dim>& cavity);
  void number_vertices(Complex<Dim>& complex);
  template <int kLogRow>
  void write_by_table(Complex<Dim>& complex, Vertex v);
  void write_by_sorting(Complex<Dim>& complex, Vertex v);
  void write(Complex<Dim>& complex, const Planned& planned, Vertex v);

  detail::PodArray<Planned> planned_;
  detail::PodArray<std::uint32_t> table_;
  detail::PodArray<Side> sides_;
};

extern template class StarLinker<2>;
extern template class StarLinker<3>;

}  // namespace sinkmesh
