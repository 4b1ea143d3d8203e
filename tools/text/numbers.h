// SPDX-License-Identifier: MIT
//
// Numbers as people read them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace sinkmesh::text {

/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number);
/// "1 facet", "2,390 facets"; for words whose plural is not an s away: "1 vertex", "3 vertices".
std::string count(std::uint64_t number, std::string_view singular, std::string_view plural);
/// What a simplex is called: "triangle(s)", "tetrahedron", "tetrahedra".
std::string simplices(std::uint64_t number, int dim);
/// A ratio, an angle: four significant digits, or "inf".
std::string measure(double value);
/// "0.012 s", "3.4 s", "125 s".
std::string duration(double seconds);
/// "34 MB"
std::string megabytes(std::uint64_t bytes);

}  // namespace sinkmesh::text
