// SPDX-License-Identifier: MIT
//
// From a path to a format, from the format to its codec; and what every result must have.
#include "tools/io/read.h"

#include <filesystem>
#include <type_traits>

#include "tools/io/detail/codecs.h"
#include "tools/io/detail/concat.h"
#include "tools/io/detail/file.h"
#include "tools/io/detail/shapes.h"

namespace sinkmesh {
namespace {

using io_detail::concat;

using io_detail::file_exists;
using io_detail::is_standard_stream;
using io_detail::read_file;
using io_detail::Source;

std::string name_for_messages(const std::string& path) {
  return is_standard_stream(path) ? "standard input" : path;
}

// Standard input has no suffix, but most formats say at once what they are.
std::optional<Format> format_of_bytes(std::string_view bytes) {
  constexpr std::size_t kFirstBytes = 256;
  const std::string_view first = bytes.substr(0, kFirstBytes);
  const auto holds = [&](std::string_view word) { return first.find(word) != std::string_view::npos; };
  if (first.starts_with("ply")) return Format::ply;
  if (first.starts_with("solid")) return Format::stl;
  if (holds("<VTKFile")) return Format::vtu;
  if (holds("# vtk DataFile")) return Format::vtk;
  if (holds("MeshVersionFormatted")) return Format::medit;
  if (holds("$MeshFormat")) return Format::msh;
  if (first.substr(0, first.find_first_of(" \t\r\n")).ends_with("OFF")) return Format::off;
  return std::nullopt;
}

// A file read whole, and its format.
struct Input {
  Input(const std::string& path, const ReadOptions& options, FileRole role, int dim)
      : file(name_for_messages(path)) {
    if (options.lines != nullptr) *options.lines = {};
    if (options.format) {
      format = *options.format;
    } else if (!is_standard_stream(path)) {
      format = format_of_path(path, role, dim);
    }
    bytes = read_file(path);
    if (!options.format && is_standard_stream(path)) {
      const auto guess = format_of_bytes(bytes);
      if (!guess) {
        throw FileError(file, concat("its format cannot be told from its first bytes: name it (--format ",
                                     format_names(role, dim), ")"));
      }
      format = *guess;
    }
    if (!supports(format, role, dim)) {
      throw FileError(file, concat("the format ", name_of(format), " does not hold what is wanted here: use ",
                                   format_names(role, dim)));
    }
  }

  Source source(SourceLines* lines = nullptr) const { return {bytes, file, lines}; }

  std::string file;
  std::string bytes;
  Format format{};
};

// The path of a companion file.
std::string with_suffix(const std::string& path, const char* suffix) {
  return std::filesystem::path(path).replace_extension(suffix).string();
}

template <int Dim>
Surface<Dim> decode_surface(const Input& input, const std::string& path, SourceLines* lines) {
  const Source source = input.source(lines);
  if constexpr (Dim == 2) {
    const std::string node_path = with_suffix(path, ".node");
    if (is_standard_stream(path) || !file_exists(node_path))
      return io_detail::decode_poly(source, std::nullopt);
    const std::string nodes = read_file(node_path);
    return io_detail::decode_poly(source, Source{nodes, node_path});
  } else {
    switch (input.format) {
      case Format::obj:
        return io_detail::decode_obj(source);
      case Format::stl:
        return io_detail::decode_stl(source);
      case Format::ply:
        return io_detail::decode_ply(source);
      default:
        return io_detail::decode_off(source);
    }
  }
}

// The three files are named after one of them; the simplices are in .ele, the facets, if any, beside it.
template <int Dim>
Mesh<Dim> read_tetgen(const std::string& path) {
  if (is_standard_stream(path)) {
    throw FileError(name_for_messages(path),
                    "TetGen's format is several files: give the path of the .node file");
  }
  const auto read = [&](const char* suffix, auto decode) {
    const std::string file = with_suffix(path, suffix);
    const std::string bytes = read_file(file);
    return decode(Source{bytes, file});
  };
  auto nodes = read(".node", [](const Source& source) { return io_detail::decode_node<Dim>(source); });
  Mesh<Dim> mesh;
  mesh.points = std::move(nodes.points);
  read(".ele", [&](const Source& source) { io_detail::decode_ele<Dim>(source, nodes.first, mesh); });
  const char* const facets = io_detail::Shapes<Dim>::kTetgenFacets;
  if (file_exists(with_suffix(path, facets))) {
    read(facets, [&](const Source& source) { io_detail::decode_face<Dim>(source, nodes.first, mesh); });
  }
  return mesh;
}

template <int Dim>
Mesh<Dim> decode_mesh(const Input& input) {
  switch (input.format) {
    case Format::vtk:
      return io_detail::decode_vtk<Dim>(input.source());
    case Format::medit:
      return io_detail::decode_medit<Dim>(input.source());
    case Format::msh:
    case Format::msh2:
      return io_detail::decode_msh<Dim>(input.source());
    default:
      return io_detail::decode_vtu<Dim>(input.source());
  }
}

bool names_tetgen(const std::string& path, const ReadOptions& options, int dim) {
  if (options.format) return *options.format == Format::tetgen;
  return !is_standard_stream(path) && format_of_path(path, FileRole::mesh_in, dim) == Format::tetgen;
}

}  // namespace

template <int Dim>
Surface<Dim> read_surface(const std::string& path, const ReadOptions& options) {
  const Input input(path, options, FileRole::surface_in, Dim);
  Surface<Dim> surface = decode_surface<Dim>(input, path, options.lines);
  if (surface.facets.empty()) {
    throw FileError(input.file,
                    concat("the file holds no ", io_detail::Shapes<Dim>::kFacet, ": a surface is needed here"));
  }
  return surface;
}

template <int Dim>
std::vector<Point<Dim>> read_points(const std::string& path, const ReadOptions& options) {
  const Input input(path, options, FileRole::points_in, Dim);
  std::vector<Point<Dim>> points;
  switch (input.format) {
    case Format::xyz:
      points = io_detail::decode_xyz<Dim>(input.source(options.lines));
      break;
    case Format::tetgen:
      points = io_detail::decode_node<Dim>(input.source(options.lines)).points;
      break;
    default:
      points = decode_surface<Dim>(input, path, options.lines).points;
  }
  if (points.empty()) throw FileError(input.file, "the file holds no point: at least one is needed");
  return points;
}

template <int Dim>
Mesh<Dim> read_mesh(const std::string& path, const ReadOptions& options) {
  Mesh<Dim> mesh;
  if (names_tetgen(path, options, Dim)) {
    mesh = read_tetgen<Dim>(path);
  } else {
    mesh = decode_mesh<Dim>(Input(path, options, FileRole::mesh_in, Dim));
  }
  if (mesh.simplices.empty()) {
    throw FileError(name_for_messages(path),
                    concat("the file holds no ", io_detail::Shapes<Dim>::kSimplex, ": a mesh is needed here"));
  }
  return mesh;
}

template Surface2 read_surface<2>(const std::string&, const ReadOptions&);
template Surface3 read_surface<3>(const std::string&, const ReadOptions&);
template std::vector<Point2> read_points<2>(const std::string&, const ReadOptions&);
template std::vector<Point3> read_points<3>(const std::string&, const ReadOptions&);
template Mesh2 read_mesh<2>(const std::string&, const ReadOptions&);
template Mesh3 read_mesh<3>(const std::string&, const ReadOptions&);

}  // namespace sinkmesh
