// SPDX-License-Identifier: MIT
//
// Points, boxes, and the pointers to points that predicates take.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "predicates/build_guard.h"

namespace sinkmesh {

/// A point of R^Dim. Compares lexicographically, which is the rank of the simulation of simplicity.
template <int Dim>
using Point = std::array<double, Dim>;
using Point2 = Point<2>;
using Point3 = Point<3>;

/// The same as a parameter from which Dim is not deduced: std::array counts in another type.
template <int Dim>
using PointArg = std::type_identity_t<Point<Dim>>;

/// The Dim+1 corners of a simplex, in its own order.
template <int Dim>
using Corners = std::array<const Point<Dim>*, Dim + 1>;

/// The Dim corners of a facet.
template <int Dim>
using FacetCorners = std::array<const Point<Dim>*, Dim>;

/// An axis-parallel box, closed. Default: empty, ready for include().
template <int Dim>
struct Box {
  Point<Dim> low = filled(+HUGE_VAL);
  Point<Dim> high = filled(-HUGE_VAL);

  void include(const Point<Dim>& p) {
    for (std::size_t k = 0; k < Dim; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }

  bool contains(const Point<Dim>& p) const {
    for (std::size_t k = 0; k < Dim; ++k) {
      if (!(low[k] <= p[k] && p[k] <= high[k])) return false;
    }
    return true;
  }

 private:
  static constexpr Point<Dim> filled(double value) {
    Point<Dim> p{};
    p.fill(value);
    return p;
  }
};

}  // namespace sinkmesh
