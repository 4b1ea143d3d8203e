// SPDX-License-Identifier: MIT
//
// Numbers that belong to simplices, computed exactly and rounded at the end. For measures and drawings; nothing
// decides by them what is connected to what.
#pragma once

#include "predicates/point.h"

namespace sinkmesh {

/// The weighted square distance |y-z|^2 - r^2 of y from the circumsphere (z,r) of a simplex [EG01, 3.1]:
/// negative inside, 0 exactly on it. Relative error below 2^-52, however flat the simplex is, because both
/// polynomials of the quotient -in_sphere / orient are evaluated exactly.
/// Requires points that passed the input gate, and a simplex of nonzero volume, of any orientation.
template <int Dim>
double power(const Corners<Dim>& s, const PointArg<Dim>& y);

/// The vector from y to the circumcenter of a simplex; half the negative gradient of power() at y. Each
/// coordinate is wrong by less than 2^-52 of itself, plus 2^-98 of the distance from the first corner to the
/// center. For y = 0 it is the center itself, also where circumcenter() has none because it is far away.
/// Requires the same as power().
template <int Dim>
Point<Dim> vector_to_circumcenter(const Corners<Dim>& s, const PointArg<Dim>& y);

/// The squared circumradius of a simplex: relative error below 2^-49, however flat it is; infinite if the
/// volume is 0. Requires points that passed the input gate.
template <int Dim>
double circumradius2(const Corners<Dim>& s);

/// A normal of a facet whose corners are counterclockwise seen from where it points: (b-a) x (c-a), in the
/// plane the edge turned clockwise. Each coordinate has a relative error below 2^-52; so its sign is exact, and
/// so is 0. Requires points that passed the input gate.
template <int Dim>
Point<Dim> facet_normal(const FacetCorners<Dim>& facet);

}  // namespace sinkmesh
