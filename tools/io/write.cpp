// SPDX-License-Identifier: MIT
//
// Checks what is to be written, encodes it whole, and only then touches the file system.
#include "tools/io/write.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <vector>

#include "tools/io/detail/codecs.h"
#include "tools/io/detail/concat.h"
#include "tools/io/detail/file.h"
#include "tools/io/detail/references.h"
#include "tools/io/detail/shapes.h"

namespace sinkmesh {
namespace {

using io_detail::concat;

using io_detail::is_standard_stream;

Format output_format(const std::string& path, std::optional<Format> format, FileRole role, int dim) {
  if (!format && is_standard_stream(path)) {
    throw FileError("standard output", concat("it has no suffix to tell the format: name it (--format ",
                                              format_names(role, dim), ")"));
  }
  const Format result = format ? *format : format_of_path(path, role, dim);
  if (!supports(result, role, dim)) {
    throw FileError(path, concat("the format ", name_of(result), " does not hold what is to be written: use ",
                                 format_names(role, dim)));
  }
  return result;
}

template <class Cells>
void check_indices(const Cells& cells, std::size_t points, const char* what) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const std::uint32_t v : cells[i]) {
      if (v >= points) {
        throw InputError(concat(what, " ", i, " refers to point ", v, ", but there are ", points,
                                " points: it cannot be written"));
      }
    }
  }
}

template <class Field>
void check_lengths(const std::vector<Field>& fields, std::size_t count, const char* things) {
  for (const Field& field : fields) {
    if (field.values.size() != count) {
      throw InputError(concat("field '", printable(field.name), "' has ", field.values.size(), " values for ",
                              count, " ", things));
    }
  }
}

// The values that a format can hold without changing them, and what they are there.
struct ValueRange {
  std::int64_t min;
  std::int64_t max;
  const char* what;
};
constexpr std::int64_t kWhole = std::int64_t{1} << std::numeric_limits<double>::digits;
constexpr ValueRange kAttributes = {-kWhole, kWhole, "attributes, which are doubles,"};
constexpr ValueRange kTags = {std::numeric_limits<std::int32_t>::min(),
                              std::numeric_limits<std::int32_t>::max(), "32-bit tags"};

// Requires values that are those of the field, or made of them; a field that is null has none.
template <class Field>
void check_values(const Field* field, const std::vector<std::int64_t>& values, const ValueRange& range) {
  for (const std::int64_t value : values) {
    if (value < range.min || value > range.max) {
      throw InputError(concat("field '", printable(field->name), "' holds ", value, ", which does not fit the ",
                              range.what, " of this format: write .vtu instead"));
    }
  }
}

template <int Dim>
void check_fields(const Mesh<Dim>& mesh, Format format) {
  check_lengths(mesh.simplex_fields, mesh.simplices.size(), "simplices");
  check_lengths(mesh.boundary_fields, mesh.boundary.size(), "boundary facets");
  const bool is_tetgen = format == Format::tetgen;
  const bool has_references =
      is_tetgen || format == Format::medit || format == Format::msh || format == Format::msh2;
  if (!has_references) return;
  check_values(io_detail::facet_field(mesh), io_detail::facet_references(mesh), kTags);
  if (is_tetgen) {
    for (const auto& field : mesh.simplex_fields) check_values(&field, field.values, kAttributes);
  } else {
    check_values(io_detail::simplex_field(mesh), io_detail::simplex_references(mesh), kTags);
  }
}

template <int Dim>
void write_tetgen(const std::string& path, const Mesh<Dim>& mesh) {
  if (is_standard_stream(path)) {
    throw FileError("standard output", "TetGen's format is several files: give a path ending in .node");
  }
  // The companion without which the others are of no use, last.
  const std::pair<const char*, std::string> parts[] = {
      {io_detail::Shapes<Dim>::kTetgenFacets, io_detail::encode_face(mesh)},
      {".ele", io_detail::encode_ele(mesh)},
      {".node", io_detail::encode_node<Dim>(mesh.points)},
  };
  std::vector<std::unique_ptr<io_detail::OutputFile>> files;
  for (const auto& [suffix, bytes] : parts) {
    files.push_back(std::make_unique<io_detail::OutputFile>(
        std::filesystem::path(path).replace_extension(suffix).string()));
    files.back()->finish(bytes);
  }
  for (const auto& file : files) file->publish();
}

template <int Dim>
std::string encode_mesh(const Mesh<Dim>& mesh, Format format) {
  switch (format) {
    case Format::vtk:
      return io_detail::encode_vtk(mesh);
    case Format::medit:
      return io_detail::encode_medit(mesh);
    case Format::msh:
      return io_detail::encode_msh41(mesh);
    case Format::msh2:
      return io_detail::encode_msh22(mesh);
    case Format::svg:
      if constexpr (Dim == 2) return io_detail::encode_svg(mesh);
      [[fallthrough]];  // refused before: it holds no mesh in space
    default:
      return io_detail::encode_vtu(mesh);
  }
}

template <int Dim>
std::string encode_surface(const Surface<Dim>& surface, Format format) {
  if constexpr (Dim == 2) {
    return io_detail::encode_poly(surface);
  } else {
    switch (format) {
      case Format::obj:
        return io_detail::encode_obj(surface);
      case Format::stl:
        return io_detail::encode_stl(surface);
      case Format::ply:
        return io_detail::encode_ply(surface);
      default:
        return io_detail::encode_off(surface);
    }
  }
}

}  // namespace

template <int Dim>
void write_mesh(const std::string& path, const Mesh<Dim>& mesh, std::optional<Format> format) {
  const Format chosen = output_format(path, format, FileRole::mesh_out, Dim);
  check_indices(mesh.simplices, mesh.points.size(), "simplex");
  check_indices(mesh.boundary, mesh.points.size(), "boundary facet");
  check_fields(mesh, chosen);
  if (chosen == Format::tetgen) {
    write_tetgen(path, mesh);
  } else {
    io_detail::write_file(path, encode_mesh(mesh, chosen));
  }
}

template <int Dim>
void write_surface(const std::string& path, const Surface<Dim>& surface, std::optional<Format> format) {
  const Format chosen = output_format(path, format, FileRole::surface_out, Dim);
  check_indices(surface.facets, surface.points.size(), "facet");
  if (!surface.facet_tags.empty() && surface.facet_tags.size() != surface.facets.size()) {
    throw InputError(
        concat("the surface has ", surface.facet_tags.size(), " tags for ", surface.facets.size(), " facets"));
  }
  io_detail::write_file(path, encode_surface(surface, chosen));
}

template void write_mesh<2>(const std::string&, const Mesh2&, std::optional<Format>);
template void write_mesh<3>(const std::string&, const Mesh3&, std::optional<Format>);
template void write_surface<2>(const std::string&, const Surface2&, std::optional<Format>);
template void write_surface<3>(const std::string&, const Surface3&, std::optional<Format>);

}  // namespace sinkmesh
