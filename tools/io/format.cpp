// SPDX-License-Identifier: MIT
//
// One table of formats; everything else asks it.
#include "tools/io/format.h"

#include <algorithm>
#include <cctype>

#include "tools/io/detail/concat.h"
#include "tools/io/file_error.h"

namespace sinkmesh {
namespace {

using io_detail::concat;

// Roles as bits, for space and for the plane.
constexpr unsigned bit(FileRole role) { return 1U << static_cast<unsigned>(role); }
constexpr unsigned kSurface = bit(FileRole::surface_in) | bit(FileRole::surface_out);
constexpr unsigned kPoints = bit(FileRole::points_in);
constexpr unsigned kMesh = bit(FileRole::mesh_in) | bit(FileRole::mesh_out);

struct Row {
  Format format;
  std::string_view name;
  std::vector<std::string_view> suffixes;
  unsigned in_space;
  unsigned in_plane;
};

const std::vector<Row>& table() {
  static const std::vector<Row> rows = {
      {Format::off, "off", {".off"}, kSurface | kPoints, 0},
      {Format::obj, "obj", {".obj"}, kSurface | kPoints, 0},
      {Format::stl, "stl", {".stl"}, kSurface | kPoints, 0},
      {Format::ply, "ply", {".ply"}, kSurface | kPoints, 0},
      {Format::poly, "poly", {".poly"}, 0, kSurface | kPoints},
      {Format::xyz, "xyz", {".xyz", ".csv"}, kPoints, kPoints},
      {Format::vtu, "vtu", {".vtu"}, kMesh, kMesh},
      {Format::vtk, "vtk", {".vtk"}, kMesh, kMesh},
      {Format::medit, "mesh", {".mesh"}, kMesh, kMesh},
      {Format::msh, "msh", {".msh"}, kMesh, kMesh},
      {Format::msh2, "msh2", {}, kMesh, kMesh},
      {Format::tetgen, "node", {".node", ".ele", ".face", ".edge"}, kMesh | kPoints, kMesh | kPoints},
      {Format::svg, "svg", {".svg"}, 0, bit(FileRole::mesh_out)},
  };
  return rows;
}

const Row& row_of(Format format) { return table()[static_cast<std::size_t>(format)]; }

std::string lower_suffix(const std::string& path) {
  const std::size_t start = path.find_last_of("./");
  if (start == std::string::npos || path[start] != '.') return {};
  std::string suffix = path.substr(start);
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return suffix;
}

const char* phrase(FileRole role) {
  switch (role) {
    case FileRole::surface_in:
      return "a surface can be read from";
    case FileRole::points_in:
      return "points can be read from";
    case FileRole::mesh_in:
      return "a mesh can be read from";
    case FileRole::surface_out:
      return "a surface can be written as";
    case FileRole::mesh_out:
      return "a mesh can be written as";
  }
  return "";
}

std::string list(const std::vector<std::string_view>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i != 0) out += i + 1 == words.size() ? " or " : ", ";
    out += words[i];
  }
  return out;
}

std::vector<std::string_view> names(FileRole role, int dim) {
  std::vector<std::string_view> result;
  for (const Row& row : table()) {
    if (supports(row.format, role, dim)) result.push_back(row.name);
  }
  return result;
}

std::string suffix_names(FileRole role, int dim) {
  std::vector<std::string_view> result;
  for (const Row& row : table()) {
    if (supports(row.format, role, dim)) {
      result.insert(result.end(), row.suffixes.begin(), row.suffixes.end());
    }
  }
  return list(result);
}

}  // namespace

bool supports(Format format, FileRole role, int dim) {
  const Row& row = row_of(format);
  return ((dim == 2 ? row.in_plane : row.in_space) & bit(role)) != 0;
}

std::string_view name_of(Format format) { return row_of(format).name; }

std::string format_names(FileRole role, int dim) { return list(names(role, dim)); }

Format format_from_name(std::string_view name) {
  std::vector<std::string_view> known;
  for (const Row& row : table()) {
    const auto is_suffix = [&](std::string_view suffix) { return suffix.substr(1) == name; };
    if (name == row.name || std::any_of(row.suffixes.begin(), row.suffixes.end(), is_suffix)) return row.format;
    known.push_back(row.name);
  }
  throw InputError(concat("no format is called '", printable(name), "': choose ", list(known)));
}

Format format_of_path(const std::string& path, FileRole role, int dim) {
  const std::string suffix = lower_suffix(path);
  const std::string choices = concat(phrase(role), " ", suffix_names(role, dim));
  for (const Row& row : table()) {
    if (std::find(row.suffixes.begin(), row.suffixes.end(), suffix) == row.suffixes.end()) continue;
    if (supports(row.format, role, dim)) return row.format;
    throw FileError(path, concat("the format of ", suffix, " files does not fit here: ", choices));
  }
  const std::string what = suffix.empty() ? "the name has no suffix to tell the format"
                                          : concat("unknown suffix ", printable(suffix));
  throw FileError(path, concat(what, ": ", choices, "; or name the format (--format)"));
}

}  // namespace sinkmesh
