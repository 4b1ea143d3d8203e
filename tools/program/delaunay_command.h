// SPDX-License-Identifier: MIT
//
// sinkmesh delaunay: the Delaunay triangulation of points.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "tools/program/exit_status.h"
#include "tools/program/files.h"

namespace sinkmesh::program {

struct DelaunayArguments {
  FileArguments files;
  std::optional<int> dimension;
  std::string engine = "star";
  bool flow = false;
  std::string report;
  bool quiet = false;
};

/// Adds the command to the program; the arguments must outlive the parsing.
CLI::App* add_delaunay_command(CLI::App& program, DelaunayArguments& arguments);

ExitStatus run(const DelaunayArguments& arguments);

}  // namespace sinkmesh::program
