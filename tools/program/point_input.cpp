// SPDX-License-Identifier: MIT
#include "tools/program/point_input.h"

#include <fmt/format.h>

#include "tools/io/read.h"

namespace sinkmesh::program {

PointInput read_point_input(const FileArguments& files, std::optional<int> dimension) {
  ReadOptions options;
  options.format = input_format(files);
  if (options.format && !supports(*options.format, FileRole::points_in, 2) &&
      !supports(*options.format, FileRole::points_in, 3)) {
    throw FileError(files.input, fmt::format("{} is no format for points: use {}", name_of(*options.format),
                                             format_names(FileRole::points_in)));
  }
  if (options.format && !supports(*options.format, FileRole::points_in, 3)) dimension = 2;
  if (dimension == 2) return read_points<2>(files.input, options);
  // Standard input cannot be read twice.
  if (dimension == 3 || files.input == "-") return read_points<3>(files.input, options);
  try {
    return read_points<3>(files.input, options);
  } catch (const FileError&) {
    try {
      return read_points<2>(files.input, options);
    } catch (const FileError&) {
      // The first error is the one to tell.
    }
    throw;
  }
}

}  // namespace sinkmesh::program
