// SPDX-License-Identifier: MIT
//
// Text for a file, built in one buffer.
#pragma once

#include <charconv>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace sinkmesh::io_detail {

/// Appends words and numbers; doubles as the shortest decimals that read back as the same double.
class TextWriter {
 public:
  TextWriter() : buffer_(std::size_t{1} << 16, '\0') {}

  TextWriter& operator<<(std::string_view text) {
    reserve(text.size());
    std::memcpy(buffer_.data() + size_, text.data(), text.size());
    size_ += text.size();
    return *this;
  }
  TextWriter& operator<<(const char* text) { return *this << std::string_view(text); }
  TextWriter& operator<<(char c) {
    reserve(1);
    buffer_[size_++] = c;
    return *this;
  }
  /// Any integer or double.
  template <class Number>
  requires std::is_arithmetic_v<Number> TextWriter& operator<<(Number value) {
    // 24 characters hold every double and every 64-bit integer.
    reserve(24);
    char* const start = buffer_.data() + size_;
    size_ += static_cast<std::size_t>(std::to_chars(start, start + 24, value).ptr - start);
    return *this;
  }

  /// The numbers of a range, separated by blanks, and `last`.
  template <class Range>
  TextWriter& row(const Range& values, char last = '\n') {
    for (const auto& value : values) *this << value << ' ';
    buffer_[size_ - 1] = last;
    return *this;
  }

  /// The text; leaves the writer empty and unusable.
  std::string take() {
    buffer_.resize(size_);
    return std::move(buffer_);
  }

 private:
  void reserve(std::size_t more) {
    if (buffer_.size() - size_ < more) buffer_.resize(2 * buffer_.size() + more);
  }

  std::string buffer_;
  std::size_t size_ = 0;
};

}  // namespace sinkmesh::io_detail
