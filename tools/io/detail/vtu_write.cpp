// SPDX-License-Identifier: MIT
//
// VTK's XML format with the arrays appended raw: a readable head, then the bytes as they are in memory on the
// usual machines.
#include "tools/io/detail/codecs.h"
#include "tools/io/detail/concat.h"
#include "tools/io/detail/scalars.h"
#include "tools/io/detail/shapes.h"
#include "tools/io/detail/vtk_cells.h"

namespace sinkmesh::io_detail {
namespace {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      // XML turns these into blanks unless they are spelled out, and has no way to write other control
      // characters.
      case '\n':
        out += "&#10;";
        break;
      case '\t':
        out += "&#9;";
        break;
      case '\r':
        out += "&#13;";
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    }
  }
  return out;
}

// The head and the appended data, grown together.
class VtuWriter {
 public:
  explicit VtuWriter(std::size_t bytes) { data_.reserve(bytes); }

  VtuWriter& operator<<(std::string_view text) {
    head_ += text;
    return *this;
  }

  /// Announces an array of `count` values of type T, which must be appended next.
  template <class T>
  void array(const char* type, const std::string& attributes, std::size_t count) {
    head_ += concat("<DataArray type=\"", type, "\" ", attributes, " format=\"appended\" offset=\"",
                    data_.size(), "\"/>\n");
    append(static_cast<std::uint64_t>(count * sizeof(T)));
  }
  template <class T>
  void append(T value) {
    append_little(data_, value);
  }

  std::string take() && {
    head_ += "<AppendedData encoding=\"raw\">\n_";
    head_ += data_;
    head_ += "\n</AppendedData>\n</VTKFile>\n";
    return std::move(head_);
  }

 private:
  std::string head_;
  std::string data_;
};

}  // namespace

template <int Dim>
std::string encode_vtu(const Mesh<Dim>& mesh) {
  const std::size_t points = mesh.points.size();
  const std::size_t simplices = mesh.simplices.size();
  const auto facets = vtk_facets(mesh);
  const std::size_t cells = simplices + facets.size();
  const std::vector<VtkField> fields = vtk_fields(mesh);
  VtuWriter out(24 * points + (8 * (Dim + 2 + fields.size()) + 1) * cells + 1024);
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n"
         "<UnstructuredGrid>\n"
      << concat("<Piece NumberOfPoints=\"", points, "\" NumberOfCells=\"", cells, "\">\n<Points>\n");
  out.array<double>("Float64", "Name=\"Points\" NumberOfComponents=\"3\"", 3 * points);
  for (const auto& p : mesh.points) {
    for (const double x : p) out.append(x);
    if constexpr (Dim == 2) out.append(0.0);
  }
  out << "</Points>\n<Cells>\n";
  out.array<std::int64_t>("Int64", "Name=\"connectivity\"", (Dim + 1) * simplices + Dim * facets.size());
  const auto append_corners = [&](const auto& cell) {
    for (const std::uint32_t v : cell) out.append(static_cast<std::int64_t>(v));
  };
  for (const auto& s : mesh.simplices) append_corners(s);
  for (const auto& f : facets) append_corners(f);
  out.array<std::int64_t>("Int64", "Name=\"offsets\"", cells);
  std::int64_t offset = 0;
  for (std::size_t i = 0; i < cells; ++i) out.append(offset += i < simplices ? Dim + 1 : Dim);
  out.array<std::uint8_t>("UInt8", "Name=\"types\"", cells);
  for (std::size_t i = 0; i < cells; ++i) {
    out.append(static_cast<std::uint8_t>(i < simplices ? Shapes<Dim>::kVtkSimplex : Shapes<Dim>::kVtkFacet));
  }
  out << "</Cells>\n<CellData>\n";
  for (const auto& [name, values] : fields) {
    out.array<std::int64_t>("Int64", concat("Name=\"", escaped(name), "\""), cells);
    for (const std::int64_t value : values) out.append(value);
  }
  out << "</CellData>\n</Piece>\n</UnstructuredGrid>\n";
  return std::move(out).take();
}

template std::string encode_vtu(const Mesh2&);
template std::string encode_vtu(const Mesh3&);

}  // namespace sinkmesh::io_detail
