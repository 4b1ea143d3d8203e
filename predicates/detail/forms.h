// SPDX-License-Identifier: MIT
//
// The polynomials behind the predicates, each written once, over differences of coordinates of any number type:
// doubles for the filters, magnitudes for the error bounds, wide integers and expansions for the exact stages.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "predicates/point.h"

namespace sinkmesh::detail {

/// The unit roundoff of binary64.
inline constexpr double kUnit = 0x1p-53;

/// A nonnegative double whose difference is a sum: a polynomial evaluated over magnitudes is its permanent [PS,
/// 0].
struct Magnitude {
  double value;
  friend Magnitude operator+(Magnitude a, Magnitude b) { return {a.value + b.value}; }
  friend Magnitude operator-(Magnitude a, Magnitude b) { return {a.value + b.value}; }
  friend Magnitude operator*(Magnitude a, Magnitude b) { return {a.value * b.value}; }
};

template <class T, int Dim>
using Vec = std::array<T, Dim>;

template <class T>
auto minor2(const T& ax, const T& ay, const T& bx, const T& by) {
  return ax * by - bx * ay;
}
template <class T>
auto dot(const Vec<T, 2>& a, const Vec<T, 2>& b) {
  return a[0] * b[0] + a[1] * b[1];
}
template <class T>
auto dot(const Vec<T, 3>& a, const Vec<T, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
auto cross(const Vec<T, 3>& a, const Vec<T, 3>& b) {
  using Minor = decltype(minor2(a[0], a[1], b[0], b[1]));
  return Vec<Minor, 3>{minor2(a[1], a[2], b[1], b[2]), minor2(a[2], a[0], b[2], b[0]),
                       minor2(a[0], a[1], b[0], b[1])};
}
/// The dot product of vectors whose components are of different widths.
template <class T, class U>
auto mixed(const Vec<T, 2>& a, const Vec<U, 2>& b) {
  return a[0] * b[0] + a[1] * b[1];
}
template <class T, class U>
auto mixed(const Vec<T, 3>& a, const Vec<U, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Each form has
//   kDim, kPoints   the points it takes
//   kPairs          the differences it is written in: point `first` minus point `second`
//   kDegree
//   kError          its rounded value is within kError times its rounded permanent of the exact one [PS, 0]
//   value()         the polynomial
//   permanent_over() an upper bound of the permanent when all differences are within the extents of a box; it
//   counts
//                   the terms of the permanent, and its callers allow for the rounding on both sides
//   is_zero()       a certificate of zero from coordinates alone, or always false

struct Difference {
  std::size_t first;
  std::size_t second;
};

/// Whether a coordinate is the same for all points.
template <class Points>
bool share_coordinate(const Points& p, std::size_t k) {
  for (std::size_t i = 1; i < p.size(); ++i) {
    if ((*p[i])[k] != (*p[0])[k]) return false;
  }
  return true;
}

/// Whether all points are corners of one axis-parallel box: each coordinate takes at most two values x0, x1.
/// Then x^2 = (x0+x1) x - x0 x1, so the lift is an affine function of the coordinates, and points are
/// cospherical.
template <class Points>
bool are_box_corners(const Points& p) {
  for (std::size_t k = 0; k < p[0]->size(); ++k) {
    const double first = (*p[0])[k];
    double other = first;
    for (std::size_t i = 1; i < p.size(); ++i) {
      const double x = (*p[i])[k];
      if (x == first || x == other) continue;
      if (other != first) return false;
      other = x;
    }
  }
  return true;
}

struct Orient2d {
  static constexpr int kDim = 2;
  static constexpr int kDegree = 2;
  static constexpr double kError = (3 + 16 * kUnit) * kUnit;  // [S97]
  static constexpr std::array<Difference, 2> kPairs{{{0, 2}, {1, 2}}};
  using Points = std::array<const Point2*, 3>;

  template <class T>
  static auto value(const std::array<Vec<T, 2>, 2>& d) {
    return minor2(d[0][0], d[0][1], d[1][0], d[1][1]);
  }
  static double permanent_over(const Vec<double, 2>& e) { return 2 * (e[0] * e[1]); }
  static bool is_zero(const Points& p) { return share_coordinate(p, 0) || share_coordinate(p, 1); }
};

struct Orient3d {
  static constexpr int kDim = 3;
  static constexpr int kDegree = 3;
  static constexpr double kError = (7 + 56 * kUnit) * kUnit;  // [S97]
  static constexpr std::array<Difference, 3> kPairs{{{0, 3}, {1, 3}, {2, 3}}};
  using Points = std::array<const Point3*, 4>;

  // det[a-d; b-d; c-d] is minus the volume of (a,b,c,d): the rows b, a, c turn the sign.
  template <class T>
  static auto value(const std::array<Vec<T, 3>, 3>& d) {
    const auto& [a, b, c] = d;
    return a[2] * minor2(c[0], c[1], b[0], b[1]) + b[2] * minor2(a[0], a[1], c[0], c[1]) +
           c[2] * minor2(b[0], b[1], a[0], a[1]);
  }
  static double permanent_over(const Vec<double, 3>& e) { return 6 * (e[0] * e[1] * e[2]); }
  static bool is_zero(const Points& p) {
    return share_coordinate(p, 0) || share_coordinate(p, 1) || share_coordinate(p, 2);
  }
};

struct Incircle {
  static constexpr int kDim = 2;
  static constexpr int kDegree = 4;
  static constexpr double kError = (10 + 96 * kUnit) * kUnit;  // [S97]
  static constexpr std::array<Difference, 3> kPairs{{{0, 3}, {1, 3}, {2, 3}}};
  using Points = std::array<const Point2*, 4>;

  template <class T>
  static auto value(const std::array<Vec<T, 2>, 3>& d) {
    const auto& [a, b, c] = d;
    return dot(a, a) * minor2(b[0], b[1], c[0], c[1]) + dot(b, b) * minor2(c[0], c[1], a[0], a[1]) +
           dot(c, c) * minor2(a[0], a[1], b[0], b[1]);
  }
  static double permanent_over(const Vec<double, 2>& e) {
    return 6 * (e[0] * e[1]) * (e[0] * e[0] + e[1] * e[1]);
  }
  static bool is_zero(const Points& p) { return are_box_corners(p); }
};

struct Insphere {
  static constexpr int kDim = 3;
  static constexpr int kDegree = 5;
  static constexpr double kError = (16 + 224 * kUnit) * kUnit;  // [S97]
  static constexpr std::array<Difference, 4> kPairs{{{0, 4}, {1, 4}, {2, 4}, {3, 4}}};
  using Points = std::array<const Point3*, 5>;

  // conf = -det of the rows (p, |p|^2) [PS, 0], by the four 3x3 minors of the coordinates.
  template <class T>
  static auto value(const std::array<Vec<T, 3>, 4>& r) {
    const auto& [a, b, c, d] = r;
    const auto ab = minor2(a[0], a[1], b[0], b[1]);
    const auto bc = minor2(b[0], b[1], c[0], c[1]);
    const auto cd = minor2(c[0], c[1], d[0], d[1]);
    const auto da = minor2(d[0], d[1], a[0], a[1]);
    const auto ac = minor2(a[0], a[1], c[0], c[1]);
    const auto bd = minor2(b[0], b[1], d[0], d[1]);
    const auto abc = a[2] * bc - b[2] * ac + c[2] * ab;
    const auto bcd = b[2] * cd - c[2] * bd + d[2] * bc;
    const auto cda = c[2] * da + d[2] * ac + a[2] * cd;
    const auto dab = d[2] * ab + a[2] * bd + b[2] * da;
    return (dot(c, c) * dab - dot(d, d) * abc) + (dot(a, a) * bcd - dot(b, b) * cda);
  }
  static double permanent_over(const Vec<double, 3>& e) {
    return 24 * (e[0] * e[1] * e[2]) * (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
  }
  static bool is_zero(const Points& p) { return are_box_corners(p); }
};

/// Points: the two ends of the edge, then x. Sign of (a-x).(b-x).
struct DiametralCircle {
  static constexpr int kDim = 2;
  static constexpr int kDegree = 2;
  static constexpr double kError = 5 * kUnit;
  static constexpr std::array<Difference, 2> kPairs{{{0, 2}, {1, 2}}};
  using Points = std::array<const Point2*, 3>;

  template <class T>
  static auto value(const std::array<Vec<T, 2>, 2>& d) {
    return dot(d[0], d[1]);
  }
  static double permanent_over(const Vec<double, 2>& e) { return e[0] * e[0] + e[1] * e[1]; }
  static bool is_zero(const Points&) { return false; }
};

/// Points: the three corners of the facet, then x. The polynomial G in its Gram form [PS, 1].
struct DiametralSphere {
  static constexpr int kDim = 3;
  static constexpr int kDegree = 6;
  static constexpr double kError = 24 * kUnit;
  static constexpr std::array<Difference, 3> kPairs{{{1, 0}, {2, 0}, {3, 0}}};
  using Points = std::array<const Point3*, 4>;

  template <class T>
  static auto value(const std::array<Vec<T, 3>, 3>& d) {
    const auto& [u, v, w] = d;
    const auto uu = dot(u, u);
    const auto vv = dot(v, v);
    const auto ww = dot(w, w);
    const auto uv = dot(u, v);
    const auto uw = dot(u, w);
    const auto vw = dot(v, w);
    return ww * (uu * vv - uv * uv) + (uu * (uv * vw - uw * vv) + vv * (uv * uw - uu * vw));
  }
  // Every dot product is at most s = |e|^2, and there are six products of three.
  static double permanent_over(const Vec<double, 3>& e) {
    const double s = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
    return 6 * (s * s * s);
  }
  static bool is_zero(const Points&) { return false; }
};

/// Points: the corners a, b, c of a facet, then the apex d. The product N_d . N_b of the normals of the facets
/// opposite d and b [PS, 2], as (u.v)(v.w) - (u.w)(v.v) with u, v, w from a to b, c, d. Each dot product of
/// differences carries at most five rounding factors, so a product of two, subtracted, at most twelve.
struct FacetNormals {
  static constexpr int kDim = 3;
  static constexpr int kDegree = 4;
  static constexpr double kError = 16 * kUnit;
  static constexpr std::array<Difference, 3> kPairs{{{1, 0}, {2, 0}, {3, 0}}};
  using Points = std::array<const Point3*, 4>;

  template <class T>
  static auto value(const std::array<Vec<T, 3>, 3>& d) {
    const auto& [u, v, w] = d;
    return dot(u, v) * dot(v, w) - dot(u, w) * dot(v, v);
  }
  static bool is_zero(const Points&) { return false; }
};

/// The center of a simplex is a + Y/(2D) [PS, 0]: D and Y from the differences to its first corner a.
template <class T>
auto center_terms(const Vec<T, 2>& u, const Vec<T, 2>& v) {
  const auto uu = dot(u, u);
  const auto vv = dot(v, v);
  using Term = decltype(uu * v[1] - vv * u[1]);
  struct {
    decltype(minor2(u[0], u[1], v[0], v[1])) d;
    Vec<Term, 2> y;
  } result{minor2(u[0], u[1], v[0], v[1]), {uu * v[1] - vv * u[1], vv * u[0] - uu * v[0]}};
  return result;
}
template <class T>
auto center_terms(const Vec<T, 3>& u, const Vec<T, 3>& v, const Vec<T, 3>& w) {
  const auto nb = cross(v, w);
  const auto nc = cross(w, u);
  const auto nd = cross(u, v);
  const auto uu = dot(u, u);
  const auto vv = dot(v, v);
  const auto ww = dot(w, w);
  const auto term = [&](std::size_t k) { return uu * nb[k] + vv * nc[k] + ww * nd[k]; };
  struct {
    decltype(mixed(u, nb)) d;
    Vec<decltype(term(0)), 3> y;
  } result{mixed(u, nb), {term(0), term(1), term(2)}};
  return result;
}

/// Points: the corners of one simplex, then of the other. Sign of 2 D1 D2 (|z1-z2|^2 - r1^2 - r2^2) [PS, 6];
/// the callers divide by the signs of D1 and D2.
template <int Dim>
struct Orthogonality;

template <>
struct Orthogonality<2> {
  static constexpr int kDim = 2;
  static constexpr int kDegree = 6;
  static constexpr double kError = 32 * kUnit;
  static constexpr std::array<Difference, 5> kPairs{{{1, 0}, {2, 0}, {4, 3}, {5, 3}, {0, 3}}};
  using Points = std::array<const Point2*, 6>;

  template <class T>
  static auto value(const std::array<Vec<T, 2>, 5>& d) {
    const auto s = center_terms(d[0], d[1]);
    const auto t = center_terms(d[2], d[3]);
    const auto& e = d[4];
    const auto d2e = s.d * t.d * dot(e, e);
    const auto across = t.d * mixed(e, s.y) - s.d * mixed(e, t.y);
    return d2e + d2e + across + across - dot(s.y, t.y);
  }
  static bool is_zero(const Points&) { return false; }
};

template <>
struct Orthogonality<3> {
  static constexpr int kDim = 3;
  static constexpr int kDegree = 8;
  static constexpr double kError = 32 * kUnit;
  static constexpr std::array<Difference, 7> kPairs{{{1, 0}, {2, 0}, {3, 0}, {5, 4}, {6, 4}, {7, 4}, {0, 4}}};
  using Points = std::array<const Point3*, 8>;

  template <class T>
  static auto value(const std::array<Vec<T, 3>, 7>& d) {
    const auto s = center_terms(d[0], d[1], d[2]);
    const auto t = center_terms(d[3], d[4], d[5]);
    const auto& e = d[6];
    const auto d2e = s.d * t.d * dot(e, e);
    const auto across = t.d * mixed(e, s.y) - s.d * mixed(e, t.y);
    return d2e + d2e + across + across - dot(s.y, t.y);
  }
  static bool is_zero(const Points&) { return false; }
};

}  // namespace sinkmesh::detail
