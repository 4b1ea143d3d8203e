// SPDX-License-Identifier: MIT
//
// VTK's XML format: arrays in text, base64, or appended; found by their tags, decoded when they are wanted.
#include <algorithm>
#include <charconv>
#include <optional>

#include "tools/io/detail/base64.h"
#include "tools/io/detail/codecs.h"
#include "tools/io/detail/concat.h"
#include "tools/io/detail/scalars.h"
#include "tools/io/detail/text_reader.h"
#include "tools/io/detail/vtk_cells.h"
#include "tools/io/detail/xml_scanner.h"

namespace sinkmesh::io_detail {
namespace {

std::optional<Scalar> scalar_of(std::string_view name) {
  static constexpr std::pair<std::string_view, Scalar> kNames[] = {
      {"Int8", Scalar::i8},     {"UInt8", Scalar::u8},   {"Int16", Scalar::i16}, {"UInt16", Scalar::u16},
      {"Int32", Scalar::i32},   {"UInt32", Scalar::u32}, {"Int64", Scalar::i64}, {"UInt64", Scalar::u64},
      {"Float32", Scalar::f32}, {"Float64", Scalar::f64}};
  for (const auto& [known, type] : kNames) {
    if (name == known) return type;
  }
  return std::nullopt;
}

class VtuFile {
 public:
  explicit VtuFile(const Source& source) : source_(source) { scan(); }

  const std::vector<XmlTag>& points() const { return points_; }
  const std::vector<XmlTag>& cells() const { return cells_; }
  const std::vector<XmlTag>& cell_data() const { return cell_data_; }

  /// The numbers of an array, as double or std::int64_t.
  template <class Number>
  std::vector<Number> numbers(const XmlTag& array) const {
    const Scalar type = type_of(array);
    if (std::is_same_v<Number, std::int64_t> && !is_integer(type)) {
      fail(array, "this array must hold whole numbers: the file is damaged");
    }
    const std::string_view format = array.attribute("format");
    if (format == "ascii") return numbers_in_text<Number>(array);
    std::string decoded;
    const std::string_view raw = raw_bytes(array, decoded);
    const std::size_t size = size_of(type);
    if (raw.size() % size != 0)
      fail(array, "this array does not hold a whole number of values: the file is damaged");
    std::vector<Number> result(raw.size() / size);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = load_as<Number>(raw.data() + size * i, type, order_);
    return result;
  }

  Scalar type_of(const XmlTag& array) const {
    const auto type = scalar_of(array.attribute("type"));
    if (!type)
      fail(array, concat("'", printable(array.attribute("type")), "' is not a type of numbers in VTK"));
    return *type;
  }

  const XmlTag& find(const std::vector<XmlTag>& arrays, std::string_view name) const {
    const auto found = std::find_if(arrays.begin(), arrays.end(),
                                    [&](const XmlTag& a) { return a.attribute("Name") == name; });
    if (found == arrays.end()) {
      throw FileError(source_.file, concat("there is no array '", name, "': the file is truncated or damaged"));
    }
    return *found;
  }

  [[noreturn]] void fail(const XmlTag& tag, const std::string& message) const {
    throw FileError(source_.file, line_of(tag.offset), message);
  }

 private:
  std::size_t line_of(std::size_t offset) const {
    const std::string_view before = source_.bytes.substr(0, offset);
    return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  }

  // Notes the arrays of each section. The appended data are no XML, so the scan ends where they begin.
  void scan() {
    XmlScanner scanner(source_.bytes);
    XmlTag tag;
    std::vector<XmlTag>* section = nullptr;
    bool is_vtk = false;
    int pieces = 0;
    while (scanner.next(tag)) {
      if (!is_vtk && tag.name != "VTKFile") break;
      if (tag.name == "VTKFile") {
        is_vtk = true;
        read_head(tag);
      } else if (tag.name == "Piece") {
        if (++pieces == 2) fail(tag, "the file has several pieces: merge them into one");
      } else if (tag.name == "Points" && !tag.closes_itself) {
        section = &points_;
      } else if (tag.name == "Cells" && !tag.closes_itself) {
        section = &cells_;
      } else if (tag.name == "CellData" && !tag.closes_itself) {
        section = &cell_data_;
      } else if (tag.name == "/Points" || tag.name == "/Cells" || tag.name == "/CellData") {
        section = nullptr;
      } else if (tag.name == "DataArray" && section != nullptr) {
        section->push_back(tag);
      } else if (tag.name == "AppendedData") {
        find_appended(tag, scanner.offset());
        break;
      }
    }
    if (!is_vtk) {
      throw FileError(source_.file,
                      "not a .vtu file: there is no tag VTKFile at its start; name the right --format");
    }
  }

  void read_head(const XmlTag& tag) {
    if (tag.attribute("type") != "UnstructuredGrid") {
      fail(tag,
           concat("the file holds a '", printable(tag.attribute("type")), "': an UnstructuredGrid is needed"));
    }
    if (!tag.attribute("compressor").empty()) {
      fail(tag, "compressed .vtu files cannot be read: save it without compression");
    }
    if (tag.attribute("byte_order") == "BigEndian") order_ = std::endian::big;
    length_type_ = tag.attribute("header_type") == "UInt64" ? Scalar::u64 : Scalar::u32;
  }

