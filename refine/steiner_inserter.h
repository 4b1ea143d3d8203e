// SPDX-License-Identifier: MIT
//
// One Steiner point: from a simplex to its exact center or a point on its chain, through all tests, into the
// complex.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/triangulation.h"
#include "core/vector.h"
#include "refine/boundary_features.h"
#include "refine/domain.h"
#include "refine/flow.h"
#include "refine/off_sink.h"
#include "refine/options.h"
#include "refine/point_guide.h"
#include "refine/quality.h"

namespace sinkmesh {

/// A point that may be inserted: the circumcenter of a simplex, or a point on its chain.
template <int Dim>
struct Candidate {
  Simplex owner;                  ///< for which it was made; a refusal is noted there
  std::uint32_t owner_birth = 0;  ///< when the candidate was made
  Simplex simplex;          ///< strictly inside whose circumsphere it lies; the owner, if it is its center
  std::uint32_t birth = 0;  ///< of that simplex
  Vertex corner;            ///< of that simplex; outlives it
  std::array<Point<Dim>, Dim + 1> corners{};  ///< of that simplex
  Point<Dim> point{};                         ///< a center is exact, rounded once
  bool is_center = true;                      ///< of the circumsphere of `simplex`
  double radius2 = 0;                         ///< squared distance from the nearest vertices
  double priority = 0;                        ///< in a round the highest comes first
  double least2 = 0;      ///< the least squared distance from all vertices, where delta is not enough
  std::uint64_t tie = 0;  ///< orders candidates of equal priority; a function of the geometry
};

/// How the angles of a surface excuse short edges [BR, 6].
template <int Dim>
struct BoundaryRules {
  const BoundaryFeatures<Dim>* features = nullptr;
  double lambda = 0;  ///< see BoundaryFeatures::rung()
  double floor = 0;   ///< no edge counts as shorter; gated
};

/// Keeps the triangulation, the domain, the flow and the list of simplices of low quality together while points
/// are inserted; knows nothing of schedules.
///
/// Why a refinement ends [EG01, 4.4; PS, 8]. delta is fixed once: the shortest distance between input vertices.
/// A point is inserted only if it is, as stored, strictly inside the circumsphere of its simplex, and at least
/// delta away from all vertices of the closure of its prestar; the nearest vertex of a new point is among
/// these, since it is a Delaunay neighbour. So all vertices stay delta apart, inside a bounded domain, and by
/// packing there are finitely many. Every other verdict but `dependent` rejects the simplex until it dies. So
/// each attempt inserts one of boundedly many points, or rejects one of finitely many simplices; `dependent`
/// occurs only in rounds that insert another point.
///
/// Why a rejection is final while the simplex s lives, whatever is inserted elsewhere. Let x be the center of
/// s, f a boundary facet, t the inside simplex at f, and t' the one that replaces t when y is inserted.
/// - boundary: x is in the diametral ball of f, and f in the closure of Pt x, so t is in Pt x. If x lies on the
///   inner side of f: y passed the boundary test, so the center of t' is on the inner side, and its ball holds
///   the inner half of the diametral ball, hence x; f stays in the closure. If x lies beyond f: see crossing.
/// - crossing: a simplex o outside, at f, is in conflict with x. o never changes. If x lies on the inner side
///   of f, the ball of t' holds what the ball of o has there, because f is Delaunay; so x is still reached. If
///   x lies beyond f, x has left the domain, and every way from s to x crosses the boundary, at a facet whose
///   outer simplex is in conflict.
/// - separation: vertices do not move, and the nearest one stays a neighbour.
/// So the verdict is cached, and rounds that recompute it (--literal) come to the same mesh. An off-sink may
/// move when simplices on its chain die; that its verdict is cached all the same is what keeps the count above,
/// and why there are no literal rounds of off-sinks.
template <int Dim>
class SteinerInserter {
 public:
  /// Requires a stable domain: no flow leads out of it.
  /// @throws InputError if delta is below 2^-40 of the largest coordinate: the input is at the resolution of
  /// doubles.
  SteinerInserter(Triangulation<Dim>& triangulation, Domain<Dim>& domain, Flow<Dim>& flow, double max_ratio);
  /// For a surface that is divided as well. A simplex is then worked on only if r > max_ratio L: L is the
  /// length of its shortest edge, or more, if that edge is short because of a small angle of the surface. delta
  /// is the floor: whatever is inserted for quality is farther than that from all vertices [BR, 9].
  SteinerInserter(Triangulation<Dim>& triangulation, Domain<Dim>& domain, Flow<Dim>& flow, double max_ratio,
                  const BoundaryRules<Dim>& rules);

  /// Finds the simplices of low quality. Call it once, after on_low_quality is set.
  void measure_all();

  // -- the state of the mesh

  const Triangulation<Dim>& triangulation() const { return *triangulation_; }
  const Complex<Dim>& complex() const { return triangulation_->complex(); }
  const Domain<Dim>& domain() const { return *domain_; }
  Flow<Dim>& flow() { return *flow_; }

