// SPDX-License-Identifier: MIT
#include "refine/angles.h"

#include <numbers>

#include "core/vector.h"

namespace sinkmesh {
namespace {

double signed_square(double cosine, double sine2) {
  const double square = cosine * std::abs(cosine) / sine2;
  return std::isnan(square) ? HUGE_VAL : square;  // no area that doubles can see: no angle
}

double degrees_of(double cotangent2) {
  const double cotangent = std::copysign(std::sqrt(std::abs(cotangent2)), cotangent2);
  return std::atan2(1.0, cotangent) * (180 / std::numbers::pi);
}

}  // namespace

// The facets opposite i and j have normals N_i, N_j with N_i x N_j = D times the edge that they share, up to
// sign: the sine comes without cancellation.
template <>
std::array<double, 6> cotangents2<3>(const Corners<3>& corners) {
  const Point3 u = *corners[1] - *corners[0];
  const Point3 v = *corners[2] - *corners[0];
  const Point3 w = *corners[3] - *corners[0];
  std::array<Point3, 4> normal = {Point3{}, cross(v, w), cross(w, u), cross(u, v)};
  normal[0] = cross(*corners[3] - *corners[1], *corners[2] - *corners[1]);
  const double d = dot(u, normal[1]);
  std::array<double, 6> result;
  std::size_t n = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      std::size_t k = 0;
      while (k == i || k == j) ++k;
      const std::size_t l = 6 - i - j - k;
      result[n++] =
          signed_square(-dot(normal[i], normal[j]), d * d * squared_distance(*corners[k], *corners[l]));
    }
  }
  return result;
}

template <>
std::array<double, 3> cotangents2<2>(const Corners<2>& corners) {
  const Point2 u = *corners[1] - *corners[0];
  const Point2 v = *corners[2] - *corners[0];
  const Point2 w = v - u;
  const double area = cross(u, v);
  return {signed_square(dot(u, v), area * area), signed_square(-dot(u, w), area * area),
          signed_square(dot(v, w), area * area)};
}

double Cotangents::smallest_angle() const { return degrees_of(largest); }
double Cotangents::largest_angle() const { return degrees_of(smallest); }

double cotangent2(double degrees) {
  const double cotangent = 1 / std::tan(degrees * (std::numbers::pi / 180));
  return cotangent * std::abs(cotangent);
}

template <int Dim>
Angles angles(const Corners<Dim>& corners) {
  Cotangents cotangents;
  for (const double c : cotangents2<Dim>(corners)) cotangents.include(c);
  return {cotangents.smallest_angle(), cotangents.largest_angle()};
}

template Angles angles<2>(const Corners<2>&);
template Angles angles<3>(const Corners<3>&);

AngleCensus::AngleCensus() {
  for (std::size_t i = 0; i < ends_.size(); ++i) ends_[i] = cotangent2(kBinWidth * static_cast<double>(i + 1));
  for (std::size_t i = 0; i < small_.size(); ++i) small_[i] = cotangent2(kSmall[i]);
}

template <int Dim>
void AngleCensus::add(const Corners<Dim>& corners, bool is_inner) {
  double largest = -HUGE_VAL;
  for (const double c : cotangents2<Dim>(corners)) {
    largest = std::max(largest, c);
    // The number of ends that are not above the angle: bins hold their lower ends. Counted, not searched for:
    // which way a search turns is a coin toss.
    std::size_t bin = 0;
    for (const double end : ends_) bin += end >= c ? 1 : 0;
    ++histogram_[bin];
  }
  for (std::size_t i = 0; i < small_.size(); ++i) {
    const std::size_t is_below = largest > small_[i] ? 1 : 0;
    below_[i] += is_below;
    inner_below_[i] += is_inner ? is_below : 0;
  }
}

template void AngleCensus::add<2>(const Corners<2>&, bool);
template void AngleCensus::add<3>(const Corners<3>&, bool);

}  // namespace sinkmesh
