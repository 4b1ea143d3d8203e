// SPDX-License-Identifier: MIT
//
// What refinement is asked to do, and what it says it has done.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>

#include "refine/quality.h"

namespace sinkmesh {

/// Which point is inserted to remove a simplex of low quality.
enum class Insert : std::uint8_t {
  sink,          ///< the sinks of the simplex: where its circumcenter flows to [EG01, 4.3]
  circumcenter,  ///< its own circumcenter
};

/// When points are inserted [EG01, 4.5].
enum class Schedule : std::uint8_t {
  incremental,  ///< one by one, the worst ratio first
  block,        ///< in rounds; spheres of one round are mutually orthogonal or further
  parallel,     ///< in rounds; closed prestars of one round are disjoint
};

/// What to do with a simplex of low quality whose sinks are all rejected.
enum class Fallback : std::uint8_t {
  none,          ///< leave it, as in the paper
  circumcenter,  ///< try its own circumcenter
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
  Insert insert = Insert::sink;
  Schedule schedule = Schedule::incremental;
  /// Block and parallel: the paper's own rounds, which test the prestar of every candidate before they choose.
  /// The mesh is the same; the counts show what the pruned rounds save.
  bool literal = false;
  Fallback fallback = Fallback::none;
  /// Not used so far: every refinement runs on the thread of the caller. The mesh will not depend on it.
  unsigned threads = 1;
  /// Budgets; when one is spent the run ends with a valid mesh.
  std::size_t max_vertices = std::numeric_limits<std::size_t>::max();
  std::size_t max_bytes = std::numeric_limits<std::size_t>::max();
  /// Polled about every hundred candidates. May be empty.
  std::function<Continue()> should_continue = {};
  /// Called after each round. May be empty.
  std::function<void(const Progress&)> observer = {};
};

/// @throws InputError if max_ratio is below 1 or not a number, or if `literal` is asked of the incremental
///         schedule.
void require_valid(const RefineOptions& options);

/// Why a refinement ended.
enum class Stop : std::uint8_t {
  no_candidate,  ///< nothing is left to insert
  budget,
  cancelled,
};

/// As options of the program and reports name them.
const char* name(Insert insert);
const char* name(Schedule schedule);
const char* name(Stop stop);

/// Points that were considered and not inserted, by the first reason found. A point that is refused more than
/// once (its simplex died, another has the same center) counts each time.
struct Rejections {
  std::size_t boundary = 0;  ///< in the diametral sphere of a boundary facet in the closure of its prestar
  std::size_t crossing = 0;  ///< its prestar would reach through the boundary
  /// Nearer to a vertex than the input vertices are to each other, or lost by rounding.
  std::size_t separation = 0;
  std::size_t dependent = 0;  ///< not independent of a point of the same round
};

/// Simplices of low quality that remain, each with one reason: the first in this order that applies.
struct Remaining {
  /// Has a boundary facet whose own r/l exceeds the bound: nothing inside can mend it.
  std::size_t boundary_facet = 0;
  std::size_t boundary = 0;  ///< a point for it was rejected for this reason ...
  std::size_t crossing = 0;
  std::size_t separation = 0;
  std::size_t omega = 0;    ///< flows to the outside only
  std::size_t untried = 0;  ///< the run ended before

  std::size_t total() const { return boundary_facet + boundary + crossing + separation + omega + untried; }
};

struct RefineResult {
  Stop stop = Stop::no_candidate;
  std::size_t rounds = 0;
  std::size_t candidates = 0;  ///< points considered, over all rounds
  std::size_t prestars = 0;    ///< prestars searched for, also those given up early
  std::size_t inserted = 0;
  Rejections rejected;
  Remaining remaining;
  /// The separation that was kept: no two vertices of the result are closer, in the units of the input.
  double separation = 0;
};

}  // namespace sinkmesh