  std::size_t num_simplices() const { return num_simplices_; }
  std::size_t num_low_quality() const { return num_low_; }
  std::size_t num_vertices() const { return num_vertices_; }
  /// delta, gated.
  double separation2() const { return separation2_; }

  bool is_low_quality(Simplex s) const { return notes_[s.index()] & kLow; }
  /// Of low quality, but left alone, because a small angle of the surface is the reason. Not if that is fixed.
  bool is_excused(Simplex s) const { return notes_[s.index()] & kExcused; }
  /// Whether it would be excused by the floor alone: its shortest edge does not count as shorter.
  bool is_at_floor(Simplex s) const;
  /// Judges anew who is excused.
  void set_lambda(double lambda);
  /// The square of L: see the constructor; of a fixed boundary the shortest edge itself.
  double relaxed_length2(Simplex s) const {
    return relaxed_length2(s, shape<Dim>(complex().corners(s)).shortest2);
  }
  /// Why s is excused: a rung among its shortest edges, or, if the excuse is inherited, the one between a
  /// vertex and its culprit. If s is not excused, one between corners, if there is.
  std::optional<Rung> rung(Simplex s) const;
  /// In the plane: the corner of s, as its index, at which two walls meet, if the edge opposite it is the
  /// shortest; else -1. However the walls are divided, some triangle has that angle: nothing is gained by
  /// working on s.
  int sharp_corner(Simplex s) const;
  /// Whether the point of s has been refused. It is not tried again while s lives.
  bool is_rejected(Simplex s) const { return rejection(s) != Verdict::inserted; }
  /// The reason, or `inserted` for none.
  Verdict rejection(Simplex s) const { return static_cast<Verdict>(notes_[s.index()] >> kVerdictShift & 7); }
  /// A number that no two simplices in the same slot share (but for a wrap after 2^32 simplices, which can
  /// change the order of work, and nothing else).
  std::uint32_t birth(Simplex s) const { return birth_[s.index()]; }
  bool is_current(Simplex s, std::uint32_t birth) const {
    return complex().is_alive(s) && birth_[s.index()] == birth;
  }

  /// Simplices of low quality that live, in the order of their births.
  const std::vector<Simplex>& low_quality();

  /// Called for each simplex of low quality when it is born; may be empty.
  std::function<void(Simplex, const Shape&)> on_low_quality;

  // -- boundary points, which someone else inserts

  /// An inside simplex is about to be replaced.
  void remove(Simplex s) {
    num_low_ -= is_low_quality(s) ? 1 : 0;
    --num_simplices_;
    birth_[s.index()] = ++births_;  // what takes its slot may be outside, and is not added then
    notes_[s.index()] = 0;
  }
  /// A new simplex, inside.
  void add(Simplex s);
  /// The walls in the closure of the prestar of a candidate whose diametral spheres hold it.
  /// Requires that its simplex lives.
  std::vector<HalfFacet> encroached_walls(const Candidate<Dim>& candidate);
  /// Whether dividing the boundary for the center of s has been found to be of no use. Holds while s lives.
  bool is_hopeless(Simplex s) const { return notes_[s.index()] & kHopeless; }
  /// Forgets that the center of s has been refused: the boundary has been divided.
  void reconsider(Simplex s) { notes_[s.index()] &= (1U << kVerdictShift) - 1; }
  void reconsider_all() {
    for (std::uint8_t& notes : notes_) notes &= kLow | kExcused;
  }
  void give_up(Simplex s) { notes_[s.index()] |= kHopeless; }

  /// Called, after an insertion, with the outer half-facet of each wall that has a new simplex at it; may be
  /// empty.
  std::function<void(HalfFacet)> on_new_at_wall;

  // -- candidates

  /// All but the point.
  Candidate<Dim> describe(Simplex s) const;
  /// The center of s.
  /// @return false, and s is rejected, if it is too far away to be a Steiner point.
  bool make_center(Simplex s, Candidate<Dim>& candidate);
  /// The point on the chain of s at distance reach max_ratio L, or the end of the chain.
  /// @return false, and s is rejected, if the chain leads outside.
  bool make_off_sink(Simplex s, double reach, Candidate<Dim>& candidate);

  /// The center of a simplex, or, if it is too far away, a point on the way there that is not inside the hull.
  /// The predicates know it.
  Point<Dim> center_or_direction(Simplex s);

  /// Orders simplices of equal priority: a hash of the coordinates of its corners.
  std::uint64_t tie(Simplex s) const;

  /// Looks for the prestar of a candidate whose simplex lives; leaves the complex unchanged.
  /// @param closure  receives the vertices of the closure of the prestar, if the verdict is `inserted`, which
  ///                 here means: could be inserted.
  Verdict test(const Candidate<Dim>& candidate, std::vector<Vertex>& closure);

