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

/// A number that is not below `least`; the text says why not.
CLI::Validator at_least(double least, const std::string& why = "");

}  // namespace sinkmesh::program
