// SPDX-License-Identifier: MIT
//
// Numbers in binary files: their types, their byte order, and reading them without running past the end.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "tools/io/detail/concat.h"
#include "tools/io/file_error.h"

namespace sinkmesh::io_detail {

enum class Scalar : std::uint8_t { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

constexpr std::size_t size_of(Scalar type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}
constexpr bool is_integer(Scalar type) { return type < Scalar::f32; }

template <class T>
T load(const char* bytes, std::endian order) {
  char raw[sizeof(T)];
  std::memcpy(raw, bytes, sizeof(T));
  if (order != std::endian::native) {
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  }
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

/// Appends the bytes of the value, least significant first.
template <class T>
void append_little(std::string& out, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) {
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  }
  out.append(raw, sizeof(T));
}

template <class Number, class Stored>
Number convert(const char* bytes, std::endian order) {
  if constexpr (std::is_integral_v<Number> && !std::is_integral_v<Stored>) {
    return Number{};
  } else {
    return static_cast<Number>(load<Stored>(bytes, order));
  }
}

/// Any scalar as Number. To an integer type: only from integer scalars; u64 wraps, and then is out of every
/// range.
template <class Number>
Number load_as(const char* bytes, Scalar type, std::endian order) {
  switch (type) {
    case Scalar::i8:
      return convert<Number, std::int8_t>(bytes, order);
    case Scalar::u8:
      return convert<Number, std::uint8_t>(bytes, order);
    case Scalar::i16:
      return convert<Number, std::int16_t>(bytes, order);
    case Scalar::u16:
      return convert<Number, std::uint16_t>(bytes, order);
    case Scalar::i32:
      return convert<Number, std::int32_t>(bytes, order);
    case Scalar::u32:
      return convert<Number, std::uint32_t>(bytes, order);
    case Scalar::i64:
      return convert<Number, std::int64_t>(bytes, order);
    case Scalar::u64:
      return convert<Number, std::uint64_t>(bytes, order);
    case Scalar::f32:
      return convert<Number, float>(bytes, order);
    case Scalar::f64:
      return convert<Number, double>(bytes, order);
  }
  return Number{};
}

/// A cursor over binary data; every failure throws FileError at the current byte.
class ByteReader {
 public:
  /// @param offset  where in the file the bytes begin, for messages.
  ByteReader(std::string_view bytes, std::string_view file, std::endian order, std::size_t offset = 0)
      : bytes_(bytes), file_(file), order_(order), offset_(offset) {}

  std::size_t remaining() const { return bytes_.size() - at_; }
  std::endian order() const { return order_; }

  /// The next `size` bytes. `what` names them, with an article.
  const char* take(std::size_t size, const char* what) {
    if (size > remaining()) fail_at_end(what);
    const char* const result = bytes_.data() + at_;
    at_ += size;
    return result;
  }
  template <class T>
  T get(const char* what) {
    return load<T>(take(sizeof(T), what), order_);
  }
  double real(Scalar type, const char* what) {
    return load_as<double>(take(size_of(type), what), type, order_);
  }
  std::int64_t integer(Scalar type, const char* what) {
    return load_as<std::int64_t>(take(size_of(type), what), type, order_);
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw FileError::at_byte(file_, offset_ + at_, message);
  }
  [[noreturn]] void fail_at_end(const char* what) const {
    fail(concat("the data end inside ", what,
                ": the file is truncated, or a count in it is too large; get the complete file"));
  }

 private:
  std::string_view bytes_;
  std::string_view file_;
  std::endian order_;
  std::size_t offset_;
  std::size_t at_ = 0;
};

}  // namespace sinkmesh::io_detail
