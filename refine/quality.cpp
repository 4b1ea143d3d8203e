// SPDX-License-Identifier: MIT
#include "refine/quality.h"

#include <algorithm>
#include <cmath>

#include "core/vector.h"
#include "predicates/constructions.h"
#include "refine/corner_order.h"

namespace sinkmesh {
namespace {

template <std::size_t N, class P>
double shortest_edge2(const std::array<const P*, N>& corners) {
  double shortest = HUGE_VAL;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < i; ++j)
      shortest = std::min(shortest, squared_distance(*corners[i], *corners[j]));
  }
  return shortest;
}

// Square of the volume (in the plane: area) over a product of lengths, above which rounding can be neglected.
// The determinant D is wrong by less than 2^-49 |u||v||w|, a 2^-13th of itself then, and Y by less than three
// times that times the longest of u, v, w, a 2^-11th of itself, because |Y| = 2 |D| r and r is at least half of
// each length.
constexpr double kCertain2 = 0x1p-72;

double triangle_radius2(double uu, double vv, double side_opposite2, double area2) {
  // r = (product of the sides) / (4 area), area2 = |u x v|^2 = 4 area^2.
  const double r2 = uu * vv * side_opposite2 / (4 * area2);
  return std::isnan(r2) ? HUGE_VAL : r2;
}

}  // namespace

template <>
Shape shape<3>(Corners<3> corners) {
  sort_corners(corners);
  const Point3& a = *corners[0];
  const Point3 u = *corners[1] - a;
  const Point3 v = *corners[2] - a;
  const Point3 w = *corners[3] - a;
  const Point3 nb = cross(v, w);
  const Point3 nc = cross(w, u);
  const Point3 nd = cross(u, v);
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  const double ww = dot(w, w);
  const double d = dot(u, nb);
  if (!(d * d > kCertain2 * uu * vv * ww)) return {circumradius2<3>(corners), shortest_edge2(corners)};
  // The circumcenter is a + Y/(2D) [PS, 0].
  Point3 y;
  for (std::size_t k = 0; k < 3; ++k) y[k] = uu * nb[k] + vv * nc[k] + ww * nd[k];
  return {dot(y, y) / (4 * d * d), shortest_edge2(corners)};
}

template <>
Shape shape<2>(Corners<2> corners) {
  sort_corners(corners);
  const Point2 u = *corners[1] - *corners[0];
  const Point2 v = *corners[2] - *corners[0];
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  const double area = cross(u, v);
  if (!(area * area > kCertain2 * uu * vv)) return {circumradius2<2>(corners), shortest_edge2(corners)};
  return {triangle_radius2(uu, vv, squared_distance(*corners[1], *corners[2]), area * area),
          shortest_edge2(corners)};
}

template <>
Shape facet_shape<3>(FacetCorners<3> corners) {
  sort_corners(corners);
  const Point3 u = *corners[1] - *corners[0];
  const Point3 v = *corners[2] - *corners[0];
  const Point3 normal = cross(u, v);
  return {
      triangle_radius2(dot(u, u), dot(v, v), squared_distance(*corners[1], *corners[2]), dot(normal, normal)),
      shortest_edge2(corners)};
}

template <>
Shape facet_shape<2>(FacetCorners<2> corners) {
  const double length2 = squared_distance(*corners[0], *corners[1]);
  return {length2 / 4, length2};
}

template <>
double facet_area2<2>(FacetCorners<2> corners) {
  return squared_distance(*corners[0], *corners[1]);
}

template <>
double facet_area2<3>(FacetCorners<3> corners) {
  sort_corners(corners);
  const Point3 n = cross(*corners[1] - *corners[0], *corners[2] - *corners[0]);
  return dot(n, n);
}

template <>
Point2 facet_center<2>(FacetCorners<2> corners) {
  return {((*corners[0])[0] + (*corners[1])[0]) / 2, ((*corners[0])[1] + (*corners[1])[1]) / 2};
}

template <>
Point3 facet_center<3>(FacetCorners<3> corners) {
  sort_corners(corners);
  const Point3 u = *corners[1] - *corners[0];
  const Point3 v = *corners[2] - *corners[0];
  const Point3 n = cross(u, v);
  const Point3 p = cross(n, u);
  const Point3 q = cross(v, n);
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  Point3 center = *corners[0];
  for (std::size_t k = 0; k < 3; ++k) center[k] += (vv * p[k] + uu * q[k]) / (2 * dot(n, n));
  return center;
}

namespace {

template <std::size_t N, class P>
double longest_edge(const std::array<const P*, N>& corners) {
  double longest2 = 0;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < i; ++j)
      longest2 = std::max(longest2, squared_distance(*corners[i], *corners[j]));
  }
  return std::sqrt(longest2);
}

}  // namespace

template <>
double flatness<2>(const Corners<2>& corners) {
  const double longest = longest_edge(corners);
  const Point2& a = *corners[0];
  return std::abs(cross(*corners[1] - a, *corners[2] - a)) / (2 * longest * longest);
}

template <>
double flatness<3>(const Corners<3>& corners) {
  const double longest = longest_edge(corners);
  const Point3& a = *corners[0];
  const double six_volumes = std::abs(dot(*corners[1] - a, cross(*corners[2] - a, *corners[3] - a)));
  return six_volumes / (6 * longest * longest * longest);
}

template <int Dim>
void QualityStatistics::add(const Corners<Dim>& corners) {
  const double ratio2 = shape<Dim>(corners).ratio2();
  const double ratio = std::sqrt(ratio2);
  ++count_;
  low_ += ratio2 <= max_ratio2_ ? 0 : 1;
  min2_ = std::min(min2_, ratio2);
  max2_ = std::max(max2_, ratio2);
  sum_ += ratio;
  for (const double c : cotangents2<Dim>(corners)) cotangents_.include(c);
  std::size_t bin = 0;
  while (bin + 1 < kBins.size() && ratio > kBins[bin]) ++bin;
  ++histogram_[bin];
}

double QualityStatistics::min_ratio() const { return count_ == 0 ? 0 : std::sqrt(min2_); }
double QualityStatistics::max_ratio() const { return std::sqrt(max2_); }
double QualityStatistics::average_ratio() const { return count_ == 0 ? 0 : sum_ / static_cast<double>(count_); }

template void QualityStatistics::add<2>(const Corners<2>&);
template void QualityStatistics::add<3>(const Corners<3>&);

}  // namespace sinkmesh
