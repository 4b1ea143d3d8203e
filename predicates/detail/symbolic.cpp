// SPDX-License-Identifier: MIT
#include "predicates/detail/symbolic.h"

#include "predicates/detail/stages.h"

namespace sinkmesh::detail {

// The coefficients are -|b-a|^2 for the apex c, (a-b).(c-b) for a and (b-a).(c-a) for b [PS, 2].
int flow_tie(const std::array<const Point2*, 3>& points) {
  const auto& [a, b, c] = points;
  return first_coefficient(points, [&](std::size_t i) {
    if (i == 2) return -1;
    return i == 0 ? exact_sign<DiametralCircle>({a, c, b}, 0).sign
                  : exact_sign<DiametralCircle>({b, c, a}, 0).sign;
  });
}

// -N_d . N_d is negative. Swapping the other two corners of the facet turns both normals over and keeps their
// product.
int flow_tie(const std::array<const Point3*, 4>& points) {
  const Point3* const apex = points[3];
  return first_coefficient(points, [&](std::size_t i) {
    if (i == 3) return -1;
    return -exact_sign<FacetNormals>({points[(i + 1) % 3], points[i], points[(i + 2) % 3], apex}, 0).sign;
  });
}

}  // namespace sinkmesh::detail
