// SPDX-License-Identifier: MIT
//
// OFF: a header, the counts, one vertex a line, one facet a line. Reading by lines, not by words, catches wrong
// counts where they first show.
#include "tools/io/detail/codecs.h"
#include "tools/io/detail/concat.h"
#include "tools/io/detail/text_reader.h"
#include "tools/io/detail/text_writer.h"

namespace sinkmesh::io_detail {
namespace {

struct Header {
  std::size_t points = 0;
  std::size_t facets = 0;
  std::size_t line = 0;
  // Numbers after the three coordinates are announced: normals, colors, texture coordinates.
  bool has_attributes = false;
};

Header read_header(TextReader& text) {
  if (text.at_end()) text.fail("the file is empty: an OFF file starts with the line OFF");
  const std::string_view keyword = text.word("OFF");
  if (!keyword.ends_with("OFF") || keyword.size() > 8) {
    text.fail(concat("not an OFF file: it starts with '", printable(keyword),
                     "' instead of OFF; name the right --format"));
  }
  if (keyword.find('4') != std::string_view::npos || keyword.find('n') != std::string_view::npos) {
    text.fail(concat("'", printable(keyword),
                     "' is OFF in another dimension: only points in space (OFF) can be read"));
  }
  if (text.peek() == "BINARY") text.fail("binary OFF cannot be read: save it as text");
  Header header;
  header.has_attributes = keyword.size() > 3;
  constexpr std::size_t kPointBytes = 6;  // "0 0 0\n"
  constexpr std::size_t kFacetBytes = 8;  // "3 0 0 0\n"
  header.points = text.count("the number of vertices", kPointBytes);
  header.line = text.line();
  if (text.at_line_end())
    text.fail("the number of facets is missing: this line counts vertices, facets and edges");
  header.facets = text.count("the number of facets", kFacetBytes);
  text.drop_line();  // the number of edges, which nobody needs
  return header;
}

std::string see_counts(const Header& header) {
  return concat("; are the counts on line ", header.line, " right?");
}

std::string ends_early(const char* things, std::size_t have, std::size_t announced, const Header& header) {
  return concat("the file ends after ", have, " of ", announced, " ", things,
                ": it is truncated, or the counts on line ", header.line, " are wrong");
}

// At the end of a line that should go on.
[[noreturn]] void fail_incomplete(TextReader& text, const Header& header, const char* thing, std::size_t id,
                                  const char* what) {
  const std::size_t line = text.line();
  const std::string name = concat(thing, " ", id);
  if (!text.at_end()) throw FileError(text.file(), line, concat(name, what, see_counts(header)));
  throw FileError(text.file(), line,
                  concat("the file ends inside ", name, ": it is truncated; get the complete file"));
}

void read_point(TextReader& text, const Header& header, std::size_t id, Point3& p) {
  for (double& x : p) {
    if (text.at_line_end()) fail_incomplete(text, header, "vertex", id, " has fewer than 3 coordinates");
    x = text.number("a coordinate");
  }
  if (header.has_attributes || text.at_line_end()) {
    text.drop_line();
    return;
  }
  // Three or four more numbers are a color, announced or not; one more is no point at all.
  int more = 0;
  for (; !text.at_line_end(); ++more) text.word("a color");
  if (more < 3) {
    text.fail(concat("vertex ", id, " has ", 3 + more, " numbers instead of 3", see_counts(header)));
  }
}

void read_facet(TextReader& text, const Header& header, std::size_t id, Surface3::Facet& facet) {
  const std::int64_t corners = text.integer("the number of corners of a facet");
  if (corners != 3) {
    text.fail(concat("facet ", id, " has ", corners,
                     " corners: only triangles can be read; triangulate the surface first"));
  }
  for (std::uint32_t& corner : facet) {
    if (text.at_line_end()) fail_incomplete(text, header, "facet", id, " has fewer than 3 vertices");
    corner = text.index(header.points, 0, "vertex");
  }
  text.drop_line();  // a color
}

}  // namespace

Surface3 decode_off(const Source& source) {
  TextReader text(source.bytes, source.file);
  const Header header = read_header(text);
  Surface3 surface;
  SourceLines* const lines = source.lines;

  surface.points.resize(header.points);
  if (lines != nullptr) lines->points.resize(header.points);
  for (std::size_t i = 0; i < header.points; ++i) {
    if (text.at_end()) text.fail(ends_early("vertices", i, header.points, header));
    if (lines != nullptr) lines->points[i] = text.line();
    read_point(text, header, i, surface.points[i]);
  }
  surface.facets.resize(header.facets);
  if (lines != nullptr) lines->facets.resize(header.facets);
  for (std::size_t i = 0; i < header.facets; ++i) {
    if (text.at_end()) text.fail(ends_early("facets", i, header.facets, header));
    if (lines != nullptr) lines->facets[i] = text.line();
    read_facet(text, header, i, surface.facets[i]);
  }
  if (!text.at_end()) {
    text.fail(concat("the file goes on after the last of ", header.facets, " facets", see_counts(header)));
  }
  return surface;
}

std::string encode_off(const Surface3& surface) {
  TextWriter out;
  out << "OFF\n" << surface.points.size() << ' ' << surface.facets.size() << " 0\n";
  for (const Point3& p : surface.points) out.row(p);
  for (const Surface3::Facet& f : surface.facets) (out << "3 ").row(f);
  return out.take();
}

}  // namespace sinkmesh::io_detail
