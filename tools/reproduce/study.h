// SPDX-License-Identifier: MIT
//
// The experiments of [EG01, 5]: which model is refined how, and what comes of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "refine/options.h"
#include "refine/surface.h"

namespace sinkmesh::reproduce {

/// One way to refine a model.
struct Plan {
  Insert insert = Insert::sink;
  Schedule schedule = Schedule::incremental;
  bool literal = false;
};

/// "parallel, literal"
std::string schedule_text(const Plan& plan);

/// A mesh in numbers.
struct MeshNumbers {
  std::size_t simplices = 0;
  std::size_t low_quality = 0;
  double ratio_min = 0;
  double ratio_avg = 0;
  double ratio_max = 0;
};

/// The mesh after a round, and what happened in it. Round 0: before anything.
struct Round {
  MeshNumbers mesh;
  std::size_t candidates = 0;
  std::size_t passed_boundary = 0;
  std::size_t inserted = 0;
};

struct Run {
  Plan plan;
  MeshNumbers mesh;  ///< at the end
  RefineResult result;
  std::vector<Round> rounds;
  std::uint64_t hash = 0;
  /// Of the refinement alone, without what the observer costs.
  double cpu_seconds = 0;
};

/// How well the points for the low-quality simplices of the initial mesh can be computed in plain doubles: the
/// largest distance between the rounded formula and the exact circumcenter, in units of the circumradius.
struct Conditioning {
  double sinks = 0;
  double circumcenters = 0;
};

/// A model and its runs.
struct Study {
  std::string model;
  double max_ratio = 2;
  int dimension = 3;
  std::size_t facets = 0;  ///< of the surface
  MeshNumbers surface;     ///< r/l of its facets; in the plane all are 1/2
  MeshNumbers initial;     ///< the stable subcomplex inside
  std::size_t sinks = 0;   ///< in it
  Conditioning conditioning;
  std::vector<Run> runs;

  /// @throws std::out_of_range if there is no such run.
  const Run& run(const Plan& plan) const;
};

/// What is known of the model before it is refined. Requires a surface whose facets are Delaunay.
template <int Dim>
Study begin_study(const std::string& model, const Surface<Dim>& surface, double max_ratio);

/// Refines the model. Deterministic, but for the time.
template <int Dim>
Run refine_as(const Surface<Dim>& surface, double max_ratio, const Plan& plan);

}  // namespace sinkmesh::reproduce
