// SPDX-License-Identifier: MIT
//
// Every reader by name, from bytes to whatever it returns, and what must hold of any result and of any refusal.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "test/support/sample_files.h"

namespace sinkmesh::test {

using Contents = std::variant<Surface2, Surface3, Mesh2, Mesh3, std::vector<Point2>, std::vector<Point3>>;

struct Reader {
  std::string_view name;  ///< of the format; a 2 at its end: in the plane
  Contents (*read)(const io_detail::Source&);
};

template <auto kDecode>
Contents read_with(const io_detail::Source& source) {
  return kDecode(source);
}
template <int Dim>
Contents read_node(const io_detail::Source& source) {
  return io_detail::decode_node<Dim>(source).points;
}
/// The points are those of the sample.
template <int Dim, auto kDecode>
Contents read_part(const io_detail::Source& source) {
  Mesh<Dim> mesh;
  mesh.points = sample_mesh<Dim>().points;
  kDecode(source, 0, mesh);
  return mesh;
}
inline Contents read_poly(const io_detail::Source& source) {
  return io_detail::decode_poly(source, std::nullopt);
}

inline constexpr std::array kReaders{
    Reader{"off", read_with<io_detail::decode_off>},
    Reader{"obj", read_with<io_detail::decode_obj>},
    Reader{"stl", read_with<io_detail::decode_stl>},
    Reader{"ply", read_with<io_detail::decode_ply>},
    Reader{"poly2", read_poly},
    Reader{"xyz", read_with<io_detail::decode_xyz<3>>},
    Reader{"xyz2", read_with<io_detail::decode_xyz<2>>},
    Reader{"node", read_node<3>},
    Reader{"node2", read_node<2>},
    Reader{"ele", read_part<3, io_detail::decode_ele<3>>},
    Reader{"ele2", read_part<2, io_detail::decode_ele<2>>},
    Reader{"face", read_part<3, io_detail::decode_face<3>>},
    Reader{"face2", read_part<2, io_detail::decode_face<2>>},
    Reader{"mesh", read_with<io_detail::decode_medit<3>>},
    Reader{"mesh2", read_with<io_detail::decode_medit<2>>},
    Reader{"msh", read_with<io_detail::decode_msh<3>>},
    Reader{"msh2", read_with<io_detail::decode_msh<2>>},
    Reader{"vtk", read_with<io_detail::decode_vtk<3>>},
    Reader{"vtk2", read_with<io_detail::decode_vtk<2>>},
    Reader{"vtu", read_with<io_detail::decode_vtu<3>>},
    Reader{"vtu2", read_with<io_detail::decode_vtu<2>>},
};

struct SampleFile {
  std::string name;
  std::string reader;
  std::string bytes;
};

/// One of every format and encoding that can be read.
inline std::vector<SampleFile> sample_files() {
  const Surface3 surface = sample_surface();
  const Mesh3 mesh = sample_mesh();
  const Mesh2 plane = sample_mesh<2>();
  return {
      {"off", "off", io_detail::encode_off(surface)},
      {"coff", "off",
       "COFF # colors\r\n3 1 0\r\n0 0 0 1 1 1 1\r\n1 0 0 1 1 1 1\r\n0 1 0 1 1 1 1\r\n3 0 1 2 255 0 0"},
      {"obj", "obj", "mtllib a.mtl\nvn 0 0 1\n" + io_detail::encode_obj(surface) + "f -1/2/3 -2//1 -3\n"},
      {"stl_text", "stl", io_detail::encode_stl(surface)},
      {"stl_binary", "stl", binary_stl(surface, "solid, and yet binary")},
      {"ply_text", "ply", text_ply(surface)},
      {"ply_little", "ply", binary_ply(surface, std::endian::little)},
      {"ply_big", "ply", binary_ply(surface, std::endian::big)},
      {"ply_written", "ply", io_detail::encode_ply(surface)},
      {"poly", "poly2", io_detail::encode_poly(sample_polygon())},
      {"poly_seeds", "poly2", io_detail::encode_poly(sample_regions())},
      {"xyz", "xyz", "x,y,z,w\n0,0,0,a\n1e0, -2.5e-3 ,+3;b\n4\t5\t6\tc\n"},
      {"xyz_plane", "xyz2", "0 0\n1 0.5\n0 1\n"},
      {"node", "node", io_detail::encode_node<3>(mesh.points)},
      {"node_plane", "node2", io_detail::encode_node<2>(plane.points)},
      {"ele", "ele", io_detail::encode_ele(mesh)},
      {"ele_plane", "ele2", io_detail::encode_ele(plane)},
      {"face", "face", io_detail::encode_face(mesh)},
      {"edge", "face2", io_detail::encode_face(plane)},
      {"medit", "mesh", io_detail::encode_medit(mesh)},
      {"medit_plane", "mesh2", io_detail::encode_medit(plane)},
      {"msh41", "msh", io_detail::encode_msh41(mesh)},
      {"msh41_plane", "msh2", io_detail::encode_msh41(plane)},
      {"msh22", "msh", io_detail::encode_msh22(mesh)},
      {"msh22_plane", "msh2", io_detail::encode_msh22(plane)},
      {"vtk_text", "vtk", io_detail::encode_vtk(mesh)},
      {"vtk_plane", "vtk2", io_detail::encode_vtk(plane)},
      {"vtk_binary_3", "vtk", binary_vtk(mesh, 3)},
      {"vtk_binary_5", "vtk", binary_vtk(mesh, 5)},
      {"vtu_written", "vtu", io_detail::encode_vtu(mesh)},
      {"vtu_plane", "vtu2", io_detail::encode_vtu(plane)},
      {"vtu_text", "vtu", vtu(mesh, VtuEncoding::text)},
      {"vtu_base64", "vtu", vtu(mesh, VtuEncoding::base64)},
      {"vtu_appended_base64", "vtu", vtu(mesh, VtuEncoding::appended_base64)},
      {"vtu_appended_raw", "vtu", vtu(mesh, VtuEncoding::appended_raw_big)},
  };
}

// ------------------------------------------------------------------------------------- what must hold

template <std::size_t Dim, class Cells>
bool are_usable(const std::vector<std::array<double, Dim>>& points, const Cells& cells) {
  return std::all_of(points.begin(), points.end(),
                     [](const auto& p) {
                       return std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); });
                     }) &&
         std::all_of(cells.begin(), cells.end(), [&](const auto& cell) {
           return std::all_of(cell.begin(), cell.end(), [&](std::uint32_t v) { return v < points.size(); });
         });
}

