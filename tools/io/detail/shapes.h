// SPDX-License-Identifier: MIT
//
// The names that the mesh formats give to the simplices of each dimension, and to their facets.
#pragma once

#include <cstdint>

namespace sinkmesh::io_detail {

template <int Dim>
struct Shapes;

template <>
struct Shapes<2> {
  static constexpr const char* kSimplex = "triangle";
  static constexpr const char* kFacet = "edge";
  static constexpr int kVtkSimplex = 5;
  static constexpr int kVtkFacet = 3;
  static constexpr int kGmshSimplex = 2;
  static constexpr int kGmshFacet = 1;
  static constexpr const char* kMeditSimplices = "Triangles";
  static constexpr const char* kMeditFacets = "Edges";
  static constexpr const char* kTetgenFacets = ".edge";
};

template <>
struct Shapes<3> {
  static constexpr const char* kSimplex = "tetrahedron";
  static constexpr const char* kFacet = "triangle";
  static constexpr int kVtkSimplex = 10;
  static constexpr int kVtkFacet = 5;
  static constexpr int kGmshSimplex = 4;
  static constexpr int kGmshFacet = 2;
  static constexpr const char* kMeditSimplices = "Tetrahedra";
  static constexpr const char* kMeditFacets = "Triangles";
  static constexpr const char* kTetgenFacets = ".face";
};

}  // namespace sinkmesh::io_detail
