// SPDX-License-Identifier: MIT
//
// VTK's legacy format: lines in text, whose numbers follow in text or big-endian binary. Versions 1 to 5, which
// differ in how cells are listed.
#include <charconv>
#include <optional>

#include "tools/io/detail/codecs.h"
#include "tools/io/detail/concat.h"
#include "tools/io/detail/scalars.h"
#include "tools/io/detail/text_reader.h"
#include "tools/io/detail/vtk_cells.h"

namespace sinkmesh::io_detail {
namespace {

std::optional<Scalar> scalar_of(std::string_view name) {
  // vtkIdType has 32 bits in these files, whatever it has in memory.
  static constexpr std::pair<std::string_view, Scalar> kNames[] = {
      {"char", Scalar::i8},           {"signed_char", Scalar::i8},     {"unsigned_char", Scalar::u8},
      {"short", Scalar::i16},         {"unsigned_short", Scalar::u16}, {"int", Scalar::i32},
      {"unsigned_int", Scalar::u32},  {"long", Scalar::i64},           {"unsigned_long", Scalar::u64},
      {"float", Scalar::f32},         {"double", Scalar::f64},         {"vtkIdType", Scalar::i32},
      {"vtktypeint32", Scalar::i32},  {"vtktypeuint32", Scalar::u32},  {"vtktypeint64", Scalar::i64},
      {"vtktypeuint64", Scalar::u64}, {"vtktypeint8", Scalar::i8},     {"vtktypeuint8", Scalar::u8},
      {"vtktypeint16", Scalar::i16},  {"vtktypeuint16", Scalar::u16}};
  for (const auto& [known, type] : kNames) {
    if (name == known) return type;
  }
  return std::nullopt;
}

// %XX back to characters.
std::string decoded(std::string_view name) {
  std::string out;
  for (std::size_t i = 0; i < name.size(); ++i) {
    unsigned code = 0;
    if (name[i] == '%' && i + 2 < name.size() &&
        std::from_chars(name.data() + i + 1, name.data() + i + 3, code, 16).ptr == name.data() + i + 3) {
      out += static_cast<char>(code);
      i += 2;
    } else {
      out += name[i];
    }
  }
  return out;
}

template <int Dim>
class VtkReader {
 public:
  explicit VtkReader(const Source& source)
      : source_(source), text_(source.bytes, source.file, TextReader::kNoComment) {}

