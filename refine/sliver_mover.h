// SPDX-License-Identifier: MIT
//
// Removal of slivers: inner vertices move, and where that does not help points are added [OS, 3].
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "refine/budget.h"
#include "refine/improvement.h"
#include "refine/interior_editor.h"
#include "refine/options.h"
#include "refine/places.h"
#include "refine/sliver_cost.h"

namespace sinkmesh {

/// A bound on r/l does not see slivers: four points near a great circle of their sphere. Takes them away from a
/// refined domain by three kinds of steps, in turns until none is left to take:
///
/// - move: an inner Steiner vertex of a sliver is taken out, places around it are tried, and it is put back at
///   the best one, or where it was;
/// - remove: it is not put back, if the mesh costs no more without it;
/// - pick: a point is put into the sphere of a sliver.
///
/// The mesh stays exactly Delaunay, the boundary as it is and stable. No step makes an edge shorter than the
/// shortest, puts a circumcenter beyond the boundary, or lets the number of simplices of low quality or the
/// largest r/l of the mesh grow: where one cannot be mended, another may take its place, if the cost falls. The
/// mesh never has more simplices than at the beginning. All this is decided before anything is changed for
/// good; rounded numbers only say which places are tried, and what they cost.
///
/// Why it ends. The cost of the mesh is the sum of SliverCost over its simplices: a whole number, not negative.
/// A move or a pick is taken only if the cost falls, a removal if it does not grow; so each step makes the pair
/// (cost, number of vertices) smaller in lexicographic order, and pairs of natural numbers have no infinite
/// falling sequence: there are finitely many steps. A pass goes once through a list made at its beginning, and
/// only one that has taken a step, or has left a vertex that may be tried again, is followed by another; with
/// the same star a vertex is tried kMaxTries times, and only once after kPatience vain tries with any star.
template <int Dim>
class SliverMover {
 public:
  /// @param num_vertices  of the domain, for the budget.
  /// Requires valid options.
  SliverMover(InteriorEditor<Dim>& editor, const RefineOptions& options, std::size_t num_vertices);

  SliverResult run();
  /// After run(): what is left, the smallest angle first. Corners are those of the complex. Linear.
  std::vector<Sliver<Dim>> slivers();

 private:
  using Cost = typename SliverCost<Dim>::Cost;
  struct Place {
    Point<Dim> point;
    Cost change;  // of the cost of the mesh
  };
  /// How often no better place was found for a vertex.
  struct Tries {
    std::uint64_t star = 0;
    int number = 0;  // with this star
    int total = 0;
    bool are_enough() const { return number >= (total < kPatience ? kMaxTries : 1); }
  };
  static constexpr int kMaxTries = 3;
  // Where a small angle of the surface is the reason for slivers, stars change all the time, and nothing helps.
  static constexpr int kPatience = 6;
  /// A vertex to move, or a sliver to pick in.
  struct Entry {
    Cost cost;
    std::uint64_t tie;
    std::uint32_t id;
    bool operator<(const Entry& other) const {
      return cost != other.cost ? cost > other.cost : tie < other.tie;
    }
  };

  const Complex<Dim>& complex() const { return editor_->complex(); }
  Cost cost(Simplex s);
  Cost cost(const std::vector<Simplex>& simplices);
  /// The simplex in this slot is new.
  void forget(Simplex s) {
    if (s.index() < costs_.size()) costs_[s.index()] = -1;
  }
  bool is_sliver(Simplex s) { return cost(s) >= SliverCost<Dim>::kSliver; }
  static bool is_low(Cost cost) { return cost >= SliverCost<Dim>::kLow; }
  bool is_tolerable(Cost cost, const Corners<Dim>& corners) const;
  bool is_tolerable(Simplex s) { return is_tolerable(cost(s), complex().corners(s)); }
  bool has_room() const;

  std::vector<Entry> vertices_of_slivers();
  bool move_all();
  bool is_stuck(Vertex v, const std::vector<Simplex>& star);
  bool move(Vertex v);
  void put(const Place& place, Simplex near, Vertex v);
  std::vector<Entry> all_slivers();
  bool pick_all();
  bool pick(Simplex s);
  bool is_better(const Point<Dim>& x, Cost change, Place& best);
  void order_facets();
  void remember_obstacle(std::uint32_t outer);
  bool may_continue() { return budget_.may_continue(num_vertices_, complex().bytes()); }

  InteriorEditor<Dim>* editor_;
  RefineOptions options_;
  Budget budget_;
  SliverCost<Dim> cost_of_;
  std::size_t num_vertices_;
  std::size_t num_simplices_ = 0;
  std::size_t max_simplices_ = 0;
  std::uint64_t pass_ = 0;
  SliverResult result_;
  double worst_ratio2_ = 0;  // (r/l)^2 that a simplex of low quality may have: the largest at the beginning

  std::vector<Cost> costs_;     // by simplex; -1: not known
  std::vector<Tries> tries_;    // by vertex
  std::vector<Simplex> fresh_;  // what has filled the star of the vertex that is out
  Places<Dim> places_;
  std::vector<std::size_t> facets_;       // of a prestar, in the order in which they are looked at
  std::vector<std::uint32_t> obstacles_;  // outer half-facets that have spoilt places around this vertex
};

extern template class SliverMover<2>;
extern template class SliverMover<3>;

}  // namespace sinkmesh
