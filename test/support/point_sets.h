// SPDX-License-Identifier: MIT
//
// Whole point sets to triangulate: random, degenerate and adversarial, spanning the whole space, distinct.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "test/support/clouds.h"

namespace sinkmesh::test {

/// One degree in radians.
inline constexpr double kDegree = 0x1.1df46a2529d39p-6;

/// The corners of a simplex, as the library takes them.
template <int Dim>
Corners<Dim> pointers(const std::array<Point<Dim>, Dim + 1>& points) {
  Corners<Dim> corners;
  for (std::size_t i = 0; i <= Dim; ++i) corners[i] = &points[i];
  return corners;
}

template <int Dim>
struct PointSet {
  std::string name;
  std::vector<Point<Dim>> points;
};

template <int Dim>
std::vector<Point<Dim>> uniform_points(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point<Dim>> points(n);
  for (auto& p : points) {
    for (double& x : p) x = uniform(random, 0, 1);
  }
  return points;
}

/// {0, ..., n-1}^Dim.
template <int Dim>
std::vector<Point<Dim>> grid_points(int n, double step = 1) {
  std::vector<Point<Dim>> points(1, Point<Dim>{});
  for (std::size_t k = 0; k < Dim; ++k) {
    std::vector<Point<Dim>> next;
    for (Point<Dim> p : points) {
      for (int i = 0; i < n; ++i) {
        p[k] = step * i;
        next.push_back(p);
      }
    }
    points = next;
  }
  return points;
}

/// All integer points on one sphere around the origin: in space of radius 9, in the plane of radius 65.
template <int Dim>
std::vector<Point<Dim>> sphere_points() {
  constexpr int kRadius = Dim == 2 ? 65 : 9;
  std::vector<Point<Dim>> points;
  for (Point<Dim> p : grid_points<Dim>(2 * kRadius + 1)) {
    double square = 0;
    for (double& x : p) {
      x -= kRadius;
      square += x * x;
    }
    if (square == kRadius * kRadius) points.push_back(p);
  }
  return points;
}

/// One set of about n points for every kind of cloud, fewer where the kind has fewer positions. Flat ones get
/// two points off their hyperplane, one on each side.
template <int Dim>
std::vector<PointSet<Dim>> point_sets(std::size_t n, std::uint64_t seed) {
  static constexpr std::array<const char*, kAllClouds.size()> kNames = {
      "uniform",     "integer grid",    "tenth lattice", "box corners", "rounded sphere",
      "flat",        "integer sphere",  "scaled sphere", "neighbours",  "flat integer",
      "flat scaled", "flat neighbours", "large offset",  "two scales"};
  std::vector<PointSet<Dim>> sets;
  Random random(seed);
  for (std::size_t kind = 0; kind < kAllClouds.size(); ++kind) {
    std::vector<Point<Dim>> points = candidate_cloud<Dim>(kAllClouds[kind], n, random);
    if (std::string(kNames[kind]).starts_with("flat")) {
      double extent = 0;
      for (const auto& p : points) {
        for (const double x : p) extent = std::max(extent, std::abs(x));
      }
      for (const double factor : {1.0, -0.5}) {
        points.push_back(points[factor > 0 ? 0 : 1]);
        points.back()[Dim - 1] += factor * extent;
      }
    }
    std::set<Point<Dim>> met;
    std::erase_if(points, [&](const Point<Dim>& p) { return !met.insert(p).second; });
    sets.push_back({kNames[kind], points});
  }
  return sets;
}

}  // namespace sinkmesh::test
