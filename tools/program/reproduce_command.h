// SPDX-License-Identifier: MIT
//
// sinkmesh reproduce: the tables and figures of the paper, ours beside its.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "tools/program/exit_status.h"

namespace sinkmesh::program {

struct ReproduceArguments {
  std::string folder = "reproduction";
  bool quiet = false;
};

/// Adds the command to the program; the arguments must outlive the parsing.
CLI::App* add_reproduce_command(CLI::App& program, ReproduceArguments& arguments);

ExitStatus run(const ReproduceArguments& arguments);

}  // namespace sinkmesh::program
