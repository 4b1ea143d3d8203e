// SPDX-License-Identifier: MIT
//
// Groups of four digits, three bytes each.
#include "tools/io/detail/base64.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace sinkmesh::io_detail {
namespace {

constexpr int kNotADigit = -1;
constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr std::array<int, 256> digit_values() {
  std::array<int, 256> values{};
  values.fill(kNotADigit);
  for (std::size_t i = 0; i < kDigits.size(); ++i) {
    values[static_cast<unsigned char>(kDigits[i])] = static_cast<int>(i);
  }
  return values;
}
constexpr std::array<int, 256> kValues = digit_values();

}  // namespace

std::string decode_base64(std::string_view& text, std::size_t limit) {
  std::string out;
  out.reserve(std::min(limit, text.size() / 4 * 3 + 3));
  std::uint32_t group = 0;
  int digits = 0;
  int padding = 0;
  std::size_t i = 0;
  for (; i < text.size() && out.size() < limit && padding == 0; ++i) {
    const char c = text[i];
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') continue;
    int value = kValues[static_cast<unsigned char>(c)];
    if (c == '=' && digits >= 2) {
      padding = 4 - digits;
      group <<= 6 * padding;
      digits = 4;
      // The second of two signs.
      if (padding == 2 && i + 1 < text.size() && text[i + 1] == '=') ++i;
    } else if (value == kNotADigit) {
      break;
    } else {
      group = group << 6 | static_cast<std::uint32_t>(value);
      ++digits;
    }
    if (digits == 4) {
      for (int k = 0; k < 3 - padding; ++k) out += static_cast<char>(group >> (16 - 8 * k) & 0xff);
      group = 0;
      digits = 0;
    }
  }
  text.remove_prefix(i);
  if (out.size() > limit) out.resize(limit);
  return out;
}

std::string encode_base64(std::string_view bytes) {
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) out += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

}  // namespace sinkmesh::io_detail
