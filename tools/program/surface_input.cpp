// SPDX-License-Identifier: MIT
#include "tools/program/surface_input.h"

#include <fmt/format.h>

#include "refine/surface_check.h"

namespace sinkmesh::program {

Surface3 read_surface_input(const FileArguments& files, SourceLines& lines) {
  const std::optional<Format> format = input_format(files);
  const std::string known = format_names(FileRole::surface_in);
  if (format && !supports(*format, FileRole::surface_in, 3)) {
    if (supports(*format, FileRole::surface_in, 2)) {
      throw FileError(files.input,
                      fmt::format("is a polygon in the plane, and refine needs a closed surface in space ({}); "
                                  "sinkmesh delaunay takes the vertices of a polygon",
                                  known));
    }
    if (supports(*format, FileRole::points_in)) {
      throw FileError(
          files.input,
          fmt::format("holds points, and refine needs a closed surface ({}); sinkmesh delaunay takes points",
                      known));
    }
    throw FileError(files.input, fmt::format("is a mesh, and refine needs a closed surface ({})", known));
  }
  return read_surface<3>(files.input, {format, &lines});
}

}  // namespace sinkmesh::program
