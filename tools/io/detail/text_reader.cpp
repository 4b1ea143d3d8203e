// SPDX-License-Identifier: MIT
//
// Numbers are parsed in place; only a failure looks for the word around them.
#include "tools/io/detail/text_reader.h"

#include <cmath>
#include <cstdlib>

#include "tools/io/detail/concat.h"

namespace sinkmesh::io_detail {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr std::size_t kMaxCount = 0xfffffffeU;

// from_chars takes no leading plus sign.
const char* past_plus(const char* begin, const char* end) {
  return end - begin > 1 && *begin == '+' && begin[1] != '-' ? begin + 1 : begin;
}

}  // namespace

TextReader::TextReader(std::string_view text, std::string_view file, char comment, std::size_t first_line)
    : file_(file),
      begin_(text.data()),
      at_(text.data()),
      end_(text.data() + text.size()),
      line_(first_line),
      comment_(comment) {
  if (text.starts_with(kByteOrderMark)) at_ += kByteOrderMark.size();
}

void TextReader::pass_line_end() {
  if (*at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n') ++at_;
  ++at_;
  ++line_;
}

void TextReader::skip_space() {
  while (at_ != end_) {
    if (is_blank(*at_)) {
      ++at_;
    } else if (is_line_end(*at_)) {
      pass_line_end();
    } else if (is_comment(*at_)) {
      while (at_ != end_ && !is_line_end(*at_)) ++at_;
    } else {
      return;
    }
  }
}

void TextReader::drop_line() { static_cast<void>(rest_of_line()); }

std::string_view TextReader::rest_of_line() {
  const char* const start = at_;
  while (at_ != end_ && !is_line_end(*at_)) ++at_;
  const std::string_view rest(start, static_cast<std::size_t>(at_ - start));
  if (at_ != end_) pass_line_end();
  return rest;
}

void TextReader::need(const char* what) {
  skip_space();
  if (at_ == end_) fail_at_end(what);
}

void TextReader::fail_at_end(const char* what) const {
  fail(concat("the file ends where ", what,
              " was expected: it is truncated, or a count in it is too large; get the complete file"));
}

std::string_view TextReader::peek() {
  skip_space();
  const char* last = at_;
  while (last != end_ && !is_blank(*last) && !is_line_end(*last) && !is_comment(*last)) ++last;
  return {at_, static_cast<std::size_t>(last - at_)};
}

std::string_view TextReader::word(const char* what) {
  need(what);
  const std::string_view result = peek();
  at_ += result.size();
  return result;
}

void TextReader::fail_number(const char* what, const char* kind) {
  fail(concat("'", printable(peek()), "' is not ", kind, ": ", what, " was expected here; correct the file"));
}

double TextReader::number(const char* what) {
  need(what);
  double value = 0;
  const char* const start = past_plus(at_, end_);
  const auto [last, error] = std::from_chars(start, end_, value);
  if (error == std::errc::invalid_argument || (last != end_ && !ends_number(*last))) {
    fail_number(what, "a number");
  }
  if (error == std::errc::result_out_of_range) {
    // from_chars does not tell overflow from underflow; strtod does.
    value = std::strtod(std::string(start, last).c_str(), nullptr);
    if (std::isinf(value)) {
      fail(concat("'", printable(peek()), "' is too large for a double: rescale the coordinates"));
    }
  } else if (!std::isfinite(value)) {
    fail(concat("'", printable(peek()), "' is not finite where ", what, " was expected: repair or remove it"));
  }
  at_ = last;
  return value;
}

std::int64_t TextReader::integer(const char* what) {
  need(what);
  std::int64_t value = 0;
  const auto [last, error] = std::from_chars(past_plus(at_, end_), end_, value);
  if (error == std::errc::invalid_argument || (last != end_ && !ends_number(*last))) {
    fail_number(what, "a whole number");
  }
  if (error == std::errc::result_out_of_range) fail_number(what, "a whole number of at most 64 bits");
  at_ = last;
  return value;
}

std::size_t TextReader::count(const char* what, std::size_t bytes_each) {
  const std::int64_t value = integer(what);
  if (value < 0) fail(concat(what, " is ", value, ": it cannot be negative"));
  const auto result = static_cast<std::size_t>(value);
  // The last thing may lack its line end.
  if (result > kMaxCount || result > (remaining() + 1) / bytes_each) {
    fail(concat(what, " is ", value, ", more than the ", remaining(),
                " bytes that follow can hold: the count is wrong, or the file is truncated"));
  }
  return result;
}

std::uint32_t TextReader::index(std::size_t size, std::int64_t base, const char* what) {
  const std::int64_t value = integer("an index");
  if (value < base || static_cast<std::uint64_t>(value) - static_cast<std::uint64_t>(base) >= size) {
    const std::string name = concat(what, " ", value, " does not exist: ");
    if (size == 0) fail(concat(name, "the file has none"));
    fail(concat(name, "the indices run from ", base, " to ", base + static_cast<std::int64_t>(size) - 1,
                "; correct the index"));
  }
  return static_cast<std::uint32_t>(value - base);
}

}  // namespace sinkmesh::io_detail
