// SPDX-License-Identifier: MIT
#include "refine/independence.h"

#include <algorithm>

namespace sinkmesh {

template <int Dim>
bool have_disjoint_closures(const Complex<Dim>& complex, std::span<const Simplex> prestar_of_x,
                            std::span<const Simplex> prestar_of_y) {
  const std::vector<Vertex> of_x = closure_vertices(complex, prestar_of_x);
  const std::vector<Vertex> of_y = closure_vertices(complex, prestar_of_y);
  return std::none_of(of_x.begin(), of_x.end(),
                      [&](Vertex v) { return std::binary_search(of_y.begin(), of_y.end(), v); });
}

template <int Dim>
bool are_independent(Triangulation<Dim>& triangulation, const PointArg<Dim>& x, const PointArg<Dim>& y) {
  const std::vector<Simplex> prestar_of_x = prestar(triangulation, x);
  const std::vector<Simplex> prestar_of_y = prestar(triangulation, y);
  return have_disjoint_closures<Dim>(triangulation.complex(), prestar_of_x, prestar_of_y);
}

template bool have_disjoint_closures(const Complex<2>&, std::span<const Simplex>, std::span<const Simplex>);
template bool have_disjoint_closures(const Complex<3>&, std::span<const Simplex>, std::span<const Simplex>);
template bool are_independent<2>(Triangulation<2>&, const Point2&, const Point2&);
template bool are_independent<3>(Triangulation<3>&, const Point3&, const Point3&);

}  // namespace sinkmesh
