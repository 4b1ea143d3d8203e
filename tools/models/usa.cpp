// SPDX-License-Identifier: MIT
//
// The outline of the contiguous United States.
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "tools/models/models.h"
#include "tools/models/outline_simplifier.h"

namespace sinkmesh::models {
namespace {

constexpr std::int32_t kOutlineSteps[][2] = {
#include "tools/models/usa_outline.inc"
};
// Of the grid, in degrees.
constexpr std::array<double, 2> kGridStep = {0.003589293992939929, 0.0008590596905969058};
constexpr std::array<double, 2> kGridOrigin = {-179.14733999999999, -14.552548999999999};

// Albers' equal-area conic projection of the sphere, the usual one for this country: standard parallels 29.5
// and
// 45.5, origin 37.5 north and 96 west. Units of 1000 km.
Point2 project(double longitude, double latitude) {
  constexpr double kEarthRadius = 6.371007;
  constexpr double kDegree = std::numbers::pi / 180;
  const double south = std::sin(29.5 * kDegree);
  const double cosine = std::cos(29.5 * kDegree);
  const double n = (south + std::sin(45.5 * kDegree)) / 2;
  const double c = cosine * cosine + 2 * n * south;
  const auto radius = [&](double phi) { return std::sqrt(c - 2 * n * std::sin(phi)) / n; };
  const double theta = n * (longitude * kDegree - -96 * kDegree);
  const double r = radius(latitude * kDegree);
  return {kEarthRadius * r * std::sin(theta), kEarthRadius * (radius(37.5 * kDegree) - r * std::cos(theta))};
}

std::vector<Point2> make_outline() {
  std::vector<Point2> outline;
  std::array<std::int32_t, 2> place{};
  for (const auto& step : kOutlineSteps) {
    for (std::size_t k = 0; k < 2; ++k) place[k] += step[k];
    outline.push_back(
        project(place[0] * kGridStep[0] + kGridOrigin[0], place[1] * kGridStep[1] + kGridOrigin[1]));
  }
  return outline;
}

}  // namespace

Surface2 make_usa(std::size_t triangles) {
  Surface2 surface;
  surface.points = simplify_outline(make_outline(), triangles + 2);
  const auto n = static_cast<std::uint32_t>(surface.points.size());
  for (std::uint32_t i = 0; i < n; ++i) surface.facets.push_back({i, (i + 1) % n});
  return surface;
}

}  // namespace sinkmesh::models
