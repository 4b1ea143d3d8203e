// SPDX-License-Identifier: MIT
//
// sinkmesh generate: the paper's models.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "tools/program/exit_status.h"
#include "tools/program/files.h"

namespace sinkmesh::program {

struct GenerateArguments {
  std::string name;
  FileArguments files;  // no input
  std::optional<std::int64_t> triangles;
  bool quiet = false;
};

/// Adds the command to the program; the arguments must outlive the parsing.
CLI::App* add_generate_command(CLI::App& program, GenerateArguments& arguments);

ExitStatus run(const GenerateArguments& arguments);

}  // namespace sinkmesh::program
