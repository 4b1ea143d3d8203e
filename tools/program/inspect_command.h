// SPDX-License-Identifier: MIT
//
// sinkmesh inspect: what a surface or a mesh is, and everything that is wrong with it.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "tools/program/exit_status.h"
#include "tools/program/files.h"

namespace sinkmesh::program {

struct InspectArguments {
  FileArguments files;          // no output
  std::optional<double> ratio;  // by dimension
  std::string report;
};

/// Adds the command to the program; the arguments must outlive the parsing.
CLI::App* add_inspect_command(CLI::App& program, InspectArguments& arguments);

ExitStatus run(const InspectArguments& arguments);

}  // namespace sinkmesh::program