  void find_appended(const XmlTag& tag, std::size_t start) {
    const std::size_t underscore = source_.bytes.find('_', start);
    if (underscore == std::string_view::npos) fail(tag, "the appended data are missing: the file is truncated");
    appended_ = source_.bytes.substr(underscore + 1);
    appended_is_raw_ = tag.attribute("encoding") == "raw";
  }

  template <class Number>
  std::vector<Number> numbers_in_text(const XmlTag& array) const {
    const auto start = static_cast<std::size_t>(array.content.data() - source_.bytes.data());
    TextReader text(array.content, source_.file, TextReader::kNoComment, line_of(start));
    std::vector<Number> result;
    while (!text.at_end()) {
      if constexpr (std::is_same_v<Number, double>) {
        result.push_back(text.number("a coordinate"));
      } else {
        result.push_back(text.integer("a whole number"));
      }
    }
    return result;
  }

  // Every block of bytes is preceded by its length. In base64 the two may be encoded as one block or as two.
  std::string_view raw_bytes(const XmlTag& array, std::string& decoded) const {
    std::string_view data = array.content;
    bool is_raw = false;
    if (array.attribute("format") == "appended") {
      const std::string_view offset_text = array.attribute("offset");
      std::size_t offset = 0;
      const auto parsed = std::from_chars(offset_text.data(), offset_text.data() + offset_text.size(), offset);
      if (parsed.ec != std::errc() || offset > appended_.size()) fail_truncated(array);
      data = appended_.substr(offset);
      is_raw = appended_is_raw_;
    } else if (array.attribute("format") != "binary") {
      fail(array, concat("'", printable(array.attribute("format")), "' is not a format of arrays in VTK"));
    }
    const std::size_t prefix = size_of(length_type_);
    if (is_raw) {
      if (data.size() < prefix) fail_truncated(array);
      const auto length = load_as<std::uint64_t>(data.data(), length_type_, order_);
      if (length > data.size() - prefix) fail_truncated(array);
      return data.substr(prefix, length);
    }
    std::string_view rest = data.substr(std::min(data.find_first_not_of(" \t\r\n"), data.size()));
    const std::string_view start = rest;
    const std::string head = decode_base64(rest, prefix);
    if (head.size() < prefix) fail_truncated(array);
    const auto length = load_as<std::uint64_t>(head.data(), length_type_, order_);
    if (length > data.size()) fail_truncated(array);
    const bool separate = rest.data() != start.data() && rest.data()[-1] == '=';
    if (separate) {
      decoded = decode_base64(rest, length);
    } else {
      rest = start;
      decoded = decode_base64(rest, prefix + length);
      decoded.erase(0, prefix);
    }
    if (decoded.size() < length) fail_truncated(array);
    return decoded;
  }

  [[noreturn]] void fail_truncated(const XmlTag& array) const {
    fail(array, "the data of this array end before their announced length: the file is truncated or damaged");
  }

  const Source& source_;
  std::vector<XmlTag> points_;
  std::vector<XmlTag> cells_;
  std::vector<XmlTag> cell_data_;
  std::string_view appended_;
  bool appended_is_raw_ = false;
  std::endian order_ = std::endian::little;
  Scalar length_type_ = Scalar::u32;
};

}  // namespace

template <int Dim>
Mesh<Dim> decode_vtu(const Source& source) {
  const VtuFile file(source);
  if (file.points().empty()) {
    throw FileError(source.file, "there is no array of points: the file is truncated or damaged");
  }
  Mesh<Dim> mesh;
  const XmlTag& points = file.points().front();
  mesh.points = collect_points<Dim>(file.numbers<double>(points),
                                    [&](const std::string& message) { file.fail(points, message); });
  VtkCells cells;
  const XmlTag& connectivity = file.find(file.cells(), "connectivity");
  cells.connectivity = file.numbers<std::int64_t>(connectivity);
  cells.offsets = file.numbers<std::int64_t>(file.find(file.cells(), "offsets"));
  cells.offsets.insert(cells.offsets.begin(), 0);
  cells.types = file.numbers<std::int64_t>(file.find(file.cells(), "types"));
  std::vector<VtkField> fields;
  for (const XmlTag& array : file.cell_data()) {
    const std::string_view components = array.attribute("NumberOfComponents");
    if (!is_integer(file.type_of(array)) || !(components.empty() || components == "1")) continue;
    fields.emplace_back(xml_unescaped(array.attribute("Name")), file.numbers<std::int64_t>(array));
  }
  collect_vtk_cells(cells, fields, mesh, [&](const std::string& message) { file.fail(connectivity, message); });
  return mesh;
}

template Mesh2 decode_vtu<2>(const Source&);
template Mesh3 decode_vtu<3>(const Source&);

}  // namespace sinkmesh::io_detail
