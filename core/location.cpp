// SPDX-License-Identifier: MIT
#include "core/location.h"

#include "core/conflict.h"

namespace sinkmesh {

template <int Dim>
Location<Dim> walk_to(const Complex<Dim>& complex, const Predicates<Dim>& predicates, const PointArg<Dim>& p,
                      Simplex start) {
  return visibility_walk(
      complex, predicates, p, start, [](Simplex) { return false; }, [](HalfFacet) { return true; });
}

template <int Dim>
Location<Dim> walk_to_conflict(const Complex<Dim>& complex, const Predicates<Dim>& predicates,
                               const PointArg<Dim>& p, Simplex start) {
  return visibility_walk(
      complex, predicates, p, start, [&](Simplex s) { return predicates.in_sphere(complex.corners(s), p) > 0; },
      [](HalfFacet) { return true; });
}

template Location<2> walk_to(const Complex<2>&, const Predicates<2>&, const Point2&, Simplex);
template Location<3> walk_to(const Complex<3>&, const Predicates<3>&, const Point3&, Simplex);
template Location<2> walk_to_conflict(const Complex<2>&, const Predicates<2>&, const Point2&, Simplex);
template Location<3> walk_to_conflict(const Complex<3>&, const Predicates<3>&, const Point3&, Simplex);

}  // namespace sinkmesh
