// SPDX-License-Identifier: MIT
//
// Exact signs of the geometric polynomials. Nothing else in the project decides what is connected to what.
//
// Stages, in this order; each certifies the sign or hands over to the next:
//   static       rounded value against a bound that holds for the whole point set     (Predicates<Dim> only)
//   local        the same with the extents of the points at hand
//   granularity  |value| + error < g^k, where all coordinates are multiples of g: an exact zero
//                (Predicates<Dim> only; again after permanent)
//   box          the points are corners of one axis-parallel box (or share a coordinate): an exact zero
//   permanent    Shewchuk's a-priori bound, from the permanent of the same expression  [S97]
//   integer64    the scaled differences are integers below 2^62, checked at run time: fixed-width integers
//   integer128   the same with two limbs; always holds behind the input gate
//   expansion    Shewchuk's adaptive expansions, for raw doubles that passed no gate
// and, in the `_sos` functions only,
//   symbolic     the first nonzero coefficient of the polynomial perturbed in the lifted coordinate [EM90]
//
// Sign:  orient2d > 0 for a counterclockwise triangle; orient3d > 0 for the tetrahedron (0, e1, e2, e3):
//        d lies on the side of (b-a) x (c-a). Shewchuk's predicates.c has the opposite sign for orient3d.
//        incircle, insphere > 0 when the last point is strictly inside, for a positively oriented simplex.
// Laws:  swapping two of the first Dim+1 points negates orient*, incircle, insphere. diametral_side is
//        symmetric in the points of the facet. `_sos` never returns 0 for a simplex of nonzero volume and
//        distinct points, and never changes a sign that is not 0.
// Sites: ranked by the lexicographic order of their coordinates. Every weight is negative, -eps_rank, with
//        eps_0 >> eps_1 >> ...: a cospherical query point ranked first is not in conflict; an apex on the
//        diametral sphere, ranked first, has no flow.
// Input: finite. Exact for exponents within [PS, 11], for instance after the input gate (input_gate.h).
// Build: needs -ffp-contract=off (the CMake target requires it); refuses -ffast-math and x87 arithmetic.
#pragma once

#include "predicates/point.h"

namespace sinkmesh {

/// Sign of the signed area of abc.
int orient2d(const Point2& a, const Point2& b, const Point2& c);
/// Sign of the signed volume of abcd.
int orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// Is d inside the circle of abc? Requires nothing; the meaning "inside" needs orient2d(a,b,c) > 0.
int incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
/// Is e inside the sphere of abcd? Requires nothing; the meaning "inside" needs orient3d(a,b,c,d) > 0.
int insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e);
/// The same after perturbation: never 0. Requires a positively oriented simplex, and distinct points.
int incircle_sos(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
int insphere_sos(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e);

/// Is x inside (-1), on (0), outside (+1) the diametral sphere of a facet: the smallest sphere through its
/// points? Sign of the polynomial G of [PS, 1] (in the plane of (a-x).(b-x)). For the apex x of a simplex, -1
/// says that its circumcenter lies strictly beyond the facet: the simplex flows across it [EG01, 3.3].
int diametral_side(const Point2& a, const Point2& b, const Point2& x);
int diametral_side(const Point3& a, const Point3& b, const Point3& c, const Point3& x);
/// The same after perturbation: never 0. Requires that the facet and x span a simplex of nonzero volume.
int diametral_side_sos(const Point2& a, const Point2& b, const Point2& x);
int diametral_side_sos(const Point3& a, const Point3& b, const Point3& c, const Point3& x);

/// Sign of |z1-z2|^2 - r1^2 - r2^2 for the circumspheres (z,r) of two simplices of nonzero volume, of any
/// orientation: +1 further than orthogonal, 0 orthogonal, -1 closer [EG01, 4.4].
int orthogonality(const std::array<Point2, 3>& s, const std::array<Point2, 3>& t);
int orthogonality(const std::array<Point3, 4>& s, const std::array<Point3, 4>& t);

}  // namespace sinkmesh