  Mesh<Dim> read() {
    head();
    while (!text_.at_end()) section(text_.word("a section"));
    const auto fail_here = [&](const std::string& message) { fail(message); };
    if (!has_points_ || !has_cells_ || !has_types_) {
      fail(
          "POINTS, CELLS and CELL_TYPES are needed, but one of them is missing: the file is truncated or "
          "damaged");
    }
    mesh_.points = collect_points<Dim>(coordinates_, fail_here);
    collect_vtk_cells(cells_, fields_, mesh_, fail_here);
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { text_.fail(message); }

  void head() {
    if (!text_.rest_of_line().starts_with("# vtk DataFile Version")) {
      throw FileError(
          source_.file, 1,
          "not a legacy VTK file: it does not start with # vtk DataFile Version; name the right --format");
    }
    text_.drop_line();  // the title
    const std::string_view encoding = text_.word("ASCII or BINARY");
    if (encoding != "ASCII" && encoding != "BINARY") {
      fail(concat("'", printable(encoding), "' stands where ASCII or BINARY was expected: correct the file"));
    }
    text_.drop_line();
    is_binary_ = encoding == "BINARY";
  }

  std::string_view word(const char* what) {
    if (text_.at_line_end()) fail(concat("the line ends where ", what, " was expected"));
    return text_.word(what);
  }
  std::size_t count(const char* what) {
    if (text_.at_line_end()) fail(concat("the line ends where ", what, " was expected"));
    return text_.count(what, 1);
  }
  Scalar type() {
    const std::string_view name = word("a type");
    const auto result = scalar_of(name);
    if (!result) fail(concat("'", printable(name), "' is not a type of numbers that can be read here"));
    return *result;
  }
  /// Whether the line at hand starts with the word. Looks at the bytes, since they may be binary data.
  bool comes_next(std::string_view keyword) const {
    return source_.bytes.substr(text_.offset()).starts_with(keyword);
  }

  // Binary values begin right after the line end, so the line at hand must have been dropped.
  void check_room(std::size_t count, std::size_t bytes_each) const {
    // In text the last value may lack its line end.
    const std::size_t room = text_.remaining() + (is_binary_ ? 0 : 1);
    if (count > room / bytes_each) {
      const std::string message =
          concat(count, " values are announced, more than the ", text_.remaining(),
                 " bytes that follow can hold: the file is truncated, or the count is wrong");
      if (is_binary_) throw FileError::at_byte(source_.file, text_.offset(), message);
      fail(message);
    }
  }
  template <class Number>
  std::vector<Number> values(Scalar type, std::size_t count) {
    std::vector<Number> result;
    if (!is_binary_) {
      check_room(count, 2);
      result.resize(count);
      for (Number& value : result) {
        if constexpr (std::is_same_v<Number, double>) {
          value = text_.number("a coordinate");
        } else {
          value = text_.integer("a whole number");
        }
      }
      return result;
    }
    const char* const start = skip_binary(type, count);
    result.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      result[i] = load_as<Number>(start + i * size_of(type), type, std::endian::big);
    }
    return result;
  }
  std::vector<std::int64_t> integers(Scalar type, std::size_t count) {
    if (!is_integer(type)) fail("whole numbers are needed here, not reals: the file is damaged");
    return values<std::int64_t>(type, count);
  }
  const char* skip_binary(Scalar type, std::size_t count) {
    check_room(count, size_of(type));
    const char* const start = source_.bytes.data() + text_.offset();
    text_.skip_bytes(count * size_of(type));
    return start;
  }
  void skip(Scalar type, std::size_t count) {
    if (is_binary_) {
      skip_binary(type, count);
    } else {
      check_room(count, 2);
      for (std::size_t i = 0; i < count; ++i) text_.word("a value");
    }
  }

  void section(std::string_view keyword) {
    if (keyword == "DATASET") {
      const std::string_view kind = word("UNSTRUCTURED_GRID");
      if (kind != "UNSTRUCTURED_GRID")
        fail(concat("the file holds a ", printable(kind), ": an UNSTRUCTURED_GRID is needed"));
      text_.drop_line();
    } else if (keyword == "POINTS") {
      const std::size_t points = count("the number of points");
      const Scalar real = type();
      text_.drop_line();
      coordinates_ = values<double>(real, 3 * points);
      has_points_ = true;
    } else if (keyword == "CELLS") {
      cells();
    } else if (keyword == "CELL_TYPES") {
      const std::size_t types = count("the number of cells");
      text_.drop_line();
      cells_.types = integers(Scalar::i32, types);
      has_types_ = true;
    } else if (keyword == "CELL_DATA" || keyword == "POINT_DATA") {
      data_of_cells_ = keyword == "CELL_DATA";
      data_count_ = count("the number of values");
      text_.drop_line();
    } else if (keyword == "METADATA") {
      // Ends with an empty line.
      text_.drop_line();
      while (text_.remaining() != 0 && !text_.rest_of_line().empty()) {
      }
    } else {
      attribute(keyword);
    }
  }

