// SPDX-License-Identifier: MIT
#include "core/location.h"

#include "core/conflict.h"

namespace sinkmesh {
namespace {

// One walk for both: `arrived` is asked at each solid simplex before its facets are.
template <int Dim, class Arrived>
Location<Dim> walk(const Complex<Dim>& complex, const Predicates<Dim>& predicates, const PointArg<Dim>& p,
                   Simplex start, Arrived&& arrived) {
  Location<Dim> at;
  at.simplex = complex.is_ghost(start) ? complex.neighbor(start, Dim) : start;
  int entry = -1;
  for (;;) {
    ++at.steps;
    if (arrived(at.simplex)) return at;
    const Corners<Dim> corners = complex.corners(at.simplex);
    HalfFacet exit;
    // The facets are asked in a turning order: always the same first facet would draw the walk along one
    // direction.
    for (int k = 0; k <= Dim; ++k) {
      const int i = (k + at.steps) % (Dim + 1);
      at.sign[static_cast<std::size_t>(i)] =
          1;  // p was strictly beyond the facet of entry, seen from the other side
      if (i == entry) continue;
      Corners<Dim> seen = corners;
      seen[static_cast<std::size_t>(i)] = &p;
      const int side = predicates.orient(seen);
      if (side < 0) {
        exit = complex.mate(Complex<Dim>::half_facet(at.simplex, i));
        break;
      }
      at.sign[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(side);
    }
    if (exit.is_null()) return at;
    at.simplex = Complex<Dim>::simplex_of(exit);
    entry = Complex<Dim>::corner_of(exit);
    if (complex.is_ghost(at.simplex)) {
      at.sign = {};
      return at;
    }
  }
}

}  // namespace

template <int Dim>
Location<Dim> walk_to(const Complex<Dim>& complex, const Predicates<Dim>& predicates, const PointArg<Dim>& p,
                      Simplex start) {
  return walk(complex, predicates, p, start, [](Simplex) { return false; });
}

template <int Dim>
Location<Dim> walk_to_conflict(const Complex<Dim>& complex, const Predicates<Dim>& predicates,
                               const PointArg<Dim>& p, Simplex start) {
  return walk(complex, predicates, p, start,
              [&](Simplex s) { return predicates.in_sphere(complex.corners(s), p) > 0; });
}

template Location<2> walk_to(const Complex<2>&, const Predicates<2>&, const Point2&, Simplex);
template Location<3> walk_to(const Complex<3>&, const Predicates<3>&, const Point3&, Simplex);
template Location<2> walk_to_conflict(const Complex<2>&, const Predicates<2>&, const Point2&, Simplex);
template Location<3> walk_to_conflict(const Complex<3>&, const Predicates<3>&, const Point3&, Simplex);

}  // namespace sinkmesh
