// SPDX-License-Identifier: MIT
#include "tools/text/numbers.h"

#include <fmt/format.h>

#include <cmath>

namespace sinkmesh::text {

std::string grouped(std::uint64_t number) {
  const std::string digits = std::to_string(number);
  std::string result;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i != 0 && (digits.size() - i) % 3 == 0) result += ',';
    result += digits[i];
  }
  return result;
}

std::string count(std::uint64_t number, std::string_view singular, std::string_view plural) {
  return fmt::format("{} {}", grouped(number), number == 1 ? singular : plural);
}

std::string simplices(std::uint64_t number, int dim) {
  return dim == 2 ? count(number, "triangle", "triangles") : count(number, "tetrahedron", "tetrahedra");
}

std::string measure(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : std::string("inf");
}

std::string duration(double seconds) {
  return fmt::format("{:.{}f} s", seconds, seconds < 1 ? 3 : seconds < 100 ? 1 : 0);
}

std::string megabytes(std::uint64_t bytes) { return grouped((bytes + 500'000) / 1'000'000) + " MB"; }

}  // namespace sinkmesh::text