  void cells() {
    const std::size_t first = count("the number of cells");
    const std::size_t second = count("the size of the list of cells");
    text_.drop_line();
    has_cells_ = true;
    if (comes_next("OFFSETS")) {
      cells_.offsets = listed_integers("OFFSETS", first);
      cells_.connectivity = listed_integers("CONNECTIVITY", second);
      return;
    }
    const std::vector<std::int64_t> list = integers(Scalar::i32, second);
    cells_.offsets = {0};
    cells_.connectivity.clear();
    for (std::size_t at = 0; at < list.size();) {
      const std::int64_t corners = list[at++];
      if (corners < 0 || static_cast<std::uint64_t>(corners) > list.size() - at) {
        fail(concat("cell ", cells_.offsets.size() - 1, " has ", corners,
                    " corners, more than the list of cells holds: the file is damaged"));
      }
      const auto start = list.begin() + static_cast<std::ptrdiff_t>(at);
      cells_.connectivity.insert(cells_.connectivity.end(), start, start + corners);
      cells_.offsets.push_back(static_cast<std::int64_t>(cells_.connectivity.size()));
      at += static_cast<std::size_t>(corners);
    }
    if (cells_.offsets.size() != first + 1) {
      fail(concat("the list of cells holds ", cells_.offsets.size() - 1, " instead of ", first,
                  ": correct the counts of CELLS"));
    }
  }
  std::vector<std::int64_t> listed_integers(std::string_view keyword, std::size_t size) {
    const std::string_view found = text_.word("OFFSETS or CONNECTIVITY");
    if (found != keyword) fail(concat("'", printable(found), "' stands where ", keyword, " was expected"));
    const Scalar integer = type();
    text_.drop_line();
    return integers(integer, size);
  }

  // One array of point or cell data. Arrays of whole numbers on cells are fields; the rest is passed over.
  void attribute(std::string_view keyword) {
    if (keyword == "SCALARS") {
      const std::string name = decoded(word("a name"));
      const Scalar scalar = type();
      const std::size_t components = text_.at_line_end() ? 1 : count("the number of components");
      text_.drop_line();
      if (comes_next("LOOKUP_TABLE")) text_.drop_line();
      data(name, scalar, components, data_count_);
    } else if (keyword == "VECTORS" || keyword == "NORMALS" || keyword == "TENSORS") {
      word("a name");
      const Scalar scalar = type();
      text_.drop_line();
      skip(scalar, (keyword == "TENSORS" ? 9 : 3) * data_count_);
    } else if (keyword == "LOOKUP_TABLE") {
      word("a name");
      const std::size_t colors = count("the size of a table");
      text_.drop_line();
      skip(Scalar::u8, 4 * colors);
    } else if (keyword == "FIELD") {
      word("a name");
      const std::size_t arrays = count("the number of arrays");
      text_.drop_line();
      for (std::size_t i = 0; i < arrays; ++i) field_array();
    } else {
      fail(concat("'", printable(keyword),
                  "' is not a section that can be read here: the file is damaged, or its counts "
                  "are wrong"));
    }
  }
  void field_array() {
    std::string_view keyword = text_.word("the name of an array");
    for (; keyword == "METADATA"; keyword = text_.word("the name of an array")) section(keyword);
    const std::string name = decoded(keyword);
    const std::size_t components = count("the number of components");
    const std::size_t tuples = count("the number of values");
    const Scalar scalar = type();
    text_.drop_line();
    data(name, scalar, components, tuples);
  }
  void data(const std::string& name, Scalar scalar, std::size_t components, std::size_t tuples) {
    if (data_of_cells_ && components == 1 && is_integer(scalar)) {
      fields_.emplace_back(name, integers(scalar, tuples));
    } else {
      skip(scalar, components * tuples);
    }
  }

  const Source& source_;
  TextReader text_;
  Mesh<Dim> mesh_;
  std::vector<double> coordinates_;
  VtkCells cells_;
  std::vector<VtkField> fields_;
  std::size_t data_count_ = 0;
  bool is_binary_ = false;
  bool data_of_cells_ = false;
  bool has_points_ = false;
  bool has_cells_ = false;
  bool has_types_ = false;
};

}  // namespace

template <int Dim>
Mesh<Dim> decode_vtk(const Source& source) {
  return VtkReader<Dim>(source).read();
}

template Mesh2 decode_vtk<2>(const Source&);
template Mesh3 decode_vtk<3>(const Source&);

}  // namespace sinkmesh::io_detail
