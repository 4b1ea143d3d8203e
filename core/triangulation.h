// SPDX-License-Identifier: MIT
//
// The Delaunay triangulation of a point set, exact, in the plane and in space.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/cavity.h"
#include "core/complex.h"
#include "core/flip_inserter.h"
#include "core/location.h"
#include "core/spatial_order.h"
#include "core/star_linker.h"
#include "core/validation.h"
#include "core/vertex_remover.h"
#include "predicates/input_gate.h"
#include "predicates/staged.h"

namespace sinkmesh {

/// How points are inserted. Both build the same complex, facet for facet; stars are faster.
enum class Engine : std::uint8_t {
  star,   ///< replace the prestar of the point by its star [EG01, 4.1]
  flips,  ///< subdivide the simplex that holds the point, then flip until every facet is Delaunay [EG01, 4.3]
};

/// The Delaunay triangulation after perturbation of the lifted coordinate [PS, 2]: unique for a set of points,
/// so it depends neither on their order nor on the engine; every solid simplex has positive exact volume, and
/// the hull is the exact convex hull, also for grids and for coplanar or cospherical points.
///
/// Coordinates are kept behind the input gate (scaled by a power of two, on the grid 2^-121); point() gives
/// them back in the units of the input. Ids of vertices are the indices of the input points; copies of an
/// earlier point have an id, but are in no simplex.
///
/// Invariants, checked by validate(), besides those of Complex:
///   D1  every solid simplex has positive volume;
///   D2  no simplex is in conflict with the apex of a neighbour, which makes the whole triangulation Delaunay
///       and the hull convex [PS, 2a].
template <int Dim>
class Triangulation {
 public:
  /// The triangulation of all points.
  /// @throws InputError      for a coordinate that is not finite (input_gate.h).
  /// @throws DegenerateInput if all points lie in one hyperplane.
  /// @throws CapacityError   beyond 2^30 simplices.
  explicit Triangulation(std::span<const Point<Dim>> points, Engine engine = Engine::star);

  // -- the complex

  const Complex<Dim>& complex() const { return complex_; }
  const Predicates<Dim>& predicates() const { return predicates_; }
  const InputGate<Dim>& gate() const { return gate_; }

  /// Coordinates in the units of the input.
  Point<Dim> point(Vertex v) const { return gate_.out(complex_.point(v)); }
  /// Input points that equal an earlier one, by increasing id.
  const std::vector<InsertionOrder::Duplicate>& duplicates() const { return duplicates_; }

  std::size_t num_solid() const { return complex_.num_simplices() - num_ghosts(); }
  /// Simplices of the hull's boundary, one ghost for each. Linear.
  std::size_t num_ghosts() const;

  // -- points

  /// The simplex that holds p, and where in it p lies; a visibility walk from `hint`.
  /// @param p  gated coordinates.
  Location<Dim> locate(const Point<Dim>& p, Simplex hint = {}) const;

  struct Insertion {
    Vertex vertex;
    bool is_new;  ///< false: p equals `vertex`, and nothing has changed
  };
  /// Inserts one point; its vertex gets the next id.
  /// @param p  in the units of the input; rounded to the grid of the gate.
  /// @throws InputError if p is not finite, or has a coordinate beyond the gate: not below the first power of
  ///         two above all |coordinates| of the input.
  /// @throws CapacityError, std::bad_alloc. Nothing has changed then, but by flips, which may leave a
  ///         triangulation that is not Delaunay yet.
  Insertion insert(const Point<Dim>& p, Engine engine = Engine::star, Simplex hint = {});

  /// Removes a vertex: the complex is then that of the other points. The vertex keeps its id and coordinates
  /// and is in no simplex; copies of it that were in the input are not put in its place. Other handles of
  /// vertices stay valid, those of simplices outside the star as well.
  ///
  /// @return the simplices that have taken the place of its star, ghosts included; valid until the next call.
  /// Cost: about that of inserting the vertices of its link (vertex_remover.h).
  /// @throws InputError      if v is no vertex, or in no simplex.
  /// @throws DegenerateInput if all other points lie in one hyperplane. Nothing has changed then, nor if memory
  ///         runs out.
  const std::vector<Simplex>& remove(Vertex v);
  /// What remove() would put in the place of the star of v, as corners, ghosts included; changes nothing. Valid
  /// until the next call of either; empty if remove() would throw DegenerateInput. Costs as much.
  /// @throws InputError if v is no vertex, or in no simplex.
  std::span<const std::array<Vertex, Dim + 1>> without(Vertex v);

  // -- the prestar of a point, for callers that want to look before they insert [EG01, 4.1]

  /// Makes x a legal argument of grow_prestar(). Gated coordinates.
  void announce(const Point<Dim>& x) { predicates_.include(x); }
  /// Finds the prestar of x from a simplex in conflict with it; see Cavity::grow() for the guide and the
  /// result.
  template <class Guide = FreeGuide>
  bool grow_prestar(Cavity<Dim>& cavity, const Point<Dim>& x, Simplex start, Guide&& guide = {}) {
    return cavity.grow(complex_, predicates_, x, start, guide);
  }
  /// Undoes grow_prestar().
  void release(const Cavity<Dim>& cavity) { cavity.release(complex_); }
  /// Replaces the prestar of x by its star. Requires that the cavity is the whole prestar, and that x is no
  /// vertex.
  /// @throws CapacityError, std::bad_alloc; the prestar is then released and the triangulation as before.
  Vertex substitute_star(Cavity<Dim>& cavity, const Point<Dim>& x);
  /// The same for a vertex that is in no simplex: it comes back, at x.
  void substitute_star(Cavity<Dim>& cavity, const Point<Dim>& x, Vertex v);

  /// Renumbers simplices without gaps; vertices keep their ids.
  void compact() { complex_.compact(); }

  // -- checks

  /// Every violated invariant, by number and handle. Works on a broken complex. Linear.
  ValidationReport validate() const { return sinkmesh::validate(complex_, predicates_); }
  /// Whether every facet is Delaunay (D2), exactly. Linear.
  bool is_delaunay() const { return sinkmesh::is_delaunay(complex_, predicates_); }
  /// Of the set of solid simplices, by coordinates: equal for equal complexes, whatever the numbering.
  std::uint64_t hash() const;

  /// Access for tests that break invariants on purpose.
  Complex<Dim>& mutable_complex() { return complex_; }

 private:
  void insert_all(Engine engine);
  void require_present(Vertex v) const;
  void restore_ids(std::span<const Point<Dim>> gated, const std::vector<std::uint32_t>& order);
  Simplex some_simplex() const;

  InputGate<Dim> gate_;
  Predicates<Dim> predicates_;
  Complex<Dim> complex_;
  Cavity<Dim> cavity_;
  StarLinker<Dim> linker_;
  FlipInserter<Dim> flipper_;
  VertexRemover<Dim> remover_;
  std::vector<InsertionOrder::Duplicate> duplicates_;
};
using Triangulation2 = Triangulation<2>;
using Triangulation3 = Triangulation<3>;

}  // namespace sinkmesh
