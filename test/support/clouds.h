// SPDX-License-Identifier: MIT
//
// Seeded generators of small point sets: random, degenerate, and next to degenerate.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "predicates/point.h"

namespace sinkmesh::test {

using Random = std::mt19937_64;

inline double uniform(Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}
inline int uniform_int(Random& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
}

enum class Cloud {
  kUniform,         ///< [-1,1]^Dim
  kIntegerGrid,     ///< {0,1,2}^Dim
  kTenthLattice,    ///< 0.1 i, rounded, i = 0..3
  kBoxCorners,      ///< corners of one axis-parallel box with random sides
  kRoundedSphere,   ///< rounded onto a sphere with random center; points 0 and 1 nearly antipodal
  kFlat,            ///< rounded onto a random hyperplane
  kIntegerSphere,   ///< exactly on a sphere; points 0 and 1 antipodal; the second half on an orthogonal sphere
  kScaledSphere,    ///< the same times a random factor, rounded
  kNeighbours,      ///< kIntegerSphere with one coordinate moved to a neighbouring double
  kFlatInteger,     ///< integers on a hyperplane
  kFlatScaled,      ///< the same times a random factor, rounded
  kFlatNeighbours,  ///< kFlatInteger with one coordinate moved to a neighbouring double
  kLargeOffset,     ///< few bits of detail, far from the origin
  kTwoScales        ///< half of the points 2^-40 times the size of the others
};
inline constexpr std::array kAllClouds{
    Cloud::kUniform,    Cloud::kIntegerGrid,    Cloud::kTenthLattice, Cloud::kBoxCorners, Cloud::kRoundedSphere,
    Cloud::kFlat,       Cloud::kIntegerSphere,  Cloud::kScaledSphere, Cloud::kNeighbours, Cloud::kFlatInteger,
    Cloud::kFlatScaled, Cloud::kFlatNeighbours, Cloud::kLargeOffset,  Cloud::kTwoScales};

/// On the sphere of squared radius 9 (3D) or 25 (2D) around the origin.
template <int Dim>
Point<Dim> integer_sphere_point(Random& random) {
  Point<Dim> p;
  if constexpr (Dim == 2) {
    constexpr Point2 kPoints[] = {{3, 4}, {5, 0}};
    p = kPoints[random() % 2];
  } else {
    constexpr Point3 kPoints[] = {{1, 2, 2}, {1, 2, 2}, {3, 0, 0}};
    p = kPoints[random() % 3];
  }
  std::shuffle(p.begin(), p.end(), random);
  for (double& x : p) {
    if (random() % 2 != 0 && x != 0) x = -x;
  }
  return p;
}

/// The center of a sphere of the same radius that is orthogonal to the first.
template <int Dim>
Point<Dim> orthogonal_center() {
  if constexpr (Dim == 2) {
    return {7, 1};
  } else {
    return {4, 1, 1};
  }
}

template <int Dim>
void move_to_neighbour(std::vector<Point<Dim>>& points, Random& random) {
  double& x = points[random() % points.size()][random() % Dim];
  const double target = random() % 2 != 0 ? HUGE_VAL : -HUGE_VAL;
  if (x == 0) x = std::copysign(0x1p-52, target);
  for (int n = uniform_int(random, 1, 3); n > 0; --n) x = std::nextafter(x, target);
}

template <int Dim>
std::vector<Point<Dim>> candidate_cloud(Cloud kind, std::size_t n, Random& random) {
  std::vector<Point<Dim>> points(n);
  const auto fill = [&](auto coordinate) {
    for (auto& p : points) {
      for (double& x : p) x = coordinate();
    }
  };
  const auto fill_integer_spheres = [&] {
    for (std::size_t i = 0; i < n; ++i) points[i] = integer_sphere_point<Dim>(random);
    if (n > 1) {
      for (std::size_t k = 0; k < Dim; ++k) points[1][k] = points[0][k] == 0 ? 0.0 : -points[0][k];
    }
    if (n >= 2 * (Dim + 1)) {
      for (std::size_t i = Dim + 1; i < n; ++i) {
        for (std::size_t k = 0; k < Dim; ++k) points[i][k] += orthogonal_center<Dim>()[k];
      }
    }
  };
  const auto fill_flat = [&] {
    for (auto& p : points) {
      for (double& x : p) x = uniform_int(random, -40, 40);
      p[Dim - 1] = Dim == 3 ? p[0] + 2 * p[1] + 5 : 3 * p[0] + 5;
    }
  };
  const auto scale_all = [&] {
    const double factor = uniform(random, 0.1, 1);
    for (auto& p : points) {
      for (double& x : p) x *= factor;
    }
  };
  switch (kind) {
    case Cloud::kUniform:
      fill([&] { return uniform(random, -1, 1); });
      break;
    case Cloud::kIntegerGrid:
      fill([&] { return static_cast<double>(uniform_int(random, 0, 2)); });
      break;
    case Cloud::kTenthLattice:
      fill([&] { return 0.1 * uniform_int(random, 0, 3); });
      break;
    case Cloud::kBoxCorners: {
      Point<Dim> low;
      Point<Dim> high;
      for (std::size_t k = 0; k < Dim; ++k) {
        low[k] = uniform(random, -1, 1);
        high[k] = uniform(random, -1, 1);
      }
      for (auto& p : points) {
        for (std::size_t k = 0; k < Dim; ++k) p[k] = random() % 2 != 0 ? low[k] : high[k];
      }
      break;
    }
    case Cloud::kRoundedSphere: {
      const Point<Dim> center = [&] {
        Point<Dim> c;
        for (double& x : c) x = random() % 2 != 0 ? 0.0 : uniform(random, -1, 1);
        return c;
      }();
      const double radius = random() % 2 != 0 ? 1 : uniform(random, 0.01, 1);
      fill([&] { return uniform(random, -1, 1); });
      for (std::size_t i = 0; i < n; ++i) {
        if (i == 1) {
          for (std::size_t k = 0; k < Dim; ++k) points[1][k] = 2 * center[k] - points[0][k];
          continue;
        }
        double norm = 0;
        for (const double x : points[i]) norm += x * x;
        norm = std::sqrt(norm);
        for (std::size_t k = 0; k < Dim; ++k) points[i][k] = center[k] + radius * (points[i][k] / norm);
      }
      break;
    }
    case Cloud::kFlat: {
      Point<Dim> slope;
      for (double& x : slope) x = uniform(random, -1, 1);
      fill([&] { return uniform(random, -1, 1); });
      for (auto& p : points) {
        p[Dim - 1] = slope[Dim - 1];
        for (std::size_t k = 0; k + 1 < Dim; ++k) p[Dim - 1] += slope[k] * p[k];
      }
      break;
    }
    case Cloud::kIntegerSphere:
      fill_integer_spheres();
      break;
    case Cloud::kScaledSphere:
      fill_integer_spheres();
      scale_all();
      break;
    case Cloud::kNeighbours:
      fill_integer_spheres();
      move_to_neighbour<Dim>(points, random);
      break;
    case Cloud::kFlatInteger:
      fill_flat();
      break;
    case Cloud::kFlatScaled:
      fill_flat();
      scale_all();
      break;
    case Cloud::kFlatNeighbours:
      fill_flat();
      move_to_neighbour<Dim>(points, random);
      break;
    case Cloud::kLargeOffset:
      fill([&] { return 0x1p20 + 0x1p-30 * uniform_int(random, 0, 3); });
      break;
    case Cloud::kTwoScales:
      fill([&] { return uniform(random, -1, 1); });
      for (std::size_t i = 0; i < n; i += 2) {
        for (double& x : points[i]) x *= 0x1p-40;
      }
      break;
  }
  return points;
}

/// n distinct points, in random order except where the kind names points.
template <int Dim>
std::vector<Point<Dim>> make_cloud(Cloud kind, std::size_t n, Random& random) {
  for (int trial = 0; trial < 20; ++trial) {
    auto points = candidate_cloud<Dim>(kind, n, random);
    auto sorted = points;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()) return points;
  }
  return candidate_cloud<Dim>(Cloud::kUniform, n, random);  // the kind has fewer than n positions
}

/// Random significands of few or of all bits, and exponents from low to high, in one of three spreads.
template <int Dim>
std::vector<Point<Dim>> make_wide_cloud(int low, int high, std::size_t n, Random& random) {
  std::vector<Point<Dim>> points(n);
  const int spread = uniform_int(random, 0, 2) == 0 ? high - low : uniform_int(random, 0, 80);
  const int first = uniform_int(random, low, high - spread);
  const bool few_bits = random() % 2 != 0;
  for (auto& p : points) {
    for (double& x : p) {
      const double m = few_bits ? 1 + 0.25 * uniform_int(random, 0, 3) : uniform(random, 1, 2);
      x = std::ldexp(random() % 2 != 0 ? m : -m, uniform_int(random, first, first + spread));
    }
  }
  return points;
}

}  // namespace sinkmesh::test