  /// Tests a candidate, and inserts it if it passes.
  ///
  /// If its simplex has died, the point is located again, from the vertex that outlives it.
  /// @param is_taken  asked for each vertex of the closure of the prestar; a claim ends the search with the
  ///                  verdict `dependent`.
  template <class IsTaken>
  Verdict insert(const Candidate<Dim>& candidate, IsTaken&& is_taken);
  Verdict insert(const Candidate<Dim>& candidate) {
    return insert(candidate, [](Vertex) { return false; });
  }
  /// The same with another point than that of its owner. If it fails, that is not noted: what is known of the
  /// owner stands.
  Verdict insert_other(const Candidate<Dim>& candidate) {
    return attempt(candidate, [](Vertex) { return false; });
  }

  /// After an insertion: calls visit(v) for every vertex of the closed star of the new point, some more than
  /// once.
  template <class Visit>
  void visit_closed_star(Visit&& visit) const {
    for (std::size_t i = 0; i < cavity_.num_facets(); ++i) {
      for (int k = 0; k <= Dim; ++k) visit(complex().corner(cavity_.star(i), k));
    }
  }

  std::size_t num_prestars() const { return num_prestars_; }
  std::size_t num_inserted() const { return num_inserted_; }
  const Rejections& rejections() const { return rejections_; }

 private:
  // Bits of a note: low quality, excused, hopeless, and three for the verdict on the point.
  static constexpr std::uint8_t kLow = 1;
  static constexpr std::uint8_t kExcused = 2;
  static constexpr std::uint8_t kHopeless = 4;
  static constexpr int kVerdictShift = 3;

  template <class IsTaken>
  Verdict grow(const Candidate<Dim>& candidate, Simplex start, IsTaken&& is_taken);
  template <class IsTaken>
  Verdict attempt(const Candidate<Dim>& candidate, IsTaken&& is_taken);
  Verdict refuse(const Candidate<Dim>& candidate, Verdict verdict);
  Verdict locate(const Candidate<Dim>& candidate, Simplex& start);
  void commit(const Point<Dim>& x);
  void count_vertices();
  template <class Visit>
  void for_each_shortest_edge(Simplex s, double shortest2, Visit&& visit) const;
  double relaxed_length2(Simplex s, double shortest2) const;
  double least_length2() const;
  bool is_excused_by_angle(Simplex s, const Shape& shape) const;

  Triangulation<Dim>* triangulation_;
  Domain<Dim>* domain_;
  Flow<Dim>* flow_;
  double max_ratio2_;
  double separation2_ = 0;
  BoundaryRules<Dim> rules_;

  Cavity<Dim> cavity_;
  OffSinkWalk<Dim> off_sink_walk_;
  std::vector<std::uint32_t> birth_;
  std::vector<std::uint8_t> notes_;  // low quality, and the verdict on the point
  std::uint32_t births_ = 0;
  std::vector<std::pair<Simplex, std::uint32_t>> low_;  // and births; some may have died
  std::vector<Simplex> low_alive_;

  std::size_t num_simplices_ = 0;
  std::size_t num_low_ = 0;
  std::size_t num_vertices_ = 0;
  std::size_t num_prestars_ = 0;
  std::size_t num_inserted_ = 0;
  Rejections rejections_;
};

// Leaves the complex marked if the verdict is `inserted`, else as it was.
template <int Dim>
template <class IsTaken>
Verdict SteinerInserter<Dim>::grow(const Candidate<Dim>& candidate, Simplex start, IsTaken&& is_taken) {
  PointGuide<Dim, std::remove_reference_t<IsTaken>> guide(*triangulation_, *domain_, candidate.point,
                                                          std::max(separation2_, candidate.least2), is_taken);
  if (!guide.start(start)) return guide.verdict();
  ++num_prestars_;
  triangulation_->announce(candidate.point);
  const bool finished = triangulation_->grow_prestar(cavity_, candidate.point, start, guide);
  const Verdict verdict = guide.verdict();
  if (finished && verdict != Verdict::inserted) triangulation_->release(cavity_);
  return verdict;
}

template <int Dim>
template <class IsTaken>
Verdict SteinerInserter<Dim>::attempt(const Candidate<Dim>& candidate, IsTaken&& is_taken) {
  Simplex start;
  Verdict verdict = locate(candidate, start);
  if (verdict == Verdict::inserted) verdict = grow(candidate, start, is_taken);
  if (verdict == Verdict::inserted) commit(candidate.point);
  return verdict;
}

template <int Dim>
template <class IsTaken>
Verdict SteinerInserter<Dim>::insert(const Candidate<Dim>& candidate, IsTaken&& is_taken) {
  const Verdict verdict = attempt(candidate, is_taken);
  return verdict == Verdict::inserted ? verdict : refuse(candidate, verdict);
}

extern template class SteinerInserter<2>;
extern template class SteinerInserter<3>;

}  // namespace sinkmesh
