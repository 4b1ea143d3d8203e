// SPDX-License-Identifier: MIT
//
// A look inside: the simplices on one side of a plane, and what is seen of them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "refine/mesh.h"

namespace sinkmesh::reproduce {

/// A plane; what lies on the side of its normal is taken away.
struct Cut {
  Point3 normal;
  Point3 through;

  bool keeps(const Point3& p) const;
};

/// One value per tetrahedron, in the order of the mesh: whether its centroid is kept. Whole tetrahedra stay,
/// hence the cut is jagged and shows their shapes.
std::vector<bool> kept_simplices(const Mesh3& mesh, const Cut& cut);

/// A face of exactly one tetrahedron that is kept.
struct VisibleFace {
  std::array<std::uint32_t, 3> corners;  ///< counterclockwise seen from outside of what is kept
  std::uint32_t simplex;                 ///< that is kept
  bool on_cut;                           ///< or else on the surface of the mesh
};

/// In the order of simplices. Cost: n log n.
std::vector<VisibleFace> visible_faces(const Mesh3& mesh, const std::vector<bool>& kept);

}  // namespace sinkmesh::reproduce
