// SPDX-License-Identifier: MIT
//
// Gmsh's .msh in text, versions 4.1 and 2.2. The first field becomes the physical tag; in 4.1, tags belong to
// entities, so there is one entity per value. Element tags count the facets first, then the simplices in order,
// which is how a reader recovers the order.
#include <algorithm>

#include "tools/io/detail/codecs.h"
#include "tools/io/detail/shapes.h"
#include "tools/io/detail/text_writer.h"

namespace sinkmesh::io_detail {
namespace {

template <int Dim>
void append_coordinates(TextWriter& out, const Point<Dim>& p) {
  out.row(p, Dim == 2 ? ' ' : '\n');
  if (Dim == 2) out << "0\n";
}

template <class Cell>
void append_cell(TextWriter& out, const Cell& cell) {
  for (const std::uint32_t v : cell) out << ' ' << std::uint64_t{v} + 1;
  out << '\n';
}

template <int Dim>
std::vector<std::int64_t> physical_tags(const Mesh<Dim>& mesh) {
  return mesh.simplex_fields.empty() ? std::vector<std::int64_t>(mesh.simplices.size(), 0)
                                     : mesh.simplex_fields.front().values;
}

template <int Dim>
void append_box(TextWriter& out, const Box<Dim>& box) {
  for (const Point<Dim>& corner : {box.low, box.high}) {
    for (const double x : corner) out << ' ' << x;
    if (Dim == 2) out << " 0";
  }
}

// One entity for the boundary, and one per physical tag for the simplices.
template <int Dim>
void append_entities(TextWriter& out, const Mesh<Dim>& mesh, const std::vector<std::int64_t>& tags) {
  Box<Dim> box;
  for (const auto& p : mesh.points) box.include(p);
  const int has_boundary = mesh.boundary.empty() ? 0 : 1;
  out << "$Entities\n0 " << (Dim == 2 ? has_boundary : 0) << ' ';
  if (Dim == 2) {
    out << tags.size() << " 0\n";
  } else {
    out << has_boundary << ' ' << tags.size() << '\n';
  }
  if (has_boundary != 0) {
    out << '1';
    append_box(out, box);
    out << " 0 0\n";
  }
  for (std::size_t i = 0; i < tags.size(); ++i) {
    out << i + 1;
    append_box(out, box);
    if (tags[i] == 0) {
      out << " 0";
    } else {
      out << " 1 " << tags[i];
    }
    if (has_boundary != 0) {
      out << " 1 1\n";
    } else {
      out << " 0\n";
    }
  }
  out << "$EndEntities\n";
}

}  // namespace

template <int Dim>
std::string encode_msh41(const Mesh<Dim>& mesh) {
  const std::size_t points = mesh.points.size();
  const std::size_t facets = mesh.boundary.size();
  const std::size_t simplices = mesh.simplices.size();
  const std::vector<std::int64_t> tag_of = physical_tags(mesh);
  std::vector<std::int64_t> tags = tag_of;
  std::sort(tags.begin(), tags.end());
  tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
  std::vector<std::vector<std::size_t>> members(tags.size());
  for (std::size_t i = 0; i < simplices; ++i) {
    const auto entity = std::lower_bound(tags.begin(), tags.end(), tag_of[i]) - tags.begin();
    members[static_cast<std::size_t>(entity)].push_back(i);
  }

  TextWriter out;
  out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  append_entities(out, mesh, tags);
  out << "$Nodes\n1 " << points << " 1 " << points << '\n' << Dim << " 1 0 " << points << '\n';
  for (std::size_t i = 1; i <= points; ++i) out << i << '\n';
  for (const auto& p : mesh.points) append_coordinates<Dim>(out, p);
  out << "$EndNodes\n$Elements\n"
      << tags.size() + (facets != 0 ? 1 : 0) << ' ' << facets + simplices << " 1 " << facets + simplices
      << '\n';
  if (facets != 0) out << Dim - 1 << " 1 " << Shapes<Dim>::kGmshFacet << ' ' << facets << '\n';
  for (std::size_t i = 0; i < facets; ++i) append_cell(out << i + 1, mesh.boundary[i]);
  for (std::size_t entity = 0; entity < tags.size(); ++entity) {
    out << Dim << ' ' << entity + 1 << ' ' << Shapes<Dim>::kGmshSimplex << ' ' << members[entity].size()
        << '\n';
    for (const std::size_t i : members[entity]) append_cell(out << facets + i + 1, mesh.simplices[i]);
  }
  out << "$EndElements\n";
  return out.take();
}

template <int Dim>
std::string encode_msh22(const Mesh<Dim>& mesh) {
  const std::size_t facets = mesh.boundary.size();
  const std::vector<std::int64_t> tag_of = physical_tags(mesh);
  TextWriter out;
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << mesh.points.size() << '\n';
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    append_coordinates<Dim>(out << i + 1 << ' ', mesh.points[i]);
  out << "$EndNodes\n$Elements\n" << facets + mesh.simplices.size() << '\n';
  for (std::size_t i = 0; i < facets; ++i) {
    append_cell(out << i + 1 << ' ' << Shapes<Dim>::kGmshFacet << " 2 0 1", mesh.boundary[i]);
  }
  for (std::size_t i = 0; i < mesh.simplices.size(); ++i) {
    append_cell(out << facets + i + 1 << ' ' << Shapes<Dim>::kGmshSimplex << " 2 " << tag_of[i] << " 1",
                mesh.simplices[i]);
  }
  out << "$EndElements\n";
  return out.take();
}

template std::string encode_msh41(const Mesh2&);
template std::string encode_msh41(const Mesh3&);
template std::string encode_msh22(const Mesh2&);
template std::string encode_msh22(const Mesh3&);

}  // namespace sinkmesh::io_detail
