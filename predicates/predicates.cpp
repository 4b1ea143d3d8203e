// SPDX-License-Identifier: MIT
//
// The predicates for raw doubles.
#include "predicates/predicates.h"

#include "predicates/detail/symbolic.h"
#include "predicates/verdict.h"

namespace sinkmesh {
namespace {

using namespace detail;

template <class P>
int sign_of(const Points<P>& points) {
  return decide<P>(points).sign;
}

template <int Dim>
int perturbed_in_sphere(const Points<InSphere<Dim>>& points) {
  if (const int s = sign_of<InSphere<Dim>>(points); s != 0) return s;
  return in_sphere_at_tie<Dim>(points, sign_of<Orientation<Dim>>);
}

template <int Dim>
int perturbed_diametral_side(const Points<Diametral<Dim>>& points) {
  if (const int s = sign_of<Diametral<Dim>>(points); s != 0) return s;
  return flow_at_tie<Dim>(points, sign_of<FacetNormals<Dim>>);
}

/// The polynomial is the value times both volumes.
template <int Dim>
int signed_orthogonality(const std::array<Point<Dim>, Dim + 1>& s, const std::array<Point<Dim>, Dim + 1>& t) {
  Points<Orientation<Dim>> first;
  Points<Orientation<Dim>> second;
  Points<Orthogonality<Dim>> all;
  for (std::size_t i = 0; i <= Dim; ++i) {
    all[i] = first[i] = &s[i];
    all[i + Dim + 1] = second[i] = &t[i];
  }
  return sign_of<Orthogonality<Dim>>(all) * sign_of<Orientation<Dim>>(first) *
         sign_of<Orientation<Dim>>(second);
}

}  // namespace

int orient2d(const Point2& a, const Point2& b, const Point2& c) {
  return sign_of<Orientation<2>>({&a, &b, &c});
}
int orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return sign_of<Orientation<3>>({&a, &b, &c, &d});
}

int incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return sign_of<InSphere<2>>({&a, &b, &c, &d});
}
int insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  return sign_of<InSphere<3>>({&a, &b, &c, &d, &e});
}
int incircle_sos(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return perturbed_in_sphere<2>({&a, &b, &c, &d});
}
int insphere_sos(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  return perturbed_in_sphere<3>({&a, &b, &c, &d, &e});
}

int diametral_side(const Point2& a, const Point2& b, const Point2& x) {
  return sign_of<Diametral<2>>({&a, &b, &x});
}
int diametral_side(const Point3& a, const Point3& b, const Point3& c, const Point3& x) {
  return sign_of<Diametral<3>>({&a, &b, &c, &x});
}
int diametral_side_sos(const Point2& a, const Point2& b, const Point2& x) {
  return perturbed_diametral_side<2>({&a, &b, &x});
}
int diametral_side_sos(const Point3& a, const Point3& b, const Point3& c, const Point3& x) {
  return perturbed_diametral_side<3>({&a, &b, &c, &x});
}

int orthogonality(const std::array<Point2, 3>& s, const std::array<Point2, 3>& t) {
  return signed_orthogonality<2>(s, t);
}
int orthogonality(const std::array<Point3, 4>& s, const std::array<Point3, 4>& t) {
  return signed_orthogonality<3>(s, t);
}

}  // namespace sinkmesh
