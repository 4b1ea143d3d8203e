// SPDX-License-Identifier: MIT
//
// Taking inner vertices out of a refined domain and putting them back elsewhere, with all that depends on them.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/star_walk.h"
#include "core/triangulation.h"
#include "refine/boundary.h"
#include "refine/domain.h"
#include "refine/flow.h"
#include "refine/point_guide.h"

namespace sinkmesh {

/// Keeps the triangulation, the domain, the flow and the boundary together while inner Steiner vertices leave
/// and points come. Every decision is made by exact signs before anything is changed.
///
/// What a removal cannot break. No wall meets the vertex, so its star lies in one region, and what fills the
/// star has the walls of its link. Let f be one, and t the simplex between f and the vertex. Its circumcenter
/// is on the inner side of f, for the domain is stable; so its ball, in which no vertex is, holds the inner
/// half of the diametral ball of f, and the new apex at f is not in that either: the domain stays stable. In
/// space a circumcenter may come to lie beyond the boundary all the same, hence has_center_inside().
template <int Dim>
class InteriorEditor {
 public:
  using Region = typename Domain<Dim>::Region;

  /// @param boundary   null if it is kept as given.
  /// @param num_given  vertices with a smaller id are not touched.
  /// Requires a stable domain. Linear: the shortest edge inside is what vertices that come keep from others.
  InteriorEditor(Triangulation<Dim>& triangulation, Domain<Dim>& domain, Flow<Dim>& flow,
                 Boundary<Dim>* boundary, std::uint32_t num_given);

  const Complex<Dim>& complex() const { return triangulation_->complex(); }
  const Domain<Dim>& domain() const { return *domain_; }

  /// Whether v has been inserted, and no wall meets it. Looks at its star.
  bool is_movable(Vertex v);
  /// The simplices around a vertex; valid until the next call.
  const std::vector<Simplex>& star(Vertex v);

  /// What would fill the star of v, which is movable, as corners; valid until the next edit.
  std::span<const std::array<Vertex, Dim + 1>> without(Vertex v) { return triangulation_->without(v); }
  /// Takes a movable vertex out.
  /// @return what fills its star.
  const std::vector<Simplex>& remove(Vertex v);

  /// Looks for the prestar of x, gated. `near` is a simplex of the region to which x has to belong.
  /// @param view  is called if x may be inserted, while cavity() is the prestar and is_in_prestar() tells.
  /// @return whether it may, and view has agreed.
  template <class View>
  bool look(const Point<Dim>& x, Simplex near, View&& view);
  const Cavity<Dim>& cavity() const { return cavity_; }
  bool is_in_prestar(Simplex s) const {
    return (complex().records()[s.index()].corner[0] & Complex<Dim>::kMark) != 0;
  }
  /// Whether the circumcenter of a simplex, there or to come, computed exactly and rounded once, lies in the
  /// region of `near`, or on its boundary.
  bool has_center_inside(const Corners<Dim>& corners, Simplex near);

  /// Inserts x, of which look() has said that it may be, from the same simplex; or where a vertex has just
  /// been.
  /// @param v  in no simplex: it comes back. Null: a new vertex.
  /// @return the vertex; cavity().star(i) are its simplices.
  Vertex insert(const Point<Dim>& x, Simplex near, Vertex v);

 private:
  Simplex locate(const Point<Dim>& x, Simplex near);

  Triangulation<Dim>* triangulation_;
  Domain<Dim>* domain_;
  Flow<Dim>* flow_;
  Boundary<Dim>* boundary_;
  std::uint32_t num_given_;
  double separation2_ = HUGE_VAL;
  Cavity<Dim> cavity_;
  StarWalk<Dim> star_walk_;
  std::vector<Simplex> star_;
};

template <int Dim>
template <class View>
bool InteriorEditor<Dim>::look(const Point<Dim>& x, Simplex near, View&& view) {
  triangulation_->announce(x);
  const Simplex start = locate(x, near);
  if (start.is_null()) return false;
  const auto is_taken = [](Vertex) { return false; };
  PointGuide<Dim, decltype(is_taken)> guide(*triangulation_, *domain_, x, separation2_, is_taken);
  if (!guide.start(start) || !triangulation_->grow_prestar(cavity_, x, start, guide)) return false;
  const bool agreed = guide.verdict() == Verdict::inserted && view();
  triangulation_->release(cavity_);
  return agreed;
}

extern template class InteriorEditor<2>;
extern template class InteriorEditor<3>;

}  // namespace sinkmesh
