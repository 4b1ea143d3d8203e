// SPDX-License-Identifier: MIT
//
// The polynomials behind the predicates, each written once and evaluated over every number type: doubles
// (filters), magnitudes (permanents), fixed-width integers, expansions.
//
// A polynomial takes vectors, which are differences of its points: vector i is point kVectors[i].from minus
// point kVectors[i].to. It names
//   kDegree       it is homogeneous of this degree in the coordinates;
//   kErrorBound   |rounded value - exact value| <= kErrorBound * permanent, where the permanent is the same
//                 expression with magnitudes for the vectors and additions for the subtractions [PS, 0];
//   value()       the expression; the error bound depends on the order of its operations;
//   majorant()    no permanent is larger, up to rounding, if no |difference| along axis k exceeds extents[k];
//   is_zero()     only where there is a cheap sufficient condition on the coordinates for an exact zero.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "predicates/build_guard.h"
#include "predicates/point.h"

namespace sinkmesh::detail {

/// Unit roundoff of binary64.
inline constexpr double kUnit = 0x1p-53;

struct Difference {
  std::size_t from;
  std::size_t to;
};

template <class P>
using Points = std::array<const Point<P::kDim>*, P::kPoints>;

template <class P, class T>
using Vectors = std::array<std::array<T, P::kDim>, P::kVectors.size()>;

/// The vectors of P, rounded.
template <class P>
inline Vectors<P, double> rounded_vectors(const Points<P>& p) {
  Vectors<P, double> v;
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (std::size_t k = 0; k < P::kDim; ++k) {
      v[i][k] = (*p[P::kVectors[i].from])[k] - (*p[P::kVectors[i].to])[k];
    }
  }
  return v;
}

template <class T, class U>
auto dot(const std::array<T, 2>& v, const std::array<U, 2>& w) {
  return v[0] * w[0] + v[1] * w[1];
}
template <class T, class U>
auto dot(const std::array<T, 3>& v, const std::array<U, 3>& w) {
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}
template <class T>
auto cross(const std::array<T, 2>& v, const std::array<T, 2>& w) {
  return v[0] * w[1] - v[1] * w[0];
}
template <class T>
auto cross(const std::array<T, 3>& v, const std::array<T, 3>& w) {
  const auto x = v[1] * w[2] - v[2] * w[1];
  const auto y = v[2] * w[0] - v[0] * w[2];
  const auto z = v[0] * w[1] - v[1] * w[0];
  return std::array{x, y, z};
}
template <class T>
auto twice(const T& x) {
  return x + x;
}

/// Do all points share one of their coordinates?
template <class P>
bool share_a_coordinate(const Points<P>& p) {
  for (std::size_t k = 0; k < P::kDim; ++k) {
    bool shared = true;
    for (std::size_t i = 1; i < P::kPoints; ++i) shared &= (*p[i])[k] == (*p[0])[k];
    if (shared) return true;
  }
  return false;
}

/// Does every coordinate take at most two values? The points are then corners of one axis-parallel box.
template <class P>
bool are_box_corners(const Points<P>& p) {
  for (std::size_t k = 0; k < P::kDim; ++k) {
    const double low = (*p[0])[k];
    double other = low;
    for (std::size_t i = 1; i < P::kPoints; ++i) {
      const double x = (*p[i])[k];
      if (x == low || x == other) continue;
      if (other != low) return false;
      other = x;
    }
  }
  return true;
}

// ------------------------------------------------------------------------------------------------- orientation

/// Signed volume of the simplex of Dim+1 points.
template <int Dim>
struct Orientation;

template <>
struct Orientation<2> {
  static constexpr std::size_t kDim = 2, kPoints = 3;
  static constexpr int kDegree = 2;
  static constexpr double kErrorBound = (3 + 16 * kUnit) * kUnit;  // [S97]
  static constexpr std::array<Difference, 2> kVectors{{{0, 2}, {1, 2}}};

