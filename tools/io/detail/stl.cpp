// SPDX-License-Identifier: MIT
//
// STL, text and binary. It has no vertices, only corners: equal ones become one vertex.
#include <cmath>

#include "tools/io/detail/codecs.h"
#include "tools/io/detail/concat.h"
#include "tools/io/detail/point_merger.h"
#include "tools/io/detail/scalars.h"
#include "tools/io/detail/text_reader.h"
#include "tools/io/detail/text_writer.h"

namespace sinkmesh::io_detail {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kFacetBytes = 50;  // normal and corners as floats, and two bytes of attributes

// Many programs begin the header of binary files with "solid" too, so the size decides.
bool is_binary(std::string_view bytes) {
  constexpr std::size_t kPrefix = kHeaderBytes + sizeof(std::uint32_t);
  if (bytes.size() >= kPrefix) {
    const std::uint64_t facets = load<std::uint32_t>(bytes.data() + kHeaderBytes, std::endian::little);
    if (bytes.size() == kPrefix + kFacetBytes * facets) return true;
  }
  const std::size_t word = bytes.find_first_not_of(" \t\r\n");
  return word == std::string_view::npos || !bytes.substr(word).starts_with("solid");
}

Surface3 decode_binary(const Source& source) {
  ByteReader in(source.bytes, source.file, std::endian::little);
  if (source.bytes.size() < kHeaderBytes + sizeof(std::uint32_t)) {
    in.fail("not an STL file: it neither starts with solid nor is it long enough for a binary one");
  }
  in.take(kHeaderBytes, "the header");
  const std::uint64_t facets = in.get<std::uint32_t>("the number of facets");
  if (in.remaining() != facets * kFacetBytes) {
    in.fail(concat("the file announces ", facets, " facets, that is ", facets * kFacetBytes, " bytes, but ",
                   in.remaining(), " follow: it is truncated, or not an STL file"));
  }
  Surface3 surface;
  PointMerger merger(3 * facets);
  surface.facets.resize(facets);
  for (Surface3::Facet& facet : surface.facets) {
    in.take(3 * sizeof(float), "a normal");
    for (std::uint32_t& corner : facet) {
      Point3 p{};
      for (double& x : p) {
        x = in.get<float>("a coordinate");
        if (!std::isfinite(x)) in.fail("a coordinate is not finite: repair or remove this facet");
      }
      corner = merger.id_of(p);
    }
    in.take(2, "an attribute");
  }
  surface.points = merger.take();
  return surface;
}

class StlTextReader {
 public:
  explicit StlTextReader(const Source& source)
      : source_(source),
        text_(source.bytes, source.file, TextReader::kNoComment),
        merger_(source.bytes.size() / 80) {}

  Surface3 read() {
    // A file may hold several solids.
    while (!text_.at_end()) solid();
    surface_.points = merger_.take();
    return std::move(surface_);
  }

 private:
  void expect(std::string_view keyword) { check(text_.word("more of a solid"), keyword); }
  void check(std::string_view word, std::string_view keyword) {
    if (word != keyword) {
      text_.fail(concat("'", printable(word), "' stands where '", keyword, "' was expected: correct the file"));
    }
  }

  void solid() {
    expect("solid");
    text_.drop_line();  // its name
    while (true) {
      const std::string_view word = text_.word("facet or endsolid");
      if (word == "endsolid") {
        text_.drop_line();
        return;
      }
      check(word, "facet");
      facet();
    }
  }

  void facet() {
    if (source_.lines != nullptr) source_.lines->facets.push_back(text_.line());
    expect("normal");
    // Normals are recomputed from the corners by whoever needs them; broken ones ("nan") are common.
    for (int k = 0; k < 3; ++k) text_.word("a normal");
    expect("outer");
    expect("loop");
    Surface3::Facet facet{};
    for (std::uint32_t& corner : facet) {
      expect("vertex");
      Point3 p{};
      for (double& x : p) x = text_.number("a coordinate");
      corner = merger_.id_of(p);
    }
    const std::string_view word = text_.word("endloop");
    if (word == "vertex") {
      text_.fail(concat("facet ", surface_.facets.size(),
                        " has more than 3 corners: only triangles can be read; triangulate the surface first"));
    }
    check(word, "endloop");
    expect("endfacet");
    surface_.facets.push_back(facet);
  }

  const Source& source_;
  TextReader text_;
  PointMerger merger_;
  Surface3 surface_;
};

}  // namespace

Surface3 decode_stl(const Source& source) {
  if (source.bytes.empty()) throw FileError(source.file, "the file is empty: an STL file starts with solid");
  return is_binary(source.bytes) ? decode_binary(source) : StlTextReader(source).read();
}

std::string encode_stl(const Surface3& surface) {
  TextWriter out;
  out << "solid surface\n";
  for (const Surface3::Facet& f : surface.facets) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t v : f) (out << "vertex ").row(surface.points[v]);
    out << "endloop\nendfacet\n";
  }
  out << "endsolid surface\n";
  return out.take();
}

}  // namespace sinkmesh::io_detail
