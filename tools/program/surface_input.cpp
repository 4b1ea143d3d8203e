// SPDX-License-Identifier: MIT
#include "tools/program/surface_input.h"

#include <fmt/format.h>

#include "refine/surface_check.h"

namespace sinkmesh::program {

int surface_dimension(const FileArguments& files) {
  const std::optional<Format> format = input_format(files);
  if (!format || supports(*format, FileRole::surface_in, 3)) return 3;
  if (supports(*format, FileRole::surface_in, 2)) return 2;
  const std::string known = format_names(FileRole::surface_in);
  if (supports(*format, FileRole::points_in)) {
    throw FileError(
        files.input,
        fmt::format("holds points, and refine needs a closed surface ({}); sinkmesh delaunay takes points",
                    known));
  }
  throw FileError(files.input, fmt::format("is a mesh, and refine needs a closed surface ({})", known));
}

template <int Dim>
Surface<Dim> read_surface_input(const FileArguments& files, SourceLines& lines) {
  return read_surface<Dim>(files.input, {input_format(files), &lines});
}

template <int Dim>
void require_sound(const Surface<Dim>& surface, const SourceLines& lines, const std::string& path) {
  for (const SurfaceDefect& defect : check_surface(surface, SurfaceChecks::without_intersections)) {
    if (severity(defect.kind) != SurfaceSeverity::error) continue;
    const std::string message = fmt::format("{}; {} (sinkmesh inspect {} lists all defects)", defect.message,
                                            advice(defect.kind), path == "-" ? "FILE" : printable(path, 200));
    throw error_at(path, source_line(defect, lines), message);
  }
}

FileError error_at(const std::string& path, std::size_t line, const std::string& message) {
  const std::string name = path == "-" ? "standard input" : path;
  return line == 0 ? FileError(name, message) : FileError(name, line, message);
}

std::size_t source_line(const SurfaceDefect& defect, const SourceLines& lines) {
  const std::size_t line = defect.facets.empty() ? 0 : lines.facet(defect.facets.front());
  if (line != 0 || defect.vertices.empty()) return line;
  return lines.point(defect.vertices.front());
}

std::size_t seed_line(const SeedError& error, const SourceLines& lines) {
  return error.kind() == SeedError::Kind::hole ? lines.hole(error.seed()) : lines.region(error.seed());
}

template Surface2 read_surface_input<2>(const FileArguments&, SourceLines&);
template Surface3 read_surface_input<3>(const FileArguments&, SourceLines&);
template void require_sound(const Surface2&, const SourceLines&, const std::string&);
template void require_sound(const Surface3&, const SourceLines&, const std::string&);

}  // namespace sinkmesh::program
