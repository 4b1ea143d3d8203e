// SPDX-License-Identifier: MIT
//
// The input of a fuzz target as numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace sinkmesh::fuzz {

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : left_(data, size) {}

  bool empty() const { return left_.empty(); }

  /// Zeros beyond the end.
  template <class T>
  T take() {
    T value{};
    const std::size_t n = std::min(left_.size(), sizeof value);
    if (n != 0) std::memcpy(&value, left_.data(), n);
    left_ = left_.subspan(n);
    return value;
  }

  /// A coordinate: a small integer, a longer one with an exponent, or any double, by `kind`.
  double coordinate(unsigned kind) {
    switch (kind % 3) {
      case 0:
        return take<std::int8_t>();
      case 1: {
        const auto mantissa = take<std::int32_t>();
        return std::ldexp(mantissa, take<std::int8_t>() / 2);
      }
      default:
        return take<double>();
    }
  }

 private:
  std::span<const std::uint8_t> left_;
};

}  // namespace sinkmesh::fuzz
