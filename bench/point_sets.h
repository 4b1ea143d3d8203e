// SPDX-License-Identifier: MIT
//
// Point sets for benchmarks, with fixed seeds.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "predicates/point.h"

namespace sinkmesh::bench {

/// Uniform in [0,1); the same on every platform, unlike std::uniform_real_distribution.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : random_(seed) {}
  double operator()() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  std::mt19937_64& generator() { return random_; }

 private:
  std::mt19937_64 random_;
};

inline std::vector<Point3> uniform_cube(std::size_t n) {
  Uniform uniform(1);
  std::vector<Point3> points(n);
  for (Point3& p : points) p = {uniform(), uniform(), uniform()};
  return points;
}

/// On the unit sphere up to rounding.
inline std::vector<Point3> rounded_sphere(std::size_t n) {
  Uniform uniform(2);
  std::vector<Point3> points(n);
  for (Point3& p : points) {
    const double z = 2 * uniform() - 1;
    const double angle = 2 * std::numbers::pi * uniform();
    const double r = std::sqrt(1 - z * z);
    p = {r * std::cos(angle), r * std::sin(angle), z};
  }
  return points;
}

/// z = x^2 + y^2 over the unit disc.
inline std::vector<Point3> paraboloid(std::size_t n) {
  Uniform uniform(3);
  std::vector<Point3> points(n);
  for (Point3& p : points) {
    const double r = std::sqrt(uniform());
    const double angle = 2 * std::numbers::pi * uniform();
    const double x = r * std::cos(angle);
    const double y = r * std::sin(angle);
    p = {x, y, x * x + y * y};
  }
  return points;
}

/// The side of a cylinder of radius 1 and height 2.
inline std::vector<Point3> open_cylinder(std::size_t n) {
  Uniform uniform(4);
  std::vector<Point3> points(n);
  for (Point3& p : points) {
    const double angle = 2 * std::numbers::pi * uniform();
    p = {std::cos(angle), std::sin(angle), 2 * uniform()};
  }
  return points;
}

inline std::vector<Point3> shuffled_grid(int side) {
  Uniform uniform(5);
  std::vector<Point3> points;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < side; ++z) points.push_back({1.0 * x, 1.0 * y, 1.0 * z});
    }
  }
  std::shuffle(points.begin(), points.end(), uniform.generator());
  return points;
}

}  // namespace sinkmesh::bench
