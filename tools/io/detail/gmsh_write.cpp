// SPDX-License-Identifier: MIT
//
// Gmsh's .msh in text, versions 4.1 and 2.2. One field becomes the physical tag (see references.h); tags
// belong to entities, so there is one entity per value. Element tags count the facets first, then the
// simplices in order, which is how a reader recovers the order.
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "tools/io/detail/codecs.h"
#include "tools/io/detail/references.h"
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

// Cells by their physical tags, each of which is one entity; entities count from 1.
class Entities {
 public:
  explicit Entities(std::vector<std::int64_t> tag_of) : tag_of_(std::move(tag_of)), tags_(tag_of_) {
    std::sort(tags_.begin(), tags_.end());
    tags_.erase(std::unique(tags_.begin(), tags_.end()), tags_.end());
    members_.resize(tags_.size());
    for (std::size_t i = 0; i < tag_of_.size(); ++i) members_[entity_of(i) - 1].push_back(i);
  }

  std::size_t size() const { return tags_.size(); }
  bool has_physical() const { return tags_.size() > 1 || (tags_.size() == 1 && tags_.front() != 0); }

  /// Rows of the section $Entities. What bounds an entity is left open, as Gmsh does for meshes without
  /// geometry.
  template <int Dim>
  void append_rows(TextWriter& out, const Box<Dim>& box, bool with_physical) const {
    for (std::size_t entity = 1; entity <= tags_.size(); ++entity) {
      out << entity;
      for (const Point<Dim>& corner : {box.low, box.high}) {
        for (const double x : corner) out << ' ' << x;
        if (Dim == 2) out << " 0";
      }
      if (with_physical) {
        out << " 1 " << tags_[entity - 1] << " 0\n";
      } else {
        out << " 0 0\n";
      }
    }
  }

  /// Blocks of the section $Elements of version 4.1; cell i has the number `offset` + i + 1.
  template <class Cell>
  void append_blocks(TextWriter& out, int dim, int type, const std::vector<Cell>& cells,
                     std::size_t offset) const {
    for (std::size_t entity = 1; entity <= tags_.size(); ++entity) {
      const std::vector<std::size_t>& members = members_[entity - 1];
      out << dim << ' ' << entity << ' ' << type << ' ' << members.size() << '\n';
      for (const std::size_t i : members) append_cell(out << offset + i + 1, cells[i]);
    }
  }

  /// Rows of the section $Elements of version 2.2.
  template <class Cell>
  void append_elements(TextWriter& out, int type, const std::vector<Cell>& cells, std::size_t offset) const {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      append_cell(out << offset + i + 1 << ' ' << type << " 2 " << tag_of_[i] << ' ' << entity_of(i), cells[i]);
    }
  }

 private:
  std::size_t entity_of(std::size_t cell) const {
    const auto found = std::lower_bound(tags_.begin(), tags_.end(), tag_of_[cell]);
    return static_cast<std::size_t>(found - tags_.begin()) + 1;
  }

  std::vector<std::int64_t> tag_of_;
  std::vector<std::int64_t> tags_;  // sorted, each once
  std::vector<std::vector<std::size_t>> members_;
};

template <int Dim>
Entities entities_of_facets(const Mesh<Dim>& mesh) {
  return Entities(facet_references(mesh, Parents::left_out));
}
template <int Dim>
Entities entities_of_simplices(const Mesh<Dim>& mesh) {
  return Entities(simplex_references(mesh));
}

}  // namespace

template <int Dim>
std::string encode_msh41(const Mesh<Dim>& mesh) {
  const std::size_t points = mesh.points.size();
  const std::size_t facets = mesh.boundary.size();
  const std::size_t elements = facets + mesh.simplices.size();
  const Entities of_facets = entities_of_facets(mesh);
  const Entities of_simplices = entities_of_simplices(mesh);
  Box<Dim> box;
  for (const auto& p : mesh.points) box.include(p);

  TextWriter out;
  out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n"
      << (Dim == 2 ? "0 " : "0 0 ") << of_facets.size() << ' ' << of_simplices.size()
      << (Dim == 2 ? " 0\n" : "\n");
  // Readers expect that all entities have a physical tag, or none has.
  const bool with_physical = of_facets.has_physical() || of_simplices.has_physical();
  of_facets.append_rows<Dim>(out, box, with_physical);
  of_simplices.append_rows<Dim>(out, box, with_physical);
  out << "$EndEntities\n$Nodes\n1 " << points << " 1 " << points << '\n' << Dim << " 1 0 " << points << '\n';
  for (std::size_t i = 1; i <= points; ++i) out << i << '\n';
  for (const auto& p : mesh.points) append_coordinates<Dim>(out, p);
  out << "$EndNodes\n$Elements\n"
      << of_facets.size() + of_simplices.size() << ' ' << elements << " 1 " << elements << '\n';
  of_facets.append_blocks(out, Dim - 1, Shapes<Dim>::kGmshFacet, mesh.boundary, 0);
  of_simplices.append_blocks(out, Dim, Shapes<Dim>::kGmshSimplex, mesh.simplices, facets);
  out << "$EndElements\n";
  return out.take();
}

template <int Dim>
std::string encode_msh22(const Mesh<Dim>& mesh) {
  const std::size_t facets = mesh.boundary.size();
  TextWriter out;
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << mesh.points.size() << '\n';
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    append_coordinates<Dim>(out << i + 1 << ' ', mesh.points[i]);
  out << "$EndNodes\n$Elements\n" << facets + mesh.simplices.size() << '\n';
  entities_of_facets(mesh).append_elements(out, Shapes<Dim>::kGmshFacet, mesh.boundary, 0);
  entities_of_simplices(mesh).append_elements(out, Shapes<Dim>::kGmshSimplex, mesh.simplices, facets);
  out << "$EndElements\n";
  return out.take();
}

template std::string encode_msh41(const Mesh2&);
template std::string encode_msh41(const Mesh3&);
template std::string encode_msh22(const Mesh2&);
template std::string encode_msh22(const Mesh3&);

}  // namespace sinkmesh::io_detail
