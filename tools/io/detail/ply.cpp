// SPDX-License-Identifier: MIT
//
// PLY: a header in text that describes the elements, then their rows in text or binary of either byte order.
// What is neither a coordinate nor a facet's list of vertices is passed over.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "tools/io/detail/codecs.h"
#include "tools/io/detail/concat.h"
#include "tools/io/detail/scalars.h"
#include "tools/io/detail/text_reader.h"
#include "tools/io/detail/text_writer.h"

namespace sinkmesh::io_detail {
namespace {

struct Property {
  std::string_view name;
  Scalar type{};
  std::optional<Scalar> length = std::nullopt;  // of a list
};

struct Element {
  std::string_view name;
  std::size_t count = 0;
  std::size_t line = 0;
  std::vector<Property> properties;

  std::size_t find(std::string_view property) const {
    const auto is_it = [&](const Property& p) { return p.name == property; };
    return static_cast<std::size_t>(std::find_if(properties.begin(), properties.end(), is_it) -
                                    properties.begin());
  }
};

enum class Encoding { text, little, big };

struct Header {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;
};

std::optional<Scalar> scalar_of(std::string_view name) {
  static constexpr std::pair<std::string_view, Scalar> kNames[] = {
      {"char", Scalar::i8},   {"uchar", Scalar::u8},   {"short", Scalar::i16},   {"ushort", Scalar::u16},
      {"int", Scalar::i32},   {"uint", Scalar::u32},   {"float", Scalar::f32},   {"double", Scalar::f64},
      {"int8", Scalar::i8},   {"uint8", Scalar::u8},   {"int16", Scalar::i16},   {"uint16", Scalar::u16},
      {"int32", Scalar::i32}, {"uint32", Scalar::u32}, {"float32", Scalar::f32}, {"float64", Scalar::f64},
      {"int64", Scalar::i64}, {"uint64", Scalar::u64},
  };
  for (const auto& [known, type] : kNames) {
    if (name == known) return type;
  }
  return std::nullopt;
}

class HeaderReader {
 public:
  explicit HeaderReader(TextReader& text) : text_(text) {}

  Header read() {
    if (text_.at_end()) text_.fail("the file is empty: a PLY file starts with the line ply");
    const std::string_view first = text_.word("ply");
    if (first != "ply") {
      text_.fail(concat("not a PLY file: it starts with '", printable(first),
                        "' instead of ply; name the right --format"));
    }
    text_.drop_line();
    while (true) {
      const std::string_view keyword = text_.word("end_header");
      if (keyword == "end_header") break;
      line(keyword);
      text_.drop_line();
    }
    // Exactly one line end: the data may begin with any byte.
    text_.drop_line();
    if (!has_format_) text_.fail("the header has no format line: correct the file");
    return std::move(header_);
  }

 private:
  void line(std::string_view keyword) {
    if (keyword == "comment" || keyword == "obj_info") return;
    if (keyword == "format") {
      format();
    } else if (keyword == "element") {
      element();
    } else if (keyword == "property") {
      property();
    } else {
      text_.fail(concat("'", printable(keyword), "' is not a line of a PLY header: correct the file"));
    }
  }

  std::string_view word(const char* what) {
    if (text_.at_line_end()) text_.fail(concat("the line ends where ", what, " was expected"));
    return text_.word(what);
  }

  void format() {
    const std::string_view name = word("a format");
    has_format_ = true;
    if (name == "ascii") {
      header_.encoding = Encoding::text;
    } else if (name == "binary_little_endian") {
      header_.encoding = Encoding::little;
    } else if (name == "binary_big_endian") {
      header_.encoding = Encoding::big;
    } else {
      text_.fail(concat("'", printable(name),
                        "' is not a PLY format: ascii, binary_little_endian or binary_big_endian"));
    }
  }

  void element() {
    Element element;
    element.name = word("the name of an element");
    if (text_.at_line_end()) text_.fail("the line ends where a number of elements was expected");
    element.count = text_.count("the number of elements", 1);
    element.line = text_.line();
    header_.elements.push_back(element);
  }

