// SPDX-License-Identifier: MIT
//
// A cursor over the text of a file: words and numbers, with the line at hand for messages.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "tools/io/file_error.h"

namespace sinkmesh::io_detail {

/// Words are separated by blanks and line ends; a comment runs from its character to the end of the line. Lines
/// end with LF, CR LF or CR. Every failure throws FileError at the current line. The `what` of the functions
/// names the thing expected, with its article: "a coordinate".
class TextReader {
 public:
  static constexpr char kNoComment = '\0';

  TextReader(std::string_view text, std::string_view file, char comment = '#', std::size_t first_line = 1);

  std::size_t line() const { return line_; }
  std::string_view file() const { return file_; }
  std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }

  /// Skips blanks, comments and line ends; true if nothing is left.
  bool at_end() {
    skip_space();
    return at_ == end_;
  }
  /// Skips blanks; true if nothing is left on this line.
  bool at_line_end() {
    skip_blanks();
    return at_ == end_ || is_line_end(*at_) || is_comment(*at_);
  }
  /// Drops what is left of this line, its end included.
  void drop_line();
  /// What is left of this line, without its end, which is dropped.
  std::string_view rest_of_line();
  /// Passes over a column of a table: what comes before the next blank, comma, semicolon or line end.
  void skip_column() {
    while (at_ != end_ && !ends_number(*at_)) ++at_;
  }
  /// Skips blanks, and then the character if it comes next.
  bool accept(char c) {
    skip_blanks();
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }
  /// Continues `count` bytes further on, which are no text: from here on failures name the byte, not the line.
  /// Requires count <= remaining().
  void skip_bytes(std::size_t count) {
    at_ += count;
    has_lines_ = false;
  }

  /// The next word, on this line or a later one.
  std::string_view word(const char* what);
  /// The next word, without moving; empty at the end.
  std::string_view peek();

  /// The nearest double; underflow gives 0 or a subnormal. Fails on words, and on numbers that are not finite.
  double number(const char* what);
  /// Fails unless it is a whole number that fits 64 bits.
  std::int64_t integer(const char* what);
  /// A count of things that take at least `bytes_each` bytes of what follows, which bounds what may be
  /// allocated; at most 2^32 - 2, since indices have 32 bits. bytes_each >= 1.
  std::size_t count(const char* what, std::size_t bytes_each);
  /// An index in [base, base + size), made 0-based. `what` as in "facet 7 uses vertex 9": "vertex".
  std::uint32_t index(std::size_t size, std::int64_t base, const char* what);

  [[noreturn]] void fail(const std::string& message) const {
    if (!has_lines_) throw FileError::at_byte(file_, offset(), message);
    throw FileError(file_, line_, message);
  }
  /// The end of the text came where `what` was expected.
  [[noreturn]] void fail_at_end(const char* what) const;

 private:
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  bool is_comment(char c) const { return c == comment_ && comment_ != kNoComment; }
  /// What may follow a number: commas and semicolons are the business of the caller.
  bool ends_number(char c) const {
    return is_blank(c) || is_line_end(c) || c == ',' || c == ';' || is_comment(c);
  }

  void skip_blanks() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
  }
  void skip_space();
  void pass_line_end();
  void need(const char* what);
  [[noreturn]] void fail_number(const char* what, const char* kind);

  std::string_view file_;
  const char* begin_;
  const char* at_;
  const char* end_;
  std::size_t line_;
  char comment_;
  bool has_lines_ = true;
};

}  // namespace sinkmesh::io_detail
