// SPDX-License-Identifier: MIT
//
// The topological step of every flip: some simplices out, others in, in the same place.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/complex.h"

namespace sinkmesh {

/// Replaces simplices by others. Holds working memory only; keep one and reuse it.
///
///         d                     d
///       / | \                 / : \         2-3, for example: abcd and abce share the facet abc. Out they go,
///      a--|--c    <------>   a--:--c        and abde, bcde, cade come in around the new edge de. 3-2 is the
///       \ b /                 \ b /         way back.
///         e                     e
template <int Dim>
class Retriangulator {
 public:
  using Corners = std::array<Vertex, Dim + 1>;

  /// Takes away `old` and puts in `fresh`, which must fill the same ball: same boundary, positively oriented
  /// corners, infinity anywhere. Slots are used again.
  /// @return the new simplices, in the order of `fresh`; valid until the next call.
  /// @throws CapacityError, std::bad_alloc before anything is changed.
  /// Cost: log-linear in the number of simplices; of a few, such as flips have, each is compared with each.
  const std::vector<Simplex>& replace(Complex<Dim>& complex, std::span<const Simplex> old,
                                      std::span<const Corners> fresh);

  /// The simplices that the last call has put in.
  const std::vector<Simplex>& created() const { return created_; }

 private:
  /// A half-facet that has no mate yet, with the slots of its vertices in order.
  struct Open {
    std::array<std::uint32_t, Dim> facet;
    HalfFacet half_facet;
  };

  static std::array<std::uint32_t, Dim> key_of(const Complex<Dim>& complex, HalfFacet h);
  void link(Complex<Dim>& complex, HalfFacet h);
  void link_by_sorting(Complex<Dim>& complex);

  std::vector<Open> open_;
  std::vector<Simplex> created_;
};

extern template class Retriangulator<2>;
extern template class Retriangulator<3>;

}  // namespace sinkmesh
