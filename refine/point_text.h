// SPDX-License-Identifier: MIT
//
// Numbers and points in messages.
#pragma once

#include <charconv>
#include <string>

#include "predicates/point.h"

namespace sinkmesh {

/// As short as reads back as the same double.
inline std::string number_text(double x) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, x).ptr};
}

/// "(1, 0.5, 2)"
template <int Dim>
std::string point_text(const Point<Dim>& p) {
  std::string text;
  for (const double x : p) text += (text.empty() ? "(" : ", ") + number_text(x);
  return text + ')';
}

}  // namespace sinkmesh
