// SPDX-License-Identifier: MIT
#include "refine/flower.h"

#include <algorithm>

namespace sinkmesh {

template <int Dim>
FlowerSide flower_side(const Triangulation<Dim>& triangulation, std::span<const Simplex> set,
                       const PointArg<Dim>& y) {
  const Complex<Dim>& complex = triangulation.complex();
  int side = -1;
  for (const Simplex s : set) {
    if (complex.is_ghost(s)) continue;
    side = std::max(side, triangulation.predicates().in_sphere_unperturbed(complex.corners(s), y));
    if (side > 0) break;
  }
  return static_cast<FlowerSide>(side);
}

template FlowerSide flower_side<2>(const Triangulation<2>&, std::span<const Simplex>, const Point2&);
template FlowerSide flower_side<3>(const Triangulation<3>&, std::span<const Simplex>, const Point3&);

}  // namespace sinkmesh
