// SPDX-License-Identifier: MIT
//
// Meshes whose coordinates are hard to write down.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "refine/mesh.h"
#include "refine/surface.h"
#include "test/support/temporary_folder.h"

namespace sinkmesh::test {

/// Doubles that a careless writer or reader changes.
inline std::vector<double> awkward_numbers() {
  std::vector<double> numbers = {0.0,
                                 -0.0,
                                 5e-324,
                                 -5e-324,
                                 4.9e-320,
                                 DBL_MIN,
                                 std::nextafter(DBL_MIN, 0),
                                 1e300,
                                 -1e300,
                                 DBL_MAX,
                                 -DBL_MAX,
                                 0.1,
                                 std::nextafter(0.1, 0),
                                 std::nextafter(0.1, 1),
                                 1.0,
                                 std::nextafter(1.0, 0),
                                 std::nextafter(1.0, 2),
                                 1.0 / 3,
                                 1e22,
                                 1e23,
                                 9007199254740993e0,
                                 123456789.123456789,
                                 2.2250738585072011e-308,
                                 FLT_MAX,
                                 1e-7};
  std::mt19937_64 random(7);
  while (numbers.size() < 300) {
    const auto x = std::bit_cast<double>(random());
    if (std::isfinite(x)) numbers.push_back(x);
  }
  return numbers;
}

/// Points that differ as numbers, made of the awkward ones.
template <int Dim>
std::vector<Point<Dim>> awkward_points(std::size_t count = 100) {
  const std::vector<double> numbers = awkward_numbers();
  std::vector<Point<Dim>> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < Dim; ++k) points[i][k] = numbers[(3 * i + k) % numbers.size()];
  }
  return points;
}

/// Indices that are only a pattern: writers and readers look at no geometry.
template <class Cell>
std::vector<Cell> patterned_cells(std::size_t count, std::size_t points) {
  std::vector<Cell> cells(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < cells[i].size(); ++k) {
      cells[i][k] = static_cast<std::uint32_t>((7 * i + 11 * k + i * k) % points);
    }
  }
  return cells;
}

template <int Dim>
Mesh<Dim> awkward_mesh() {
  Mesh<Dim> mesh;
  mesh.points = awkward_points<Dim>();
  mesh.simplices = patterned_cells<typename Mesh<Dim>::Simplex>(61, mesh.points.size());
  mesh.boundary = patterned_cells<typename Mesh<Dim>::Facet>(23, mesh.points.size());
  return mesh;
}

/// Every point is used, in order, so that formats without ids number them alike; then once more in another.
template <int Dim>
Surface<Dim> awkward_surface() {
  Surface<Dim> surface;
  surface.points = awkward_points<Dim>(99);
  const auto count = static_cast<std::uint32_t>(surface.points.size());
  for (std::uint32_t v = 0; v < 2 * count; v += Dim) {
    typename Surface<Dim>::Facet& facet = surface.facets.emplace_back();
    for (std::uint32_t k = 0; k < Dim; ++k) facet[k] = v < count ? (v + k) % count : (5 * v + 17 * k) % count;
  }
  return surface;
}

/// Equality of bits: 0.0 and -0.0 differ.
template <int Dim>
void expect_same_bits(const std::vector<Point<Dim>>& expected, const std::vector<Point<Dim>>& found) {
  ASSERT_EQ(expected.size(), found.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    for (std::size_t k = 0; k < Dim; ++k) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(expected[i][k]), std::bit_cast<std::uint64_t>(found[i][k]))
          << "point " << i << ", coordinate " << k << ": " << std::hexfloat << expected[i][k] << " became "
          << found[i][k];
    }
  }
}

}  // namespace sinkmesh::test
