// SPDX-License-Identifier: MIT
//
// MEDIT .mesh, text: keywords, each with a count and that many rows. The last number of a row is its reference.
#include <algorithm>
#include <array>

#include "tools/io/detail/codecs.h"
#include "tools/io/detail/concat.h"
#include "tools/io/detail/references.h"
#include "tools/io/detail/shapes.h"
#include "tools/io/detail/text_reader.h"
#include "tools/io/detail/text_writer.h"

namespace sinkmesh::io_detail {
namespace {

// Sections that are skipped; `numbers` a row, or `reals` per dimension.
struct SkippedSection {
  std::string_view keyword;
  int numbers;
  int reals;
};
constexpr SkippedSection kSkipped[] = {
    {"Corners", 1, 0},
    {"RequiredVertices", 1, 0},
    {"Edges", 3, 0},
    {"Triangles", 4, 0},
    {"Ridges", 1, 0},
    {"RequiredEdges", 1, 0},
    {"RequiredTriangles", 1, 0},
    {"Normals", 0, 1},
    {"Tangents", 0, 1},
    {"NormalAtVertices", 2, 0},
    {"TangentAtVertices", 2, 0},
    {"NormalAtTriangleVertices", 3, 0},
};

template <int Dim>
class MeditReader {
 public:
  explicit MeditReader(const Source& source) : text_(source.bytes, source.file) {}

  Mesh<Dim> read() {
    if (text_.at_end()) text_.fail("the file is empty: a MEDIT file starts with MeshVersionFormatted");
    const std::string_view first = text_.word("MeshVersionFormatted");
    if (first != "MeshVersionFormatted") {
      text_.fail(concat("not a MEDIT file in text: it starts with '", printable(first),
                        "' instead of MeshVersionFormatted; name the right --format"));
    }
    text_.integer("the version");
    while (!text_.at_end()) {
      const std::string_view keyword = text_.word("a keyword");
      if (keyword == "End") break;
      section(keyword);
    }
    if (!has_points_) text_.fail_at_end("the section Vertices");
    add_references(mesh_.simplex_fields, "reference", std::move(simplex_references_));
    add_references(mesh_.boundary_fields, "reference", std::move(facet_references_));
    return std::move(mesh_);
  }

 private:
  void section(std::string_view keyword) {
    if (keyword == "Dimension") {
      const std::int64_t dim = text_.integer("the dimension");
      if (dim != Dim) {
        text_.fail(concat("the mesh has dimension ", dim, ": ", Dim, " is needed here"));
      }
      has_dimension_ = true;
    } else if (keyword == "Vertices") {
      points();
    } else if (keyword == Shapes<Dim>::kMeditSimplices) {
      cells(mesh_.simplices, simplex_references_);
    } else if (keyword == Shapes<Dim>::kMeditFacets) {
      cells(mesh_.boundary, facet_references_);
    } else {
      skip(keyword);
    }
  }

  void points() {
    if (!has_dimension_)
      text_.fail("the section Vertices comes before the Dimension: add the line Dimension 3");
    if (has_points_) text_.fail("a second section Vertices: join the two");
    has_points_ = true;
    mesh_.points.resize(text_.count("the number of vertices", 2 * Dim + 2));
    for (auto& p : mesh_.points) {
      for (double& x : p) x = text_.number("a coordinate");
      text_.integer("the reference of a vertex");
    }
  }

  template <class Cell>
  void cells(std::vector<Cell>& out, std::vector<std::int64_t>& references) {
    if (!has_points_) text_.fail("simplices come before the section Vertices: put the vertices first");
    const std::size_t old = out.size();
    out.resize(old + text_.count("the number of simplices", 2 * std::tuple_size_v<Cell> + 2));
    for (std::size_t i = old; i < out.size(); ++i) {
      for (std::uint32_t& v : out[i]) v = text_.index(mesh_.points.size(), 1, "vertex");
      references.push_back(text_.integer("a reference"));
    }
  }

  void skip(std::string_view keyword) {
    const auto* const found = std::find_if(std::begin(kSkipped), std::end(kSkipped),
                                           [&](const SkippedSection& s) { return s.keyword == keyword; });
    if (found == std::end(kSkipped)) {
      text_.fail(concat("'", printable(keyword), "' is not a MEDIT section that can be read: only ",
                        Shapes<Dim>::kMeditSimplices, " and ", Shapes<Dim>::kMeditFacets, " can"));
    }
    const std::size_t rows = text_.count("the number of rows", 2);
    const int numbers = found->numbers + found->reals * Dim;
    for (std::size_t i = 0; i < rows; ++i) {
      for (int k = 0; k < numbers; ++k) text_.number("a number");
    }
  }

  TextReader text_;
  Mesh<Dim> mesh_;
  std::vector<std::int64_t> simplex_references_;
  std::vector<std::int64_t> facet_references_;
  bool has_dimension_ = false;
  bool has_points_ = false;
};

// Rows of 1-based indices and a reference.
template <class Cell>
void append_section(TextWriter& out, const char* keyword, const std::vector<Cell>& cells,
                    const std::vector<std::int64_t>& references) {
  out << keyword << '\n' << cells.size() << '\n';
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const std::uint32_t v : cells[i]) out << std::uint64_t{v} + 1 << ' ';
    out << references[i] << '\n';
  }
}

}  // namespace

template <int Dim>
Mesh<Dim> decode_medit(const Source& source) {
  return MeditReader<Dim>(source).read();
}

template <int Dim>
std::string encode_medit(const Mesh<Dim>& mesh) {
  TextWriter out;
  out << "MeshVersionFormatted 2\nDimension " << Dim << "\nVertices\n" << mesh.points.size() << '\n';
  for (const auto& p : mesh.points) {
    for (const double x : p) out << x << ' ';
    out << "0\n";
  }
  append_section(out, Shapes<Dim>::kMeditSimplices, mesh.simplices, simplex_references(mesh));
  append_section(out, Shapes<Dim>::kMeditFacets, mesh.boundary, facet_references(mesh));
  out << "End\n";
  return out.take();
}

template Mesh2 decode_medit<2>(const Source&);
template Mesh3 decode_medit<3>(const Source&);
template std::string encode_medit(const Mesh2&);
template std::string encode_medit(const Mesh3&);

}  // namespace sinkmesh::io_detail
