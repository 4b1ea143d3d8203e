// SPDX-License-Identifier: MIT
//
// The refinement driver: {sink, circumcenter} x {incremental, block, parallel} over one inserter [EG01, 4.5].
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "refine/boundary.h"
#include "refine/budget.h"
#include "refine/conformer.h"
#include "refine/options.h"
#include "refine/sink_walk.h"
#include "refine/steiner_inserter.h"

namespace sinkmesh {

/// Inserts Steiner points into a stable domain until no simplex has r/l above options.max_ratio, or none of
/// those left can be mended. The triangulation is Delaunay and the domain stable whenever a callback runs, and
/// at the end.
///
/// Order of work: by geometry alone (Order, circumradius; ties by a hash of the coordinates), so that the mesh
/// depends neither on numbering nor on how the triangulation was built.
///
/// Termination: SteinerInserter. Every pass of every loop below takes an entry from a finite queue, inserts a
/// point, or rejects a simplex for as long as it lives.
template <int Dim>
class Refiner {
 public:
  /// @throws InputError if max_ratio is below 1 or not a number, if `literal` is asked of the incremental
  ///         schedule, or if the input is at the resolution of doubles (SteinerInserter).
  Refiner(Triangulation<Dim>& triangulation, Domain<Dim>& domain, Flow<Dim>& flow,
          const RefineOptions& options);
  /// With a boundary that is divided, too [BR, 6]: first as above; then, where that left a simplex, the
  /// sub-facets that its points encroach are divided; and so on. At the end all circumcenters are inside, and
  /// no simplex has all its vertices on one patch. Requires a conforming surface.
  Refiner(Triangulation<Dim>& triangulation, Domain<Dim>& domain, Flow<Dim>& flow, Boundary<Dim>& boundary,
          Conformer<Dim>& conformer, const BoundaryRules<Dim>& rules, const RefineOptions& options);

  RefineResult run();
  /// Instead of run(): `remaining` and `centers_beyond` if nothing is done.
  RefineResult look();
  /// Instead of run(): leftovers() if nothing is done. Within a fixed boundary points are tested, so that the
  /// reasons are known.
  void find_leftovers();
  /// After run(): null if the mesh is what was asked for. Else a budget, the cancel flag or the floor has ended
  /// it in the middle of what a point on the boundary set off, or a state before was better; this is a valid
  /// state shortly before, or that one: rebuild it, and, unless this Refiner knows, ask a new one what remains.
  const typename Boundary<Dim>::Snapshot* last_valid() const { return is_valid_ ? nullptr : &*last_valid_; }
  /// Whether leftovers() and `remaining` are those of last_valid(), too.
  bool knows_leftovers() const { return is_valid_ || is_known_; }
  /// After run(): the simplices of low quality that remain, the worst ratio first. Corners and features are
  /// those of the complex.
  const std::vector<Leftover<Dim>>& leftovers() const { return leftovers_; }

 private:
  struct Encroached {
    double depth2;  // 0 at the center of its diametral sphere, 1 on it
    std::uint64_t tie;
    SubFacet facet;
    Point<Dim> center;
  };

  void run_incremental(bool divides_boundary);
  void run_rounds();
  void test_points();
  void refine_boundary();
  void divide_boundary(std::size_t enough);
  // Each returns whether it has inserted a point.
  bool divide_for(Simplex s);
  bool divide_for(const Candidate<Dim>& candidate, double relaxed2);
  bool insert_withdrawn(Candidate<Dim> candidate, double relaxed2);
  double least_distance2(double radius2, double relaxed2) const;
  std::vector<Encroached> encroached_sub_facets(const Candidate<Dim>& candidate);
  bool bring_centers_inside();
  bool expel_flat_simplices();
  bool is_flat(Simplex s) const;
  bool is_to_expel(Simplex s) const { return conformer_->is_on_one_patch(s) || is_flat(s); }
  bool insert_center_of_circle(Simplex s);
  HalfFacet wall_before_center(Simplex s);
  bool is_center_beyond(Simplex s) { return !flow_->is_sink(s) && !wall_before_center(s).is_null(); }
  std::size_t count_centers_beyond();
  bool divide_at(HalfFacet wall);
  template <class IsWanted, class Mend>
  bool mend_each(IsWanted&& is_wanted, Mend&& mend);
  void settle_boundary();
  std::size_t num_boundary_points() const;

  // Incremental: tries the points for one simplex, one after the other, until one is inserted.
  bool insert_for(Simplex s);
  bool has_candidate(Simplex s);
  bool has_fallback() const;
  // Calls visit(t) for the simplices whose points are to be inserted for s, until it returns true: with sinks
  // its sinks, those that the steepest flow reaches first; else s itself.
  template <class Visit>
  bool visit_owners(Simplex s, Visit&& visit) {
    return options_.insert == Insert::sink ? sink_walk_(*flow_, s, visit) : visit(s);
  }
  // The point of an owner: its center, or its off-sink.
  bool make_candidate(Simplex owner, bool own_center, Candidate<Dim>& candidate);
  bool insert_point_of(Simplex owner, bool own_center);
  bool try_insert(const Candidate<Dim>& candidate);
  // The order of work: the highest priority first, which is at least 1, of equal ones the largest tie.
  double priority(const Shape& shape) const;
  std::uint64_t tie(Simplex s, const Shape& shape) const;

  // Rounds: candidates by decreasing priority.
  std::vector<Candidate<Dim>> collect(bool own_centers);
  void insert_block(const std::vector<Candidate<Dim>>& candidates);
  void insert_independent(const std::vector<Candidate<Dim>>& candidates);
  void insert_literally(const std::vector<Candidate<Dim>>& candidates);
  bool is_needless(const Candidate<Dim>& candidate) const;
  bool is_taken(Vertex v) const { return v.slot() < taken_.size() && taken_[v.slot()] == result_.rounds; }
  void take(Vertex v);

  bool may_continue();
  std::size_t num_inserted() const { return inserter_.num_inserted() + num_boundary_points(); }
  std::size_t num_vertices() const { return inserter_.num_vertices() + num_boundary_points(); }
  bool is_stopped() const { return budget_.stop() != Stop::no_candidate || !is_valid_; }
  void begin_round();
  void end_round();
  // If the boundary counts as fixed, what points on it could mend is not `untried`.
  void classify_remaining(bool is_fixed);
  typename Leftover<Dim>::Reason reason_for(Simplex s, bool is_fixed);
  void explain(Simplex s, Leftover<Dim>& leftover) const;

  RefineOptions options_;
  Budget budget_;
  Flow<Dim>* flow_;
  Boundary<Dim>* boundary_ = nullptr;  // null: fixed
  Conformer<Dim>* conformer_ = nullptr;
  SteinerInserter<Dim> inserter_;
  std::vector<Leftover<Dim>> leftovers_;
  RefineResult result_;
  Progress round_;
  std::size_t dependent_ = 0;   // found so before a search
  std::size_t num_merged_ = 0;  // candidates that fell together with others of the round
  std::size_t inserted_before_round_ = 0;
  bool generous_ = false;  // with points on the boundary
  bool is_valid_ = true;
  bool is_known_ =
      false;  // what remains of last_valid_, to which the run comes back if what follows is no better
  std::optional<typename Boundary<Dim>::Snapshot> last_valid_;
  std::size_t on_segments_before_ = 0;
  std::size_t on_patches_before_ = 0;

  std::vector<std::size_t> taken_;  // by vertex slot: the last round in which a star took it
  SinkWalk<Dim> sink_walk_;
};

}  // namespace sinkmesh
