// SPDX-License-Identifier: MIT
//
// TetGen's and Triangle's files: .node, .ele, .face or .edge, and in the plane .poly. All are a line of counts
// and numbered rows; numbering starts at 0 or 1, as the first row says.
#include <algorithm>

#include "tools/io/detail/codecs.h"
#include "tools/io/detail/concat.h"
#include "tools/io/detail/references.h"
#include "tools/io/detail/shapes.h"
#include "tools/io/detail/text_reader.h"
#include "tools/io/detail/text_writer.h"

namespace sinkmesh::io_detail {
namespace {

constexpr std::int64_t kMaxColumns = 1000;

// A small number on the line of counts: of dimensions, corners, attributes, markers.
std::int64_t read_small(TextReader& text, const char* what) {
  if (text.at_line_end()) text.fail(concat("the line ends where ", what, " was expected"));
  const std::int64_t value = text.integer(what);
  if (value < 0 || value > kMaxColumns) {
    text.fail(concat(what, " is ", value, ": correct the first line"));
  }
  return value;
}

// The number at the start of row i must be first + i.
void read_row_number(TextReader& text, std::int64_t first, std::size_t i) {
  const std::int64_t number = text.integer("the number of a row");
  if (number != first + static_cast<std::int64_t>(i)) {
    text.fail(concat("row number ", number, " stands where ", first + static_cast<std::int64_t>(i),
                     " was expected: number the rows one by one"));
  }
}

// Rows are lines: reading on in the next one would shift all that follows.
void stay_on_line(TextReader& text, const char* what) {
  if (text.at_line_end()) text.fail(concat("the row ends where ", what, " was expected: complete it"));
}

double read_number(TextReader& text, const char* what) {
  stay_on_line(text, what);
  return text.number(what);
}

std::int64_t read_integer(TextReader& text, const char* what) {
  stay_on_line(text, what);
  return text.integer(what);
}

std::uint32_t read_index(TextReader& text, std::size_t size, std::int64_t first) {
  stay_on_line(text, "the number of a point");
  return text.index(size, first, "point");
}

void end_row(TextReader& text) {
  if (text.at_line_end()) return;
  text.fail(concat("'", printable(text.peek()),
                   "' follows after the last column of this row: correct the row, or the counts"));
}

std::int64_t read_first_number(TextReader& text, std::size_t rows) {
  if (rows == 0 || text.at_end()) return 0;
  const std::string_view word = text.peek();
  std::int64_t first = 0;
  std::from_chars(word.data(), word.data() + word.size(), first);
  return first == 1 ? 1 : 0;
}

struct NodeCounts {
  std::size_t points = 0;
  std::int64_t columns = 0;  // attributes and markers
};

template <int Dim>
NodeCounts read_node_counts(TextReader& text) {
  NodeCounts counts;
  counts.points = text.count("the number of points", 2 * Dim + 2);
  const std::int64_t dim = read_small(text, "the dimension");
  if (dim != Dim) {
    text.fail(concat("the points have dimension ", dim, ": ", Dim, " is needed here"));
  }
  // Triangle's files may leave the last two out.
  if (!text.at_line_end()) counts.columns = read_small(text, "the number of attributes");
  if (!text.at_line_end()) counts.columns += read_small(text, "the number of markers");
  return counts;
}

template <int Dim>
NodeFile<Dim> read_nodes(TextReader& text, const NodeCounts& counts, SourceLines* lines) {
  NodeFile<Dim> result;
  result.first = read_first_number(text, counts.points);
  result.points.resize(counts.points);
  for (std::size_t i = 0; i < counts.points; ++i) {
    read_row_number(text, result.first, i);
    if (lines != nullptr) lines->points.push_back(text.line());
    for (double& x : result.points[i]) x = read_number(text, "a coordinate");
    for (std::int64_t k = 0; k < counts.columns; ++k) read_number(text, "an attribute");
    end_row(text);
  }
  return result;
}

void check_end(TextReader& text) {
  if (!text.at_end())
    text.fail("the file goes on after the rows that its first line announces: correct the count");
}

// Attributes of simplices are reals; only columns of whole numbers are fields.
bool is_whole(double value) {
  constexpr double kExact = 9007199254740992.0;  // 2^53
  return value >= -kExact && value <= kExact && value == static_cast<double>(static_cast<std::int64_t>(value));
}

}  // namespace

template <int Dim>
NodeFile<Dim> decode_node(const Source& source) {
  TextReader text(source.bytes, source.file);
  const NodeCounts counts = read_node_counts<Dim>(text);
  NodeFile<Dim> result = read_nodes<Dim>(text, counts, source.lines);
  check_end(text);
  return result;
}

template <int Dim>
void decode_ele(const Source& source, std::int64_t first, Mesh<Dim>& mesh) {
  TextReader text(source.bytes, source.file);
  const std::size_t rows = text.count("the number of simplices", 2 * Dim + 4);
  const std::int64_t corners = read_small(text, "the number of corners");
  if (corners != Dim + 1) {
    text.fail(
        concat("the simplices have ", corners, " nodes: only linear ones, with ", Dim + 1, ", can be read"));
  }
  const auto columns =
      text.at_line_end() ? 0 : static_cast<std::size_t>(read_small(text, "the number of attributes"));
  const std::int64_t first_row = read_first_number(text, rows);
  std::vector<std::vector<std::int64_t>> values(columns);
  std::vector<bool> whole(columns, true);
  mesh.simplices.resize(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    read_row_number(text, first_row, i);
    for (std::uint32_t& v : mesh.simplices[i]) v = read_index(text, mesh.points.size(), first);
    for (std::size_t k = 0; k < columns; ++k) {
      const double value = read_number(text, "an attribute");
      whole[k] = whole[k] && is_whole(value);
      values[k].push_back(whole[k] ? static_cast<std::int64_t>(value) : 0);
    }
    end_row(text);
  }
  check_end(text);
  for (std::size_t k = 0; k < columns; ++k) {
    if (whole[k]) mesh.simplex_fields.push_back({concat("attribute", k + 1), std::move(values[k])});
  }
}

template <int Dim>
void decode_face(const Source& source, std::int64_t first, Mesh<Dim>& mesh) {
  TextReader text(source.bytes, source.file);
  const std::size_t rows = text.count("the number of facets", 2 * Dim + 2);
  const bool has_markers = !text.at_line_end() && read_small(text, "the number of markers") != 0;
  const std::int64_t first_row = read_first_number(text, rows);
  std::vector<std::int64_t> markers;
  mesh.boundary.resize(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    read_row_number(text, first_row, i);
    for (std::uint32_t& v : mesh.boundary[i]) v = read_index(text, mesh.points.size(), first);
    if (has_markers) markers.push_back(read_integer(text, "a marker"));
    text.drop_line();  // neighbors
  }
  check_end(text);
  add_references(mesh.boundary_fields, "marker", std::move(markers));
}

namespace {

void read_segments(TextReader& text, std::int64_t first_point, SourceLines* lines, Surface2& surface) {
  surface.facets.resize(text.count("the number of segments", 6));
  const std::int64_t markers = text.at_line_end() ? 0 : read_small(text, "the number of markers");
  const std::int64_t first_row = read_first_number(text, surface.facets.size());
  for (std::size_t i = 0; i < surface.facets.size(); ++i) {
    read_row_number(text, first_row, i);
    if (lines != nullptr) lines->facets.push_back(text.line());
    for (std::uint32_t& v : surface.facets[i]) v = read_index(text, surface.points.size(), first_point);
    if (markers != 0) surface.facet_tags.push_back(read_integer(text, "a marker"));
    for (std::int64_t k = 1; k < markers; ++k) read_integer(text, "a marker");
    end_row(text);
  }
}

Point2 read_seed(TextReader& text) {
  Point2 p;
  for (double& x : p) x = read_number(text, "a coordinate");
  return p;
}

void read_holes(TextReader& text, SourceLines* lines, Surface2& surface) {
  const std::size_t rows = text.count("the number of holes", 6);
  const std::int64_t first_row = read_first_number(text, rows);
  for (std::size_t i = 0; i < rows; ++i) {
    read_row_number(text, first_row, i);
    if (lines != nullptr) lines->holes.push_back(text.line());
    surface.seeds.holes.push_back(read_seed(text));
    end_row(text);
  }
}

// Triangle's attributes are reals; tags are not, and a rounded one could be that of another region.
void read_regions(TextReader& text, SourceLines* lines, Surface2& surface) {
  const std::size_t rows = text.count("the number of regions", 8);
  const std::int64_t first_row = read_first_number(text, rows);
  for (std::size_t i = 0; i < rows; ++i) {
    read_row_number(text, first_row, i);
    if (lines != nullptr) lines->regions.push_back(text.line());
    const Point2 p = read_seed(text);
    stay_on_line(text, "the attribute of a region");
    const std::string word(text.peek());
    const double attribute = text.number("the attribute of a region");
    if (!is_whole(attribute)) {
      text.fail(concat("the attribute of this region is ", printable(word),
                       ": it becomes the tag of the region, which is a whole number; number the regions"));
    }
    surface.seeds.regions.push_back({p, static_cast<std::int64_t>(attribute)});
    if (!text.at_line_end()) read_number(text, "the largest area in a region");
    end_row(text);
  }
}

}  // namespace

Surface2 decode_poly(const Source& source, const std::optional<Source>& nodes) {
  TextReader text(source.bytes, source.file);
  const NodeCounts counts = read_node_counts<2>(text);
  NodeFile<2> node_file;
  if (counts.points != 0) {
    node_file = read_nodes<2>(text, counts, source.lines);
  } else if (nodes) {
    node_file = decode_node<2>(*nodes);
  } else {
    text.fail("the file has no points of its own, and there is no .node file beside it");
  }
  Surface2 surface;
  surface.points = std::move(node_file.points);
  read_segments(text, node_file.first, source.lines, surface);
  // Files that end here are common, though Triangle wants the holes.
  if (!text.at_end()) read_holes(text, source.lines, surface);
  if (!text.at_end()) read_regions(text, source.lines, surface);
  check_end(text);
  return surface;
}

template <int Dim>
std::string encode_node(const std::vector<Point<Dim>>& points) {
  TextWriter out;
  out << points.size() << ' ' << Dim << " 0 0\n";
  for (std::size_t i = 0; i < points.size(); ++i) (out << i << ' ').row(points[i]);
  return out.take();
}

template <int Dim>
std::string encode_ele(const Mesh<Dim>& mesh) {
  TextWriter out;
  out << mesh.simplices.size() << ' ' << Dim + 1 << ' ' << mesh.simplex_fields.size() << '\n';
  for (std::size_t i = 0; i < mesh.simplices.size(); ++i) {
    out << i;
    for (const std::uint32_t v : mesh.simplices[i]) out << ' ' << v;
    for (const auto& field : mesh.simplex_fields) out << ' ' << field.values[i];
    out << '\n';
  }
  return out.take();
}

template <int Dim>
std::string encode_face(const Mesh<Dim>& mesh) {
  const bool has_markers = !mesh.boundary_fields.empty();
  const std::vector<std::int64_t> markers = facet_references(mesh);
  TextWriter out;
  out << mesh.boundary.size() << (has_markers ? " 1\n" : " 0\n");
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    out << i;
    for (const std::uint32_t v : mesh.boundary[i]) out << ' ' << v;
    if (has_markers) out << ' ' << markers[i];
    out << '\n';
  }
  return out.take();
}

