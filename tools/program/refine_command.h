// SPDX-License-Identifier: MIT
//
// sinkmesh refine: from a surface to a mesh of good quality.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <optional>
#include <string>

#include "refine/options.h"
#include "tools/program/exit_status.h"
#include "tools/program/files.h"

namespace sinkmesh::program {

struct RefineArguments {
  FileArguments files;
  std::optional<double> ratio;      // by dimension
  std::optional<double> min_angle;  // the same in degrees, in the plane
  std::string insert = "offsink";
  std::string order;
  std::optional<double> reach;
  std::string schedule = "incremental";
  std::string fallback = "none";
  std::string boundary = "auto";
  std::optional<double> small_angle;
  double flat = BoundaryOptions().flat;
  bool literal = false;
  bool coarsen = false;
  bool slivers = false;
  std::optional<double> min_dihedral;
  unsigned threads = 1;
  std::optional<std::size_t> max_vertices;
  std::optional<double> time_limit;
  std::string report;
  std::string history;
  bool quiet = false;
};

/// Adds the command to the program; the arguments must outlive the parsing.
CLI::App* add_refine_command(CLI::App& program, RefineArguments& arguments);

ExitStatus run(const RefineArguments& arguments);

}  // namespace sinkmesh::program
