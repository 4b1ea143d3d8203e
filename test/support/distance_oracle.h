// SPDX-License-Identifier: MIT
//
// pi and phi from their definitions, in rationals, and point sets and samples to ask them for [EG01, 3.1].
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "core/triangulation.h"
#include "test/support/point_sets.h"
#include "test/support/rational_geometry.h"

namespace sinkmesh::test {

template <int Dim>
std::vector<PointSet<Dim>> distance_test_sets() {
  std::vector<PointSet<Dim>> sets = point_sets<Dim>(40, 7);
  sets.push_back({"grid", grid_points<Dim>(Dim == 2 ? 6 : 3)});
  // Gated by 2^-21: values must come back in the units of the input.
  sets.push_back({"large", uniform_points<Dim>(60, 3)});
  for (auto& p : sets.back().points) {
    for (double& x : p) x = 3e6 * x - 1e6;
  }
  return sets;
}

/// Everything from the definitions: the smallest square distance to a point, the smallest power of all spheres.
template <int Dim>
class Oracle {
 public:
  Oracle(const std::vector<Point<Dim>>& points, const Triangulation<Dim>& triangulation) {
    for (const Point<Dim>& p : points) points_.push_back(rational<Dim>(p));
    const Complex<Dim>& complex = triangulation.complex();
    for (const Simplex s : solid_simplices(complex)) {
      std::array<RationalPoint<Dim>, Dim + 1> corners;
      for (int i = 0; i <= Dim; ++i) {
        corners[static_cast<std::size_t>(i)] = rational<Dim>(points[complex.corner(s, i).index()]);
      }
      corners_[s] = corners;
      spheres_[s] = orthosphere<Dim>(corners);
    }
  }

  Rational pi(const RationalPoint<Dim>& x) const {
    Rational smallest = squared_distance(x, points_[0]);
    for (const auto& p : points_) smallest = std::min(smallest, squared_distance(x, p));
    return smallest;
  }
  Rational phi(const RationalPoint<Dim>& y) const {
    Rational smallest = spheres_.begin()->second.power(y);
    for (const auto& [s, sphere] : spheres_) smallest = std::min(smallest, sphere.power(y));
    return smallest;
  }
  bool holds(Simplex s, const RationalPoint<Dim>& y) const {
    const auto weights = barycentric<Dim>(corners_.at(s), y);
    return std::all_of(weights.begin(), weights.end(), [](const Rational& w) { return w >= 0; });
  }
  bool is_in_hull(const RationalPoint<Dim>& y) const {
    return std::any_of(corners_.begin(), corners_.end(), [&](const auto& e) { return holds(e.first, y); });
  }
  const RationalSphere<Dim>& sphere(Simplex s) const { return spheres_.at(s); }
  const std::map<Simplex, RationalSphere<Dim>>& spheres() const { return spheres_; }
  const std::array<RationalPoint<Dim>, Dim + 1>& corners(Simplex s) const { return corners_.at(s); }

 private:
  std::vector<RationalPoint<Dim>> points_;
  std::map<Simplex, std::array<RationalPoint<Dim>, Dim + 1>> corners_;
  std::map<Simplex, RationalSphere<Dim>> spheres_;
};

// Points at vertices, in the middle of edges and facets (exactly there for small integers), between vertices,
// around them, and outside the hull.
template <int Dim>
std::vector<Point<Dim>> samples(const std::vector<Point<Dim>>& points, std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point<Dim>> result;
  double extent = 0;
  for (const auto& p : points) {
    for (const double x : p) extent = std::max(extent, std::abs(x));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Point<Dim>& a = points[random() % points.size()];
    Point<Dim> y = a;
    const std::size_t kind = i % 5;
    if (kind == 1 || kind == 2) {
      const Point<Dim>& b = points[random() % points.size()];
      for (std::size_t k = 0; k < Dim; ++k) y[k] = a[k] / 2 + b[k] / 2;
    } else if (kind == 3) {
      double total = 0;
      y = {};
      for (int j = 0; j <= Dim; ++j) {
        const double weight = uniform(random, 0.01, 1);
        const Point<Dim>& b = points[random() % points.size()];
        for (std::size_t k = 0; k < Dim; ++k) y[k] += weight * b[k];
        total += weight;
      }
      for (double& x : y) x /= total;
    } else if (kind == 4) {
      for (double& x : y) x = std::clamp(x + 0.4 * extent * uniform(random, -1, 1), -extent, extent);
    }
    result.push_back(y);
  }
  return result;
}

/// A point nearer to x than any two different values of these sets of doubles are to each other.
template <int Dim>
RationalPoint<Dim> beside(RationalPoint<Dim> x, const RationalPoint<Dim>& direction) {
  for (std::size_t k = 0; k < Dim; ++k) {
    Rational step = direction[k];
    mpq_div_2exp(step.get_mpq_t(), step.get_mpq_t(), 3000);
    x[k] += step;
  }
  return x;
}

template <int Dim>
RationalPoint<Dim> some_direction(Random& random) {
  RationalPoint<Dim> u{};
  while (u == RationalPoint<Dim>{}) {
    for (auto& x : u) x = uniform_int(random, -9, 9);
  }
  return u;
}

}  // namespace sinkmesh::test