std::string encode_poly(const Surface2& surface) {
  const bool has_markers = !surface.facet_tags.empty();
  TextWriter out;
  out << encode_node<2>(surface.points) << surface.facets.size() << (has_markers ? " 1\n" : " 0\n");
  for (std::size_t i = 0; i < surface.facets.size(); ++i) {
    out << i << ' ' << surface.facets[i][0] << ' ' << surface.facets[i][1];
    if (has_markers) out << ' ' << surface.facet_tags[i];
    out << '\n';
  }
  out << surface.seeds.holes.size() << '\n';
  for (std::size_t i = 0; i < surface.seeds.holes.size(); ++i) (out << i << ' ').row(surface.seeds.holes[i]);
  if (!surface.seeds.regions.empty()) out << surface.seeds.regions.size() << '\n';
  for (std::size_t i = 0; i < surface.seeds.regions.size(); ++i) {
    (out << i << ' ').row(surface.seeds.regions[i].point, ' ') << surface.seeds.regions[i].tag << '\n';
  }
  return out.take();
}

template NodeFile<2> decode_node<2>(const Source&);
template NodeFile<3> decode_node<3>(const Source&);
template void decode_ele(const Source&, std::int64_t, Mesh2&);
template void decode_ele(const Source&, std::int64_t, Mesh3&);
template void decode_face(const Source&, std::int64_t, Mesh2&);
template void decode_face(const Source&, std::int64_t, Mesh3&);
template std::string encode_node<2>(const std::vector<Point2>&);
template std::string encode_node<3>(const std::vector<Point3>&);
template std::string encode_ele(const Mesh2&);
template std::string encode_ele(const Mesh3&);
template std::string encode_face(const Mesh2&);
template std::string encode_face(const Mesh3&);

}  // namespace sinkmesh::io_detail
