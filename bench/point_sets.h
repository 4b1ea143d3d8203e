// SPDX-License-Identifier: MIT
//
// Point sets for benchmarks, with fixed seeds.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

template <int Dim>
std::vector<Point<Dim>> uniform_box(std::size_t n) {
  Uniform uniform(1);
  std::vector<Point<Dim>> points(n);
  for (Point<Dim>& p : points) {
    for (double& x : p) x = uniform();
  }
  return points;
}
inline std::vector<Point2> uniform_square(std::size_t n) { return uniform_box<2>(n); }
inline std::vector<Point3> uniform_cube(std::size_t n) { return uniform_box<3>(n); }

/// On the unit circle up to rounding.
inline std::vector<Point2> rounded_circle(std::size_t n) {
  Uniform uniform(6);
  std::vector<Point2> points(n);
  for (Point2& p : points) {
    const double angle = 2 * std::numbers::pi * uniform();
    p = {std::cos(angle), std::sin(angle)};
  }
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

/// The integer grid of side^Dim points, shuffled.
template <int Dim>
std::vector<Point<Dim>> shuffled_grid(int side) {
  Uniform uniform(5);
  std::vector<Point<Dim>> points;
  Point<Dim> p{};
  for (;;) {
    points.push_back(p);
    std::size_t k = 0;
    while (k < Dim && ++p[k] == side) p[k++] = 0;
    if (k == Dim) break;
  }
  std::shuffle(points.begin(), points.end(), uniform.generator());
  return points;
}
/// About n points.
inline std::vector<Point2> square_grid(std::size_t n) {
  return shuffled_grid<2>(static_cast<int>(std::lround(std::sqrt(n))));
}
inline std::vector<Point3> cubic_grid(std::size_t n) {
  return shuffled_grid<3>(static_cast<int>(std::lround(std::cbrt(n))));
}

}  // namespace sinkmesh::bench
