// SPDX-License-Identifier: MIT
//
// Messages out of words and whole numbers.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace sinkmesh::io_detail {

/// The parts one after the other: anything that converts to string_view, and integers in decimal.
template <class... Parts>
std::string concat(const Parts&... parts) {
  std::string out;
  const auto append = [&out](const auto& part) {
    if constexpr (std::integral<std::remove_cvref_t<decltype(part)>>) {
      out += std::to_string(part);
    } else {
      out += std::string_view(part);
    }
  };
  (append(parts), ...);
  return out;
}

}  // namespace sinkmesh::io_detail
