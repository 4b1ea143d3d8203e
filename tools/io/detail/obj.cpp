// SPDX-License-Identifier: MIT
//
// Wavefront OBJ: `v` and `f` lines; everything else about a surface's looks is passed over.
#include <algorithm>
#include <array>

#include "tools/io/detail/codecs.h"
#include "tools/io/detail/concat.h"
#include "tools/io/detail/text_reader.h"
#include "tools/io/detail/text_writer.h"

namespace sinkmesh::io_detail {
namespace {

constexpr std::string_view kPassedOver[] = {"vt",       "vn",       "vp",     "g",          "o",        "s",
                                            "mg",       "usemtl",   "mtllib", "l",          "p",        "bevel",
                                            "c_interp", "d_interp", "lod",    "shadow_obj", "trace_obj"};

void read_point(TextReader& text, std::size_t id, Point3& p) {
  for (double& x : p) {
    if (text.at_line_end())
      text.fail(concat("vertex ", id + 1, " has fewer than 3 coordinates: complete the line"));
    x = text.number("a coordinate");
  }
  text.drop_line();  // a weight or a color
}

// One corner: `v`, `v/vt`, `v//vn` or `v/vt/vn`. Negative indices count back from the last vertex so far.
// Positive ones may refer to a vertex further on, so their range is checked at the end.
std::uint32_t read_corner(TextReader& text, std::size_t points_so_far) {
  const std::string_view word = text.word("a vertex");
  const char* const end = word.data() + word.size();
  std::int64_t index = 0;
  const auto [last, error] = std::from_chars(word.data(), end, index);
  if (error != std::errc() || (last != end && *last != '/') || index == 0) {
    text.fail(concat("'", printable(word), "' is not a vertex of a facet: 1, 1/2, 1//3 or 1/2/3 was expected"));
  }
  if (index < 0) index += static_cast<std::int64_t>(points_so_far) + 1;
  constexpr std::int64_t kMaxIndex = 0xfffffffe;
  if (index < 1 || index > kMaxIndex) {
    text.fail(concat("vertex ", printable(word), " does not exist: the file has ", points_so_far,
                     " vertices up to here; correct the index"));
  }
  return static_cast<std::uint32_t>(index - 1);
}

Surface3::Facet read_facet(TextReader& text, std::size_t id, std::size_t points_so_far) {
  Surface3::Facet facet{};
  for (std::uint32_t& corner : facet) {
    if (text.at_line_end())
      text.fail(concat("facet ", id + 1, " has fewer than 3 vertices: complete or remove it"));
    corner = read_corner(text, points_so_far);
  }
  if (!text.at_line_end()) {
    text.fail(concat("facet ", id + 1,
                     " has more than 3 corners: only triangles can be read; triangulate the surface first"));
  }
  return facet;
}

}  // namespace

Surface3 decode_obj(const Source& source) {
  TextReader text(source.bytes, source.file);
  Surface3 surface;
  SourceLines own;
  SourceLines& lines = source.lines != nullptr ? *source.lines : own;
  while (!text.at_end()) {
    const std::string_view keyword = text.word("v or f");
    if (keyword == "v") {
      lines.points.push_back(text.line());
      const std::size_t id = surface.points.size();
      read_point(text, id, surface.points.emplace_back());
    } else if (keyword == "f") {
      lines.facets.push_back(text.line());
      surface.facets.push_back(read_facet(text, surface.facets.size(), surface.points.size()));
    } else if (std::find(std::begin(kPassedOver), std::end(kPassedOver), keyword) != std::end(kPassedOver)) {
      text.drop_line();
    } else {
      text.fail(
          concat("'", printable(keyword), "' is not an OBJ keyword that can be read: is this an OBJ file?"));
    }
  }
  for (std::size_t i = 0; i < surface.facets.size(); ++i) {
    for (const std::uint32_t v : surface.facets[i]) {
      if (v >= surface.points.size()) {
        throw FileError(source.file, lines.facets[i],
                        concat("vertex ", std::size_t{v} + 1, " does not exist: the file has ",
                               surface.points.size(), " vertices; correct the index"));
      }
    }
  }
  return surface;
}

std::string encode_obj(const Surface3& surface) {
  TextWriter out;
  for (const Point3& p : surface.points) (out << "v ").row(p);
  for (const Surface3::Facet& f : surface.facets) {
    out << 'f';
    for (const std::uint32_t v : f) out << ' ' << std::uint64_t{v} + 1;
    out << '\n';
  }
  return out.take();
}

}  // namespace sinkmesh::io_detail
