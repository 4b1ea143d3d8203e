// SPDX-License-Identifier: MIT
//
// What is known about the files of a command before anything is computed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/io/format.h"

namespace sinkmesh::program {

/// INPUT and OUTPUT of a command, and the names given to --input-format and --format; empty if they were not.
struct FileArguments {
  std::string input;
  std::string output;
  std::string input_format;
  std::string output_format;
};

/// The format of INPUT, nothing if its content has to tell: standard input, without a format given.
/// @throws UsageError for a name that is no format.
std::optional<Format> input_format(const FileArguments& files);

/// The format of INPUT by its suffix alone, whatever it is good for; nothing for an unknown suffix.
std::optional<Format> format_by_suffix(const std::string& path);

/// The format of OUTPUT, which must be one for meshes, or surfaces, of this dimension.
/// @throws UsageError that lists them, otherwise.
Format output_format(const FileArguments& files, int dim, FileRole role = FileRole::mesh_out);

/// A file that a command writes beside OUTPUT, and the option that names it; an empty path is none.
struct SideOutput {
  const char* option;
  std::string path;
};
/// @throws UsageError if one of them is INPUT, OUTPUT (with the companion files of TetGen's format), or
///         another.
void require_distinct(const FileArguments& files, const std::vector<SideOutput>& side_outputs);

/// Finds out whether a file could be written now, so that no long computation is lost; leaves no trace.
/// Standard output, devices and pipes are taken on trust. An empty path is no file.
/// @throws FileError
void check_writable(const std::string& path);

}  // namespace sinkmesh::program
