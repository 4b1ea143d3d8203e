// SPDX-License-Identifier: MIT
//
// Rounded vector arithmetic on points, for measures and constructions. Never for decisions on connectivity.
#pragma once

#include "predicates/point.h"

namespace sinkmesh {

template <std::size_t N>
constexpr std::array<double, N> operator-(const std::array<double, N>& a, const std::array<double, N>& b) {
  std::array<double, N> difference{};
  for (std::size_t k = 0; k < N; ++k) difference[k] = a[k] - b[k];
  return difference;
}

template <std::size_t N>
constexpr double dot(const std::array<double, N>& a, const std::array<double, N>& b) {
  double sum = a[0] * b[0];
  for (std::size_t k = 1; k < N; ++k) sum += a[k] * b[k];
  return sum;
}

constexpr Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
constexpr double cross(const Point2& a, const Point2& b) { return a[0] * b[1] - a[1] * b[0]; }

template <std::size_t N>
constexpr double squared_distance(const std::array<double, N>& a, const std::array<double, N>& b) {
  const auto d = a - b;
  return dot(d, d);
}

}  // namespace sinkmesh
