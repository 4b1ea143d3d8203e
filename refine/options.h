// SPDX-License-Identifier: MIT
//
// What refinement is asked to do, and what it says it has done.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "refine/quality.h"

namespace sinkmesh {

/// Which point is inserted to remove a simplex of low quality.
enum class Insert : std::uint8_t {
  sink,          ///< the sinks of the simplex: where its circumcenter flows to [EG01, 4.3]
  circumcenter,  ///< its own circumcenter
  /// The point on the way from its shortest edge to its sink that is far enough from all vertices to leave good
  /// simplices, and no farther: few points on large models [OS].
  off_sink,
};

/// Which simplex of low quality comes first.
enum class Order : std::uint8_t {
  ratio,     ///< the largest r/l, as in [EG01, 4.5]
  shortest,  ///< the shortest edge
  smallest,  ///< the smallest circumradius
};

/// When points are inserted [EG01, 4.5].
enum class Schedule : std::uint8_t {
  incremental,  ///< one by one
  block,        ///< in rounds; spheres of one round are mutually orthogonal or further
  parallel,     ///< in rounds; closed prestars of one round are disjoint
};

/// What to do with a simplex of low quality whose sinks are all rejected.
enum class Fallback : std::uint8_t {
  none,          ///< leave it, as in the paper
  circumcenter,  ///< try its own circumcenter
};

/// What happens to facets of the surface [BR].
enum class BoundaryMode : std::uint8_t {
  automatic,  ///< fixed if the surface is stable as given, else refine
  fixed,      ///< kept as given; what is not stable is peeled off [EG01, 5.1]
  /// Divided where that is needed: to be Delaunay, to be stable, to have every circumcenter inside and no flat
  /// simplex; and for quality, but in space, and where a surface is all that as given, not if that would leave
  /// more simplices of low quality.
  refine,
};

struct BoundaryOptions {
  BoundaryMode mode = BoundaryMode::automatic;
  /// In degrees, above 0, at most 60. An edge between two features of the boundary that meet is not held
  /// against the simplices at it if an angle of this size at the common corner or segment explains how short it
  /// is. Smaller attacks more, with more points; below 17 runs may blow up [BR, 2].
  /// Default: kSmallAngle3 in space, kSmallAngle2 in the plane.
  std::optional<double> small_angle = {};
  static constexpr double kSmallAngle3 = 29;
  static constexpr double kSmallAngle2 = 60;
  /// Facets are one patch if all their vertices lie within this distance of one plane, as a fraction of the
  /// diagonal of the bounding box, or a unit in the last place of the largest coordinate, if that is more; 0:
  /// only if exactly coplanar. At least 0, below 1.
  double flat = 0x1p-42;
};

/// Asked between insertions.
enum class Continue : std::uint8_t {
  yes,
  budget_spent,  ///< for instance of time, which the library itself does not measure
  cancelled,
};

/// State of a refinement at the end of a round. In the incremental schedule 256 insertions are called a round.
struct Progress {
  std::size_t round = 0;
  std::size_t vertices = 0;     ///< of the mesh
  std::size_t simplices = 0;    ///< inside
  std::size_t low_quality = 0;  ///< of these, with r/l above the bound
  std::size_t candidates = 0;   ///< in this round: points considered
  /// Of these, seen to pass the boundary test; pruned schedules do not test all.
  std::size_t passed_boundary = 0;
  std::size_t inserted = 0;  ///< in this round
  /// Statistics of the mesh as it is now. Linear; call it only if needed, and only during the callback.
  std::function<QualityStatistics()> statistics;
};

struct RefineOptions {
  /// Bound on r/l; a simplex above it is of low quality. At least 1, below which termination is not guaranteed
  /// [EG01, 4.4].
  double max_ratio = 2.0;
  Insert insert = Insert::off_sink;
  /// For the incremental schedule, and for off-sinks in all; rounds of the others take the largest circumradius
  /// first, as in [EG01, 4.5]. Default: see default_order().
  std::optional<Order> order = {};
  /// Off-sinks are at distance reach max_ratio l from the vertices, l the shortest edge of the simplex, unless
  /// its chain ends before. At least 1. Default: kReach3 in space, kReach2 in the plane [OS, 0].
  std::optional<double> reach = {};
  static constexpr double kReach3 = 1.3;
  static constexpr double kReach2 = 1.5;
  Schedule schedule = Schedule::incremental;
  /// Block and parallel: the paper's own rounds, which test the prestar of every candidate before they choose.
  /// The mesh is the same; the counts show what the pruned rounds save.
  bool literal = false;
  Fallback fallback = Fallback::none;
  BoundaryOptions boundary = {};
  /// After refinement: take away inner Steiner points that are not needed (Coarsener); then move others until
  /// no simplex that they are a corner of has a dihedral angle, in the plane an angle, below min_dihedral, in
  /// degrees, or none can be mended (SliverMover).
  bool coarsen = false;
  bool slivers = false;
  /// Above 0, at most 45: more than that all angles of a mesh can hardly have.
  double min_dihedral = 15;
  /// Not used so far: every refinement runs on the thread of the caller. The mesh will not depend on it.
  unsigned threads = 1;
  /// Budgets; when one is spent the run ends with a valid mesh, or, before the surface is conformed, with none.
  std::size_t max_vertices = std::numeric_limits<std::size_t>::max();
  std::size_t max_bytes = std::numeric_limits<std::size_t>::max();
  /// Polled about every hundred candidates. May be empty.
  std::function<Continue()> should_continue = {};
  /// Called after each round. May be empty.
  std::function<void(const Progress&)> observer = {};
};

/// @throws InputError if max_ratio or reach is below 1 or not a number, if min_dihedral or an option of the
///         boundary is out of its range, or if `literal` is asked of the incremental schedule, or of off-sinks.
void require_valid(const RefineOptions& options);

/// The one that leaves few simplices on large models: with off-sinks the shortest edge first, in space within a
/// boundary that is kept the smallest simplex [OS, 0]. Else the worst ratio, as in [EG01, 4.5].
template <int Dim>
constexpr Order default_order(Insert insert, bool divides_boundary) {
  if (insert != Insert::off_sink) return Order::ratio;
  return Dim == 2 || divides_boundary ? Order::shortest : Order::smallest;
}
template <int Dim>
constexpr double kDefaultReach = Dim == 2 ? RefineOptions::kReach2 : RefineOptions::kReach3;

/// Why a refinement ended.
enum class Stop : std::uint8_t {
  no_candidate,  ///< nothing is left to insert
  floor,         ///< points on the boundary would have come too near to each other; that work was taken back
  budget,
  cancelled,
};

/// As options of the program and reports name them.
const char* name(Insert insert);
const char* name(Order order);
const char* name(Schedule schedule);
const char* name(Stop stop);
const char* name(BoundaryMode mode);

/// Points that were considered and not inserted, by the first reason found. A point that is refused more than
/// once (its simplex died, another has the same center) counts each time.
struct Rejections {
  std::size_t boundary = 0;  ///< in the diametral sphere of a boundary facet in the closure of its prestar
  std::size_t crossing = 0;  ///< its prestar would reach through the boundary
  /// Nearer to a vertex than the input vertices are to each other, or lost by rounding.
  std::size_t separation = 0;
  std::size_t dependent = 0;  ///< not independent of a point of the same round
};

/// Why a simplex of low quality remains, in the order in which reasons are looked for.
enum class LeftoverReason : std::uint8_t {
  small_angle,     ///< only because the surface has a small angle there: see Leftover
  boundary_facet,  ///< has a boundary facet whose own r/l exceeds the bound: nothing inside can mend it
  untried,         ///< the run ended before, or it came when points had been moved, and none is refused
  boundary,        ///< a point for it was rejected for this reason ...
  crossing,
  separation,  ///< or its shortest edge is at the floor, below which no edge is made shorter
  omega,       ///< flows to the outside only
};
inline constexpr std::array kLeftoverReasons = {LeftoverReason::small_angle, LeftoverReason::boundary_facet,
                                                LeftoverReason::untried,     LeftoverReason::boundary,
                                                LeftoverReason::crossing,    LeftoverReason::separation,
                                                LeftoverReason::omega};

/// Simplices of low quality that remain, each with one reason: the first in this order that applies.
struct Remaining {
  std::size_t boundary_facet = 0;
  std::size_t boundary = 0;
  std::size_t crossing = 0;
  std::size_t separation = 0;
  std::size_t omega = 0;
  std::size_t small_angle = 0;
  std::size_t untried = 0;