  void property() {
    if (header_.elements.empty()) text_.fail("a property comes before the first element: correct the header");
    Property property;
    std::string_view first = word("a type");
    if (first == "list") {
      property.length = type(word("a type"));
      if (!is_integer(*property.length))
        text_.fail("the length of a list is not a whole number: correct the header");
      first = word("a type");
    }
    property.type = type(first);
    property.name = word("the name of a property");
    header_.elements.back().properties.push_back(property);
  }

  Scalar type(std::string_view name) {
    const auto result = scalar_of(name);
    if (!result)
      text_.fail(concat("'", printable(name), "' is not a type of numbers in PLY: correct the header"));
    return *result;
  }

  TextReader& text_;
  Header header_;
  bool has_format_ = false;
};

// The two kinds of bodies, with one face.
class TextBody {
 public:
  explicit TextBody(TextReader& text) : text_(text) {}
  double real(Scalar) {
    stay_on_line("a coordinate");
    return text_.number("a coordinate");
  }
  std::int64_t integer(Scalar) {
    stay_on_line("a whole number");
    return text_.integer("a whole number");
  }
  void skip(Scalar) {
    stay_on_line("a property");
    text_.word("a property");
  }
  void skip_many(Scalar type, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) skip(type);
  }
  void start_row() {
    if (text_.at_end()) text_.fail_at_end("a row of an element");
  }
  void end_row() {
    if (text_.at_line_end()) return;
    text_.fail(concat("'", printable(text_.peek()),
                      "' follows after the last property of this row: correct the row, or the header"));
  }
  bool at_end() { return text_.at_end(); }
  std::size_t line() {
    text_.at_end();
    return text_.line();
  }
  [[noreturn]] void fail(const std::string& message) { text_.fail(message); }

 private:
  // A row is a line. Reading on in the next one would shift all that follows.
  void stay_on_line(const char* what) {
    if (text_.at_line_end()) text_.fail(concat("the row ends where ", what, " was expected: complete it"));
  }

  TextReader& text_;
};

class BinaryBody {
 public:
  explicit BinaryBody(ByteReader in) : in_(in) {}
  double real(Scalar type) {
    const double x = in_.real(type, "a coordinate");
    if (!std::isfinite(x)) in_.fail("a coordinate is not finite: repair or remove this vertex");
    return x;
  }
  std::int64_t integer(Scalar type) { return in_.integer(type, "a list"); }
  void skip(Scalar type) { in_.take(size_of(type), "a property"); }
  void skip_many(Scalar type, std::uint64_t count) {
    if (count > in_.remaining() / size_of(type)) in_.fail_at_end("a list");
    in_.take(count * size_of(type), "a list");
  }
  void start_row() {}
  void end_row() {}
  bool at_end() { return in_.remaining() == 0; }
  std::size_t line() { return 0; }
  [[noreturn]] void fail(const std::string& message) { in_.fail(message); }

 private:
  ByteReader in_;
};

template <class Body>
class BodyReader {
 public:
  BodyReader(Body body, const Header& header, SourceLines* lines)
      : body_(body), header_(header), lines_(lines) {
    for (const Element& element : header_.elements) num_points_ += element.name == "vertex" ? element.count : 0;
  }

  Surface3 read() {
    for (const Element& element : header_.elements) {
      if (element.name == "vertex") {
        points(element);
      } else if (element.name == "face") {
        facets(element);
      } else if (element.name == "tristrips" && element.count != 0) {
        body_.fail("triangle strips cannot be read: save the surface as separate triangles");
      } else {
        for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i) skip_row(element);
      }
    }
    if (!body_.at_end()) {
      body_.fail("the file goes on after the elements that its header announces: correct the counts");
    }
    return std::move(surface_);
  }

 private:
  void skip_property(const Property& property) {
    if (!property.length) {
      body_.skip(property.type);
    } else {
      body_.skip_many(property.type, list_length(property));
    }
  }
  void skip_row(const Element& element) {
    body_.start_row();
    for (const Property& property : element.properties) skip_property(property);
    body_.end_row();
  }
  std::uint64_t list_length(const Property& property) {
    const std::int64_t length = body_.integer(*property.length);
    if (length < 0) body_.fail("the length of a list is negative: correct the file");
    return static_cast<std::uint64_t>(length);
  }

