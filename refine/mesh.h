// SPDX-License-Identifier: MIT
//
// What comes out: a mesh as plain arrays.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "predicates/point.h"

namespace sinkmesh {

/// A face-to-face mesh, simplices positively oriented. Points of the input come first and keep their ids.
template <int Dim>
struct Mesh {
  using Simplex = std::array<std::uint32_t, Dim + 1>;
  using Facet = std::array<std::uint32_t, Dim>;

  /// One value per simplex or per boundary facet (region, parent, ...), written by every format that has room
  /// for it.
  struct Field {
    std::string name;
    std::vector<std::int64_t> values;
  };

  std::vector<Point<Dim>> points;
  std::vector<Simplex> simplices;
  /// Boundary facets, oriented with their normals outward. A facet between two regions is listed once, with its
  /// normal out of the region of the smaller number.
  std::vector<Facet> boundary;
  std::vector<Field> simplex_fields;
  std::vector<Field> boundary_fields;
};
using Mesh2 = Mesh<2>;
using Mesh3 = Mesh<3>;

}  // namespace sinkmesh
