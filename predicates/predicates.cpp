// SPDX-License-Identifier: MIT
#include "predicates/predicates.h"

#include "predicates/detail/stages.h"
#include "predicates/detail/symbolic.h"

namespace sinkmesh {
namespace {

using namespace detail;

template <class Form>
int sign_of(const typename Form::Points& points) {
  return exact_sign<Form>(points, 0).sign;
}

template <int Dim>
int orthogonality_of(const std::array<Point<Dim>, Dim + 1>& s, const std::array<Point<Dim>, Dim + 1>& t) {
  typename Orthogonality<Dim>::Points points;
  for (std::size_t i = 0; i <= Dim; ++i) {
    points[i] = &s[i];
    points[i + Dim + 1] = &t[i];
  }
  const int sign = sign_of<Orthogonality<Dim>>(points);
  if (sign == 0) return 0;
  if constexpr (Dim == 2) {
    return sign * orient2d(s[0], s[1], s[2]) * orient2d(t[0], t[1], t[2]);
  } else {
    return sign * orient3d(s[0], s[1], s[2], s[3]) * orient3d(t[0], t[1], t[2], t[3]);
  }
}

}  // namespace

int orient2d(const Point2& a, const Point2& b, const Point2& c) { return sign_of<Orient2d>({&a, &b, &c}); }
int orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return sign_of<Orient3d>({&a, &b, &c, &d});
}
int incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return sign_of<Incircle>({&a, &b, &c, &d});
}
int insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  return sign_of<Insphere>({&a, &b, &c, &d, &e});
}

int incircle_sos(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  if (const int sign = incircle(a, b, c, d)) return sign;
  return in_sphere_tie(Incircle::Points{&a, &b, &c, &d}, sign_of<Orient2d>);
}
int insphere_sos(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  if (const int sign = insphere(a, b, c, d, e)) return sign;
  return in_sphere_tie(Insphere::Points{&a, &b, &c, &d, &e}, sign_of<Orient3d>);
}

int diametral_side(const Point2& a, const Point2& b, const Point2& x) {
  return sign_of<DiametralCircle>({&a, &b, &x});
}
int diametral_side(const Point3& a, const Point3& b, const Point3& c, const Point3& x) {
  return sign_of<DiametralSphere>({&a, &b, &c, &x});
}
int diametral_side_sos(const Point2& a, const Point2& b, const Point2& x) {
  if (const int sign = diametral_side(a, b, x)) return sign;
  return flow_tie({&a, &b, &x});
}
int diametral_side_sos(const Point3& a, const Point3& b, const Point3& c, const Point3& x) {
  if (const int sign = diametral_side(a, b, c, x)) return sign;
  return flow_tie({&a, &b, &c, &x});
}

int orthogonality(const std::array<Point2, 3>& s, const std::array<Point2, 3>& t) {
  return orthogonality_of<2>(s, t);
}
int orthogonality(const std::array<Point3, 4>& s, const std::array<Point3, 4>& t) {
  return orthogonality_of<3>(s, t);
}

}  // namespace sinkmesh
