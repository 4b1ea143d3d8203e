// SPDX-License-Identifier: MIT
//
// Pieces of the command line that several commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "tools/program/files.h"

namespace sinkmesh::program {

/// INPUT, --output, --format, --input-format.
void add_file_options(CLI::App& command, FileArguments& files, const std::string& input_help);
void add_report_option(CLI::App& command, std::string& path);

/// Numbers within a limit; the text says why.
CLI::Validator at_least(double limit, const std::string& why = "");
CLI::Validator above(double limit, const std::string& why = "");
CLI::Validator at_most(double limit, const std::string& why = "");
CLI::Validator below(double limit, const std::string& why = "");

/// The bound on r/l in this dimension, unless another one is asked for: in the plane no angle below 30 degrees.
constexpr double default_ratio(int dim) { return dim == 2 ? 1 : 2; }
/// For help on an option that has it.
constexpr const char* kDefaultRatioText = "2; in the plane 1";

}  // namespace sinkmesh::program