  template <class T>
  static auto value(const std::array<std::array<T, 2>, 2>& v) {
    return cross(v[0], v[1]);
  }
  static double majorant(const Point2& m) { return 2 * (m[0] * m[1]); }
  static bool is_zero(const Points<Orientation>& p) { return share_a_coordinate<Orientation>(p); }
};

template <>
struct Orientation<3> {
  static constexpr std::size_t kDim = 3, kPoints = 4;
  static constexpr int kDegree = 3;
  static constexpr double kErrorBound = (7 + 56 * kUnit) * kUnit;  // [S97]
  static constexpr std::array<Difference, 3> kVectors{{{0, 3}, {1, 3}, {2, 3}}};

  // Shewchuk's expression with every minor negated, which is exact: det[b-a; c-a; d-a] = -det[a-d; b-d; c-d].
  template <class T>
  static auto value(const std::array<std::array<T, 3>, 3>& v) {
    const auto& [a, b, c] = v;
    return a[2] * (c[0] * b[1] - b[0] * c[1]) + b[2] * (a[0] * c[1] - c[0] * a[1]) +
           c[2] * (b[0] * a[1] - a[0] * b[1]);
  }
  static double majorant(const Point3& m) { return 6 * (m[0] * m[1] * m[2]); }
  static bool is_zero(const Points<Orientation>& p) { return share_a_coordinate<Orientation>(p); }
};

// --------------------------------------------------------------------------------------------------- in-sphere

/// Positive if the last point lies inside the circumsphere of the first Dim+1, and these are positively
/// oriented.
template <int Dim>
struct InSphere;

template <>
struct InSphere<2> {
  static constexpr std::size_t kDim = 2, kPoints = 4;
  static constexpr int kDegree = 4;
  static constexpr double kErrorBound = (10 + 96 * kUnit) * kUnit;  // [S97]
  static constexpr std::array<Difference, 3> kVectors{{{0, 3}, {1, 3}, {2, 3}}};

  template <class T>
  static auto value(const std::array<std::array<T, 2>, 3>& v) {
    const auto& [a, b, c] = v;
    return dot(a, a) * cross(b, c) + dot(b, b) * cross(c, a) + dot(c, c) * cross(a, b);
  }
  static double majorant(const Point2& m) { return 6 * (m[0] * m[1]) * dot(m, m); }
  static bool is_zero(const Points<InSphere>& p) { return are_box_corners<InSphere>(p); }
};

template <>
struct InSphere<3> {
  static constexpr std::size_t kDim = 3, kPoints = 5;
  static constexpr int kDegree = 5;
  static constexpr double kErrorBound = (16 + 224 * kUnit) * kUnit;  // [S97]
  static constexpr std::array<Difference, 4> kVectors{{{0, 4}, {1, 4}, {2, 4}, {3, 4}}};

  // Shewchuk's expression, negated because his orientation is [PS, 0].
  template <class T>
  static auto value(const std::array<std::array<T, 3>, 4>& v) {
    const auto& [a, b, c, d] = v;
    const auto ab = a[0] * b[1] - b[0] * a[1];
    const auto bc = b[0] * c[1] - c[0] * b[1];
    const auto cd = c[0] * d[1] - d[0] * c[1];
    const auto da = d[0] * a[1] - a[0] * d[1];
    const auto ac = a[0] * c[1] - c[0] * a[1];
    const auto bd = b[0] * d[1] - d[0] * b[1];
    const auto abc = a[2] * bc - b[2] * ac + c[2] * ab;
    const auto bcd = b[2] * cd - c[2] * bd + d[2] * bc;
    const auto cda = c[2] * da + d[2] * ac + a[2] * cd;
    const auto dab = d[2] * ab + a[2] * bd + b[2] * da;
    return (dot(c, c) * dab - dot(d, d) * abc) + (dot(a, a) * bcd - dot(b, b) * cda);
  }
  // Four lifts, each times a 3x3 permanent of six products.
  static double majorant(const Point3& m) { return 24 * (m[0] * m[1] * m[2]) * dot(m, m); }
  static bool is_zero(const Points<InSphere>& p) { return are_box_corners<InSphere>(p); }
};

