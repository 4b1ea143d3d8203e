// SPDX-License-Identifier: MIT
#include "predicates/constructions.h"

#include <cmath>

#include "predicates/detail/quotient.h"
#include "predicates/error.h"

namespace sinkmesh {
namespace detail {
namespace {

template <int Dim>
struct FacetVectors;
template <>
struct FacetVectors<2> {
  static constexpr std::size_t kDim = 2, kPoints = 2;
  static constexpr std::array<Difference, 1> kVectors{{{1, 0}}};
};
template <>
struct FacetVectors<3> {
  static constexpr std::size_t kDim = 3, kPoints = 3;
  static constexpr std::array<Difference, 2> kVectors{{{1, 0}, {2, 0}}};
};

// Behind the gate 123 bits always hold the differences; the scale is a power of two.
template <class P>
int exact_vectors(const Points<P>& points, Vectors<P, FixedInt<kBits128>>& vectors) {
  const double scale = scaled_integers<P, kBits128>(points, vectors);
  SINKMESH_ASSERT(scale != 0);
  return std::ilogb(scale);
}

}  // namespace
}  // namespace detail

template <int Dim>
double power(const Corners<Dim>& s, const PointArg<Dim>& y) {
  using namespace detail;
  Points<InSphere<Dim>> points;
  for (std::size_t i = 0; i <= Dim; ++i) points[i] = s[i];
  points[Dim + 1] = &y;
  Vectors<InSphere<Dim>, FixedInt<kBits128>> lifted;
  Vectors<Orientation<Dim>, FixedInt<kBits128>> plain;
  const int lifted_exponent = exact_vectors<InSphere<Dim>>(points, lifted);
  const int exponent = exact_vectors<Orientation<Dim>>(s, plain);
  const TwoTerms q =
      divide(to_two_terms(InSphere<Dim>::value(lifted)), to_two_terms(Orientation<Dim>::value(plain)));
  return std::ldexp(-q.head, InSphere<Dim>::kDegree * -lifted_exponent + Orientation<Dim>::kDegree * exponent) +
         0.0;
}

template <int Dim>
Point<Dim> vector_to_circumcenter(const Corners<Dim>& s, const PointArg<Dim>& y) {
  using namespace detail;
  using P = FromFirstCorner<Dim>;
  Vectors<P, FixedInt<kBits128>> vectors;
  const int exponent = exact_vectors<P>(s, vectors);
  const auto quotient = P::quotient(vectors);
  const TwoTerms d = to_two_terms(quotient.d);
  Point<Dim> result;
  for (std::size_t k = 0; k < Dim; ++k) {
    // z - y = (a - y) + q, with a - y exact.
    const TwoTerms q = divide(to_two_terms(quotient.y[k]), d);
    const TwoTerms base = two_diff((*s[0])[k], y[k]);
    const TwoTerms sum = two_sum(base.head, std::ldexp(q.head, -exponent - 1));
    result[k] = sum.head + (sum.tail + (base.tail + std::ldexp(q.tail, -exponent - 1)));
  }
  return result;
}

template <int Dim>
double circumradius2(const Corners<Dim>& s) {
  using namespace detail;
  using P = FromFirstCorner<Dim>;
  Vectors<P, FixedInt<kBits128>> vectors;
  const int exponent = exact_vectors<P>(s, vectors);
  const auto quotient = P::quotient(vectors);
  if (quotient.d.sign() == 0) return HUGE_VAL;
  const TwoTerms d = to_two_terms(quotient.d);
  double radius2 = 0;
  for (std::size_t k = 0; k < Dim; ++k) {
    const double component = std::ldexp(divide(to_two_terms(quotient.y[k]), d).head, -exponent - 1);
    radius2 += component * component;
  }
  return radius2;
}

template <int Dim>
Point<Dim> facet_normal(const FacetCorners<Dim>& facet) {
  using namespace detail;
  Vectors<FacetVectors<Dim>, FixedInt<kBits128>> v;
  const int exponent = exact_vectors<FacetVectors<Dim>>(facet, v);
  if constexpr (Dim == 2) {
    return {std::ldexp(to_two_terms(v[0][1]).head, -exponent),
            0.0 - std::ldexp(to_two_terms(v[0][0]).head, -exponent)};
  } else {
    const auto normal = cross(v[0], v[1]);
    Point<Dim> result;
    for (std::size_t k = 0; k < Dim; ++k) {
      result[k] = std::ldexp(to_two_terms(normal[k]).head, -2 * exponent);
    }
    return result;
  }
}

template double power<2>(const Corners<2>&, const Point2&);
template double power<3>(const Corners<3>&, const Point3&);
template Point2 vector_to_circumcenter<2>(const Corners<2>&, const Point2&);
template Point3 vector_to_circumcenter<3>(const Corners<3>&, const Point3&);
template double circumradius2<2>(const Corners<2>&);
template double circumradius2<3>(const Corners<3>&);
template Point2 facet_normal<2>(const FacetCorners<2>&);
template Point3 facet_normal<3>(const FacetCorners<3>&);

}  // namespace sinkmesh
