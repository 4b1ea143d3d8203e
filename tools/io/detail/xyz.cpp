// SPDX-License-Identifier: MIT
//
// Points, one a line, in columns.
#include "tools/io/detail/codecs.h"
#include "tools/io/detail/concat.h"
#include "tools/io/detail/text_reader.h"
#include "tools/io/file_error.h"

namespace sinkmesh::io_detail {
namespace {

// Is the first line titles? Then its first word is no number at all; "nan" is a number, and refused as such.
bool starts_with_titles(TextReader& text) {
  if (text.at_end()) return false;
  const std::string_view word = text.peek();
  double value = 0;
  const std::size_t sign = word.starts_with('+') ? 1 : 0;
  return std::from_chars(word.data() + sign, word.data() + word.size(), value).ec ==
         std::errc::invalid_argument;
}

// One comma or semicolon, at most, between two columns: a second one is an empty column.
// @return whether there was one, or only blanks.
bool pass_separator(TextReader& text) { return text.accept(',') || text.accept(';'); }

// The titles x, y, z may stand over the first columns only, in this order: of other columns nothing is known.
void pass_titles(TextReader& text, std::size_t dim) {
  constexpr std::string_view kAxes = "xyz";
  for (std::size_t column = 0; !text.at_line_end(); ++column) {
    const std::string_view word = text.peek();
    const std::string_view title = word.substr(0, word.find_first_of(",;"));
    const std::size_t axis =
        title.size() == 1 ? kAxes.find(static_cast<char>(title[0] | 0x20)) : std::string_view::npos;
    if (axis != std::string_view::npos && axis < dim && axis != column) {
      text.fail(concat("the title ", printable(title), " stands over column ", column + 1,
                       ": the first columns must be ", dim == 2 ? "x and y" : "x, y and z"));
    }
    text.skip_column();
    pass_separator(text);
  }
}

bool at_separator_or_end(TextReader& text) {
  const std::string_view next = text.at_line_end() ? std::string_view() : text.peek();
  return next.empty() || next.front() == ',' || next.front() == ';';
}

}  // namespace

template <int Dim>
std::vector<Point<Dim>> decode_xyz(const Source& source) {
  TextReader text(source.bytes, source.file);
  if (starts_with_titles(text)) pass_titles(text, Dim);
  std::vector<Point<Dim>> points;
  std::size_t columns = 0;
  std::size_t first_line = 0;
  while (!text.at_end()) {
    if (source.lines != nullptr) source.lines->points.push_back(text.line());
    Point<Dim>& p = points.emplace_back();
    std::size_t column = 0;
    std::size_t marks = 0;  // commas and semicolons between coordinates
    for (; !text.at_line_end(); ++column) {
      if (at_separator_or_end(text)) {
        text.fail(concat("column ", column + 1, " is empty: every point needs its coordinates"));
      }
      if (column < Dim) {
        p[column] = text.number("a coordinate");
      } else {
        text.skip_column();
      }
      const bool mark = pass_separator(text);
      marks += mark && column + 1 < Dim ? 1 : 0;
    }
    if (column >= Dim && marks != 0 && marks != Dim - 1) {
      text.fail("coordinates are separated by commas and by blanks: use one of them, and decimal points");
    }
    if (column < Dim) {
      text.fail(concat("this point has ", column, " coordinates: ", Dim, " are needed"));
    }
    if (columns == 0) {
      columns = column;
      first_line = text.line();
    } else if (column != columns) {
      text.fail(concat("this line has ", column, " columns, but line ", first_line, " has ", columns,
                       ": correct the one that is wrong"));
    }
  }
  return points;
}

template std::vector<Point2> decode_xyz<2>(const Source&);
template std::vector<Point3> decode_xyz<3>(const Source&);

}  // namespace sinkmesh::io_detail
