// SPDX-License-Identifier: MIT
//
// VTK's legacy format, in text, version 3.0: the one that everything reads.
#include "tools/io/detail/codecs.h"
#include "tools/io/detail/shapes.h"
#include "tools/io/detail/text_writer.h"
#include "tools/io/detail/vtk_cells.h"

namespace sinkmesh::io_detail {
namespace {

// Names are single words; VTK spells the rest as %XX.
std::string encoded(std::string_view name) {
  static constexpr char kHex[] = "0123456789ABCDEF";
  std::string out;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte > 0x20 && byte < 0x7f && c != '%' && c != '"') {
      out += c;
    } else {
      out += {'%', kHex[byte >> 4], kHex[byte & 15]};
    }
  }
  return out.empty() ? "unnamed" : out;
}

}  // namespace

template <int Dim>
std::string encode_vtk(const Mesh<Dim>& mesh) {
  const auto facets = vtk_facets(mesh);
  const std::size_t simplices = mesh.simplices.size();
  const std::size_t cells = simplices + facets.size();
  TextWriter out;
  out << "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " << mesh.points.size()
      << " double\n";
  for (const auto& p : mesh.points) {
    out.row(p, Dim == 2 ? ' ' : '\n');
    if (Dim == 2) out << "0\n";
  }
  out << "CELLS " << cells << ' ' << simplices * (Dim + 2) + facets.size() * (Dim + 1) << '\n';
  for (const auto& s : mesh.simplices) (out << Dim + 1 << ' ').row(s);
  for (const auto& f : facets) (out << Dim << ' ').row(f);
  out << "CELL_TYPES " << cells << '\n';
  for (std::size_t i = 0; i < cells; ++i) {
    out << (i < simplices ? Shapes<Dim>::kVtkSimplex : Shapes<Dim>::kVtkFacet) << '\n';
  }
  const std::vector<VtkField> fields = vtk_fields(mesh);
  if (!fields.empty()) out << "CELL_DATA " << cells << '\n';
  for (const auto& [name, values] : fields) {
    out << "SCALARS " << encoded(name) << " long 1\nLOOKUP_TABLE default\n";
    for (const std::int64_t value : values) out << value << '\n';
  }
  return out.take();
}

template std::string encode_vtk(const Mesh2&);
template std::string encode_vtk(const Mesh3&);

}  // namespace sinkmesh::io_detail