  void points(const Element& element) {
    constexpr std::string_view kNames[] = {"x", "y", "z"};
    std::vector<int> coordinate(element.properties.size(), -1);
    for (int k = 0; k < 3; ++k) {
      const std::size_t i = element.find(kNames[k]);
      if (i == coordinate.size() || element.properties[i].length) {
        body_.fail(concat("the vertices have no property ", kNames[k], ": x, y and z are needed"));
      }
      coordinate[i] = k;
    }
    surface_.points.reserve(element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
      body_.start_row();
      note_line(&SourceLines::points);
      Point3& p = surface_.points.emplace_back();
      for (std::size_t j = 0; j < coordinate.size(); ++j) {
        if (coordinate[j] < 0) {
          skip_property(element.properties[j]);
        } else {
          p[static_cast<std::size_t>(coordinate[j])] = body_.real(element.properties[j].type);
        }
      }
      body_.end_row();
    }
  }

  void facets(const Element& element) {
    std::size_t list = element.find("vertex_indices");
    if (list == element.properties.size()) list = element.find("vertex_index");
    if (list == element.properties.size() || !element.properties[list].length ||
        !is_integer(element.properties[list].type)) {
      body_.fail("the faces have no list vertex_indices of whole numbers: correct the header");
    }
    surface_.facets.reserve(element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
      body_.start_row();
      note_line(&SourceLines::facets);
      for (std::size_t j = 0; j < element.properties.size(); ++j) {
        if (j == list) {
          surface_.facets.push_back(facet(element.properties[j], i));
        } else {
          skip_property(element.properties[j]);
        }
      }
      body_.end_row();
    }
  }

  Surface3::Facet facet(const Property& property, std::size_t id) {
    const std::uint64_t corners = list_length(property);
    if (corners != 3) {
      body_.fail(concat("facet ", id, " has ", corners,
                        " corners: only triangles can be read; triangulate the surface first"));
    }
    Surface3::Facet result{};
    for (std::uint32_t& corner : result) {
      const std::int64_t index = body_.integer(property.type);
      if (index < 0 || static_cast<std::uint64_t>(index) >= num_points_) {
        body_.fail(concat("facet ", id, " uses vertex ", index, ", which does not exist: the file has ",
                          num_points_, " vertices, counted from 0; correct the index"));
      }
      corner = static_cast<std::uint32_t>(index);
    }
    return result;
  }

  void note_line(std::vector<std::size_t> SourceLines::*which) {
    if (lines_ == nullptr) return;
    if (const std::size_t line = body_.line(); line != 0) (lines_->*which).push_back(line);
  }

  Body body_;
  const Header& header_;
  SourceLines* lines_;
  std::size_t num_points_ = 0;  // of the header: the vertices may come after the faces
  Surface3 surface_;
};

}  // namespace

Surface3 decode_ply(const Source& source) {
  TextReader text(source.bytes, source.file, TextReader::kNoComment);
  const Header header = HeaderReader(text).read();
  // The rows hold at least one byte per property; that bounds what a wrong count can cost.
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;
    if (element.count > (text.remaining() + 1) / element.properties.size()) {
      throw FileError(source.file, element.line,
                      concat("the number of elements is ", element.count, ", more than the ", text.remaining(),
                             " bytes after the header can hold: the count is wrong, or the file is truncated"));
    }
  }
  if (header.encoding == Encoding::text) {
    return BodyReader<TextBody>(TextBody(text), header, source.lines).read();
  }
  const std::endian order = header.encoding == Encoding::little ? std::endian::little : std::endian::big;
  const ByteReader in(source.bytes.substr(text.offset()), source.file, order, text.offset());
  return BodyReader<BinaryBody>(BinaryBody(in), header, source.lines).read();
}

std::string encode_ply(const Surface3& surface) {
  TextWriter header;
  header << "ply\nformat binary_little_endian 1.0\nelement vertex " << surface.points.size()
         << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << surface.facets.size()
         << "\nproperty list uchar uint vertex_indices\nend_header\n";
  std::string out = header.take();
  out.reserve(out.size() + 24 * surface.points.size() + 13 * surface.facets.size());
  for (const Point3& p : surface.points) {
    for (const double x : p) append_little(out, x);
  }
  for (const Surface3::Facet& f : surface.facets) {
    out += '\3';
    for (const std::uint32_t v : f) append_little(out, v);
  }
  return out;
}

}  // namespace sinkmesh::io_detail