// -------------------------------------------------------------------------------------------- diametral sphere

/// Points: the Dim corners of a facet, then x. Negative if x lies inside the diametral sphere of the facet
/// [PS, 1].
template <int Dim>
struct Diametral;

template <>
struct Diametral<2> {
  static constexpr std::size_t kDim = 2, kPoints = 3;
  static constexpr int kDegree = 2;
  static constexpr double kErrorBound = 5 * kUnit;  // 3 roundings on the longest path, and the last
  static constexpr std::array<Difference, 2> kVectors{{{0, 2}, {1, 2}}};

  template <class T>
  static auto value(const std::array<std::array<T, 2>, 2>& v) {
    return dot(v[0], v[1]);
  }
  static double majorant(const Point2& m) { return dot(m, m); }
};

template <>
struct Diametral<3> {
  static constexpr std::size_t kDim = 3, kPoints = 4;
  static constexpr int kDegree = 6;
  // Roundings on the longest path: dot product 5, product of two 11, their difference 12, times the third 18,
  // first addition 19; the last does not change the sign. The rest of the 24 covers the rounding of the
  // permanent.
  static constexpr double kErrorBound = 24 * kUnit;
  static constexpr std::array<Difference, 3> kVectors{{{1, 0}, {2, 0}, {3, 0}}};

  // The Gram form of G: fewer operations than with cross products, and narrower integers.
  template <class T>
  static auto value(const std::array<std::array<T, 3>, 3>& vectors) {
    const auto& [u, v, w] = vectors;
    const auto uu = dot(u, u), uv = dot(u, v), uw = dot(u, w);
    const auto vv = dot(v, v), vw = dot(v, w), ww = dot(w, w);
    return ww * (uu * vv - uv * uv) + uu * (uv * vw - uw * vv) + vv * (uv * uw - uu * vw);
  }
  // Six products of three dot products.
  static double majorant(const Point3& m) {
    const double s = dot(m, m);
    return 6 * (s * s * s);
  }
};

/// Scalar product of the inner normals of two facets of a simplex, N_i . N_x [PS, 2]: the coefficients of the
/// perturbed Diametral. Points: corner i of the facet, the other corners of the facet, apex x.
template <int Dim>
struct FacetNormals;

template <>
struct FacetNormals<2> {
  static constexpr std::size_t kDim = 2, kPoints = 3;
  static constexpr int kDegree = 2;
  static constexpr double kErrorBound = 5 * kUnit;  // as Diametral<2>
  static constexpr std::array<Difference, 2> kVectors{{{0, 1}, {1, 2}}};

  template <class T>
  static auto value(const std::array<std::array<T, 2>, 2>& v) {
    return dot(v[0], v[1]);
  }
  static double majorant(const Point2& m) { return dot(m, m); }
};

template <>
struct FacetNormals<3> {
  static constexpr std::size_t kDim = 3, kPoints = 4;
  static constexpr int kDegree = 4;
  static constexpr double kErrorBound = 16 * kUnit;  // product of two dot products: 11 roundings, and the last
  static constexpr std::array<Difference, 3> kVectors{{{0, 1}, {2, 1}, {3, 1}}};

  // (u x v).(v x w) by the identity of Binet and Cauchy. Exchanging corners flips both normals or none.
  template <class T>
  static auto value(const std::array<std::array<T, 3>, 3>& vectors) {
    const auto& [u, v, w] = vectors;
    return dot(u, v) * dot(v, w) - dot(u, w) * dot(v, v);
  }
  static double majorant(const Point3& m) {
    const double s = dot(m, m);
    return 2 * (s * s);
  }
};

// ----------------------------------------------------------------------------------------------- orthogonality

/// The circumcenter of a simplex is its first corner plus y / (2 d): y the vector Y of [PS, 0], d the signed
/// volume.
template <class D, class Y, std::size_t Dim>
struct CircumcenterQuotient {
  D d;
  std::array<Y, Dim> y;
};

