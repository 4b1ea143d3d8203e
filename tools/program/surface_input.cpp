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

void require_sound(const Surface3& surface, const SourceLines& lines, const std::string& path) {
  for (const SurfaceDefect& defect : check_surface(surface)) {
    if (severity(defect.kind) != SurfaceSeverity::error) continue;
    const std::string message = fmt::format("{}; {} (sinkmesh inspect {} lists all defects)", defect.message,
                                            advice(defect.kind), path == "-" ? "FILE" : printable(path, 200));
    const std::size_t line = source_line(defect, lines);
    if (line == 0) throw FileError(path, message);
    throw FileError(path, line, message);
  }
}

std::size_t source_line(const SurfaceDefect& defect, const SourceLines& lines) {
  const std::size_t line = defect.facets.empty() ? 0 : lines.facet(defect.facets.front());
  if (line != 0 || defect.vertices.empty()) return line;
  return lines.point(defect.vertices.front());
}

}  // namespace sinkmesh::program
