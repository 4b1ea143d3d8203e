// SPDX-License-Identifier: MIT
#include "refine/distance_functions.h"

#include <cmath>
#include <vector>

#include "core/star.h"
#include "core/vector.h"
#include "predicates/constructions.h"
#include "refine/steepest_order.h"

namespace sinkmesh {

template <int Dim>
Point<Dim> DistanceFunctions<Dim>::gated(const Point<Dim>& p) {
  const InputGate<Dim>& gate = triangulation_->gate();
  if (!gate.admits(p)) {
    throw InputError(
        "the point is not finite, or one of its coordinates is not below the first power of two above all "
        "coordinates of the input");
  }
  const Point<Dim> x = gate.in(p);
  triangulation_->announce(x);
  return x;
}

template <int Dim>
Location<Dim> DistanceFunctions<Dim>::locate(const Point<Dim>& gated) {
  const Complex<Dim>& complex = triangulation_->complex();
  // The caller may have changed the triangulation.
  const bool is_good_hint = !hint_.is_null() && hint_.index() < complex.num_slots() && complex.is_alive(hint_);
  const Location<Dim> at = triangulation_->locate(gated, is_good_hint ? hint_ : Simplex());
  hint_ = at.simplex;
  return at;
}

template <int Dim>
double DistanceFunctions<Dim>::in_input_units(double square) const {
  return std::ldexp(square, -2 * triangulation_->gate().exponent());
}

// The nearest vertex v is in the closure of the prestar: the ball with diameter xv lies in the ball around x
// through v and meets its sphere at v only, so it holds no other vertex, not even on its sphere; hence xv is an
// edge of every Delaunay triangulation of S and x, however ties are broken.
template <int Dim>
auto DistanceFunctions<Dim>::pi(const Point<Dim>& x) -> Pi {
  const Point<Dim> center = gated(x);
  const Complex<Dim>& complex = triangulation_->complex();
  const Location<Dim> at = locate(center);
  if (at.is_at_corner()) {
    int i = 0;
    while (at.sign[static_cast<std::size_t>(i)] == 0) ++i;
    return {0, complex.corner(at.simplex, i)};
  }
  triangulation_->grow_prestar(cavity_, center, at.simplex);
  Pi best{HUGE_VAL, {}};
  for (std::size_t n = 0; n < cavity_.num_simplices(); ++n) {
    for (int i = 0; i <= Dim; ++i) {
      // The search has marked corner 0, which corner() hides.
      const Vertex v = complex.corner(cavity_.simplex(n), i);
      if (v.is_infinite()) continue;
      const double value = squared_distance(center, complex.point(v));
      if (value < best.value || (value == best.value && complex.point(v) < complex.point(best.nearest))) {
        best = {value, v};
      }
    }
  }
  triangulation_->release(cavity_);
  best.value = in_input_units(best.value);
  return best;
}

template <int Dim>
Simplex DistanceFunctions<Dim>::with_smallest_power(const Point<Dim>& gated) const {
  const Complex<Dim>& complex = triangulation_->complex();
  Simplex best;
  double smallest = HUGE_VAL;
  for (const Simplex s : complex.simplices()) {
    if (complex.is_ghost(s)) continue;
    const double value = power<Dim>(complex.corners(s), gated);
    if (value < smallest) {
      smallest = value;
      best = s;
    }
  }
  return best;
}

template <int Dim>
auto DistanceFunctions<Dim>::phi(const Point<Dim>& y) -> Phi {
  const Point<Dim> p = gated(y);
  const Complex<Dim>& complex = triangulation_->complex();
  const Location<Dim> at = locate(p);
  Phi result{};
  result.is_inside_hull = !complex.is_ghost(at.simplex);
  if (result.is_inside_hull) {
    std::vector<Vertex> face;
    for (int i = 0; i <= Dim; ++i) {
      if (at.sign[static_cast<std::size_t>(i)] != 0) face.push_back(complex.corner(at.simplex, i));
    }
    std::vector<Simplex> holders = star<Dim>(complex, face, at.simplex);
    std::erase_if(holders, [&](Simplex s) { return complex.is_ghost(s); });
    SteepestOrder<Dim>().sort(complex, holders);
    result.simplex = holders.back();
  } else {
    result.simplex = with_smallest_power(p);
  }
  const Corners<Dim> corners = complex.corners(result.simplex);
  result.value = in_input_units(power<Dim>(corners, p));
  const Point<Dim> towards_center = triangulation_->gate().out(vector_to_circumcenter<Dim>(corners, p));
  for (std::size_t k = 0; k < Dim; ++k) result.gradient[k] = 0.0 - 2 * towards_center[k];
  return result;
}

template class DistanceFunctions<2>;
template class DistanceFunctions<3>;

}  // namespace sinkmesh