/// From the vectors from the first corner to the others.
template <class T>
auto circumcenter_quotient(const std::array<T, 2>& u, const std::array<T, 2>& v) {
  const auto uu = dot(u, u), vv = dot(v, v);
  const auto x = uu * v[1] - vv * u[1];
  const auto y = vv * u[0] - uu * v[0];
  const auto d = cross(u, v);
  return CircumcenterQuotient<std::decay_t<decltype(d)>, std::decay_t<decltype(x)>, 2>{d, {x, y}};
}
template <class T>
auto circumcenter_quotient(const std::array<T, 3>& u, const std::array<T, 3>& v, const std::array<T, 3>& w) {
  const auto uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
  const auto vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const auto x = uu * vw[0] + vv * wu[0] + ww * uv[0];
  const auto y = uu * vw[1] + vv * wu[1] + ww * uv[1];
  const auto z = uu * vw[2] + vv * wu[2] + ww * uv[2];
  const auto d = dot(w, uv);
  return CircumcenterQuotient<std::decay_t<decltype(d)>, std::decay_t<decltype(x)>, 3>{d, {x, y, z}};
}

/// Points: the corners of two simplices. The polynomial of [PS, 6]: the value of the predicate times the
/// product of the two signed volumes.
template <int Dim>
struct Orthogonality;

template <>
struct Orthogonality<2> {
  static constexpr std::size_t kDim = 2, kPoints = 6;
  static constexpr int kDegree = 6;
  static constexpr double kErrorBound = 32 * kUnit;  // at most 19 roundings before the last
  static constexpr std::array<Difference, 5> kVectors{{{1, 0}, {2, 0}, {4, 3}, {5, 3}, {0, 3}}};

  template <class T>
  static auto value(const std::array<std::array<T, 2>, 5>& v) {
    const auto s = circumcenter_quotient(v[0], v[1]);
    const auto t = circumcenter_quotient(v[2], v[3]);
    const auto& e = v[4];
    return twice(s.d * t.d * dot(e, e) + t.d * dot(e, s.y) - s.d * dot(e, t.y)) - dot(s.y, t.y);
  }
  // D <= 2 X Y, |Y| <= 2 S (Y, X), with S = X^2 + Y^2: 2 (4 V^2 S + 2 * 8 V^2 S) + 4 S^3, with V = X Y.
  static double majorant(const Point2& m) {
    const double v = m[0] * m[1], s = dot(m, m);
    return 40 * (v * v) * s + 4 * (s * s * s);
  }
};

template <>
struct Orthogonality<3> {
  static constexpr std::size_t kDim = 3, kPoints = 8;
  static constexpr int kDegree = 8;
  // Roundings on the longest path: D 8, component of Y 12, e.Y 16, times D 25, Y.Y 27; before the last: 27.
  static constexpr double kErrorBound = 32 * kUnit;
  static constexpr std::array<Difference, 7> kVectors{{{1, 0}, {2, 0}, {3, 0}, {5, 4}, {6, 4}, {7, 4}, {0, 4}}};

  template <class T>
  static auto value(const std::array<std::array<T, 3>, 7>& v) {
    const auto s = circumcenter_quotient(v[0], v[1], v[2]);
    const auto t = circumcenter_quotient(v[3], v[4], v[5]);
    const auto& e = v[6];
    return twice(s.d * t.d * dot(e, e) + t.d * dot(e, s.y) - s.d * dot(e, t.y)) - dot(s.y, t.y);
  }
  // D <= 6 V, Y_x <= 6 S Y Z, e.Y <= 18 S V, with V = X Y Z and S = X^2 + Y^2 + Z^2.
  static double majorant(const Point3& m) {
    const double v = m[0] * m[1] * m[2], s = dot(m, m);
    const Point3 minors{m[1] * m[2], m[2] * m[0], m[0] * m[1]};
    return 504 * (v * v) * s + 36 * (s * s) * dot(minors, minors);
  }
};

}  // namespace sinkmesh::detail
