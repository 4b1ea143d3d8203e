// SPDX-License-Identifier: MIT
//
// What is done to a refined mesh, and what came of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "refine/options.h"

namespace sinkmesh {

/// Why a simplex with an angle below the target remains, in the order in which reasons are looked for.
enum class SliverReason : std::uint8_t {
  boundary_vertices,  ///< all its vertices are on the boundary: none can be moved
  untried,            ///< the run ended before
  no_better_place,    ///< nowhere that was tried a vertex of it does better
};
inline constexpr std::array kSliverReasons = {SliverReason::boundary_vertices, SliverReason::untried,
                                              SliverReason::no_better_place};

/// One simplex with an angle below the target.
template <int Dim>
struct Sliver {
  std::array<std::uint32_t, Dim + 1> corners{};  ///< points of the mesh
  double angle = 0;                              ///< the smallest, in degrees
  SliverReason reason = SliverReason::untried;
};

struct CoarsenResult {
  std::size_t tried = 0;    ///< inner Steiner points looked at, some more than once
  std::size_t removed = 0;  ///< of them
  Stop stop = Stop::no_candidate;
};

struct SliverResult {
  std::size_t tried = 0;     ///< vertices taken out, most of them to be put back
  std::size_t moved = 0;     ///< put back elsewhere
  std::size_t removed = 0;   ///< not put back
  std::size_t inserted = 0;  ///< new ones, to take slivers away
  /// Sums of SliverCost over the mesh.
  std::int64_t cost_before = 0;
  std::int64_t cost_after = 0;
  Stop stop = Stop::no_candidate;
};

struct Improvement {
  CoarsenResult coarsening;
  SliverResult moving;
  Remaining remaining;  ///< simplices of low quality after it

  Stop stop() const { return coarsening.stop != Stop::no_candidate ? coarsening.stop : moving.stop; }
};

/// As reports name them.
const char* name(SliverReason reason);

}  // namespace sinkmesh