  std::size_t total() const {
    return boundary_facet + boundary + crossing + separation + omega + small_angle + untried;
  }
  std::size_t count(LeftoverReason reason) const;
  std::size_t& count(LeftoverReason reason);
};

/// A part of the boundary, as the user knows it.
struct BoundaryFeature {
  enum class Kind : std::uint8_t { none, corner, segment, patch };
  Kind kind = Kind::none;
  /// The point of the mesh that is a corner, the two that are the ends of a segment; of a patch its largest
  /// facet in the input.
  std::array<std::uint32_t, 2> ids{};
};

/// One simplex of low quality that remains, and why.
template <int Dim>
struct Leftover {
  using Reason = LeftoverReason;
  std::array<std::uint32_t, Dim + 1> corners{};  ///< points of the mesh
  double ratio = 0;
  Reason reason = Reason::untried;
  /// With `small_angle`: the two features that its shortest edge joins, or of which it has sides, and the
  /// corner or segment at which they meet.
  BoundaryFeature first;
  BoundaryFeature second;
  BoundaryFeature common;
};

/// As reports name them.
const char* name(LeftoverReason reason);
const char* name(BoundaryFeature::Kind kind);

/// What became of the surface before any point was inserted for quality.
struct BoundaryResult {
  /// `fixed` or `refine`: what was done.
  BoundaryMode mode = BoundaryMode::fixed;
  std::size_t regions = 0;
  // -- fixed
  std::size_t peeled_simplices = 0;  ///< taken away, because the flow leads out of them
  std::size_t peeled_facets = 0;     ///< facets of the surface that no longer are on the boundary
  // -- refine
  std::size_t patches = 0;
  std::size_t joined_facets = 0;  ///< facets of the surface less patches
  std::size_t segments = 0;
  std::size_t points_on_segments = 0;
  std::size_t points_on_patches = 0;
  /// Facets of the surface, by increasing id, that have pieces which could not be made Delaunay. Unless it is
  /// empty there is no domain.
  std::vector<std::uint32_t> unconformed;
  /// Other than `no_candidate`: ended by a budget or on request before the surface was conformed.
  Stop stop = Stop::no_candidate;

  bool ok() const { return unconformed.empty() && stop == Stop::no_candidate; }
};

struct RefineResult {
  Stop stop = Stop::no_candidate;
  Order order = Order::ratio;  ///< that was kept
  std::size_t rounds = 0;
  std::size_t candidates = 0;  ///< points considered, over all rounds
  std::size_t prestars = 0;    ///< prestars searched for, also those given up early
  std::size_t inserted = 0;
  Rejections rejected;
  Remaining remaining;
  /// Circumcenters to which the boundary bars the way; a finished run brings them inside. Counted only if it
  /// ended early.
  std::size_t centers_beyond = 0;
  /// Of `inserted`, those on the boundary.
  std::size_t points_on_segments = 0;
  std::size_t points_on_patches = 0;
  /// The separation that was kept, in the units of the input: no two vertices of the result are closer, unless
  /// two of the input are.
  double separation = 0;
};

}  // namespace sinkmesh