/// Empty, or what is wrong with the arrays.
template <std::size_t Dim>
std::string find_defect(const std::vector<std::array<double, Dim>>& points) {
  const bool is_usable = are_usable(points, std::vector<std::array<std::uint32_t, 1>>());
  return is_usable ? "" : "a coordinate that is not finite";
}
template <int Dim>
std::string find_defect(const Surface<Dim>& surface) {
  if (!are_usable(surface.points, surface.facets)) return "a coordinate not finite, or an index out of range";
  const bool fits = surface.facet_tags.empty() || surface.facet_tags.size() == surface.facets.size();
  return fits ? "" : "tags, but not one per facet";
}
template <int Dim>
std::string find_defect(const Mesh<Dim>& mesh) {
  if (!are_usable(mesh.points, mesh.simplices) || !are_usable(mesh.points, mesh.boundary))
    return "a coordinate not finite, or an index out of range";
  const auto fit = [](const auto& fields, std::size_t n) {
    return std::all_of(fields.begin(), fields.end(), [&](const auto& f) { return f.values.size() == n; });
  };
  return fit(mesh.simplex_fields, mesh.simplices.size()) && fit(mesh.boundary_fields, mesh.boundary.size())
             ? ""
             : "a field of another length than its cells";
}

/// The same for the source lines: as many as things, or none, and all of them in the file.
inline std::string find_defect(const SourceLines& lines, std::string_view bytes, const Contents& contents) {
  const auto last = static_cast<std::size_t>(
      1 + std::count_if(bytes.begin(), bytes.end(), [](char c) { return c == '\n' || c == '\r'; }));
  const auto fit = [&](const std::vector<std::size_t>& found, std::size_t n) {
    return (found.empty() || found.size() == n) &&
           std::all_of(found.begin(), found.end(), [&](std::size_t line) { return 1 <= line && line <= last; });
  };
  const bool ok = std::visit(
      [&](const auto& what) {
        if constexpr (requires { what.facets; }) {
          return fit(lines.points, what.points.size()) && fit(lines.facets, what.facets.size());
        } else if constexpr (requires { what.points; }) {
          return lines.points.empty() && lines.facets.empty();
        } else {
          return fit(lines.points, what.size()) && lines.facets.empty();
        }
      },
      contents);
  return ok ? "" : "wrong source lines";
}

/// One printable line that starts with the name of the file, says something, and does not quote the file whole.
inline std::string find_message_defect(std::string_view message, std::string_view file) {
  if (!message.starts_with(std::string(file) + ':')) return "a message that does not name the file";
  if (message.size() < file.size() + 20 || message.size() > file.size() + 400) return "a message of odd length";
  const bool is_line =
      std::all_of(message.begin(), message.end(), [](char c) { return c >= 0x20 && c < 0x7f; });
  return is_line ? "" : "a message that is not one printable line";
}

/// What a reader made of some bytes.
struct Reading {
  std::optional<Contents> contents;  ///< none: refused
  std::string message;               ///< of the refusal
  std::string defect;                ///< of either
};

inline Reading read_bytes(const Reader& reader, std::string_view bytes) {
  Reading reading;
  try {
    SourceLines lines;
    reading.contents = reader.read({bytes, "file", &lines});
    reading.defect = std::visit([](const auto& what) { return find_defect(what); }, *reading.contents);
    if (reading.defect.empty()) reading.defect = find_defect(lines, bytes, *reading.contents);
  } catch (const FileError& error) {
    reading.message = error.what();
    reading.defect = find_message_defect(reading.message, "file");
  }
  return reading;
}

inline const Reader& reader_named(std::string_view name) {
  const auto found =
      std::find_if(kReaders.begin(), kReaders.end(), [&](const Reader& r) { return r.name == name; });
  if (found == kReaders.end()) throw std::logic_error("there is no reader " + std::string(name));
  return *found;
}

}  // namespace sinkmesh::test
