// SPDX-License-Identifier: MIT
//
// Point sets of any size, most of them degenerate; they may have duplicates, and need not span the space.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "test/support/clouds.h"
#include "test/support/point_sets.h"

namespace sinkmesh::test {

enum class Shape {
  kGrid,            ///< all points of a grid
  kSphere,          ///< rounded onto a sphere
  kIntegerSphere,   ///< exactly cospherical
  kFlatPlusOne,     ///< on a hyperplane, and one point beside it
  kLinePlusFew,     ///< collinear, and three points beside the line
  kCylinder,        ///< rings of exactly cocircular points; in the plane two columns
  kTwoHyperplanes,  ///< grids on two parallel ones
  kClusters,        ///< around a few centres, at very different scales
  kFineSpacing,     ///< a grid of spacing 1e-9 far from the origin
  kUniform,
};
inline constexpr std::array kShapes{
    Shape::kGrid,     Shape::kSphere,         Shape::kIntegerSphere, Shape::kFlatPlusOne, Shape::kLinePlusFew,
    Shape::kCylinder, Shape::kTwoHyperplanes, Shape::kClusters,      Shape::kFineSpacing, Shape::kUniform};

namespace shapes {

template <int Dim>
std::vector<Point<Dim>> grid_of_about(std::size_t n) {
  const double side = std::pow(static_cast<double>(n), 1.0 / Dim);
  return grid_points<Dim>(std::max(2, static_cast<int>(std::lround(side))));
}

template <int Dim>
std::vector<Point<Dim>> two_hyperplanes(std::size_t n) {
  std::vector<Point<Dim>> points;
  for (const Point<Dim - 1>& q : grid_of_about<Dim - 1>((n + 1) / 2)) {
    for (const double x : {0.0, 1.0}) {
      Point<Dim>& p = points.emplace_back();
      p[0] = x;
      std::copy(q.begin(), q.end(), p.begin() + 1);
    }
  }
  return points;
}

template <int Dim>
Point<Dim> ring_point(std::size_t i) {
  constexpr std::array<Point2, 12> kRing{{{5, 0},
                                          {4, 3},
                                          {3, 4},
                                          {0, 5},
                                          {-3, 4},
                                          {-4, 3},
                                          {-5, 0},
                                          {-4, -3},
                                          {-3, -4},
                                          {0, -5},
                                          {3, -4},
                                          {4, -3}}};
  Point<Dim> p{};
  p[0] = kRing[i % kRing.size()][0];
  p[1] = kRing[i % kRing.size()][1];
  p[Dim - 1] = 3.0 * static_cast<double>(i / kRing.size());
  return p;
}

}  // namespace shapes

/// About n points, but no more than there are on the integer sphere: 36 in the plane, some hundred in space.
template <int Dim>
std::vector<Point<Dim>> make_shape(Shape shape, std::size_t n, Random& random) {
  std::vector<Point<Dim>> points;
  const auto add = [&](auto coordinate) {
    Point<Dim>& p = points.emplace_back();
    for (std::size_t k = 0; k < Dim; ++k) p[k] = coordinate(k);
  };
  const int size = static_cast<int>(n);
  switch (shape) {
    case Shape::kGrid:
      return shapes::grid_of_about<Dim>(n);
    case Shape::kSphere:
      for (int i = 0; i < size; ++i) {
        add([&](std::size_t) { return uniform(random, -1, 1); });
        double norm = 0;
        for (const double x : points.back()) norm += x * x;
        for (double& x : points.back()) x /= std::sqrt(norm);
      }
      return points;
    case Shape::kIntegerSphere:
      points = sphere_points<Dim>();
      std::shuffle(points.begin(), points.end(), random);
      points.resize(std::min(points.size(), n));
      return points;
    case Shape::kFlatPlusOne:
      for (int i = 0; i < size; ++i) {
        add([&](std::size_t) { return static_cast<double>(uniform_int(random, -size / 15, size / 15)); });
        points.back()[0] = 3 * points.back()[1] + (Dim == 3 ? points.back()[Dim - 1] : 0);
      }
      add([](std::size_t k) { return k == 0 ? 1.0 : 0.0; });
      return points;
    case Shape::kLinePlusFew:
      for (int i = 0; i < size; ++i) {
        const int x = uniform_int(random, -size, size);
        add([&](std::size_t k) { return static_cast<double>(x * static_cast<int>(k + 1)); });
      }
      for (int i = 0; i < 3; ++i) {
        add([&](std::size_t) { return static_cast<double>(uniform_int(random, -9, 9)); });
      }
      return points;
    case Shape::kCylinder:
      for (std::size_t i = 0; i < n; ++i) points.push_back(shapes::ring_point<Dim>(i));
      return points;
    case Shape::kTwoHyperplanes:
      return shapes::two_hyperplanes<Dim>(n);
    case Shape::kClusters:
      for (int i = 0; i < size; ++i) {
        const double centre = i % 4;
        const double scale = std::ldexp(1.0, -15 * (i % 4));
        add([&](std::size_t k) { return centre * (k == 0 ? 1 : 0.5) + scale * uniform(random, -1, 1); });
      }
      return points;
    case Shape::kFineSpacing:
      for (Point<Dim> p : shapes::grid_of_about<Dim>(n)) {
        for (double& x : p) x = 1 + 1e-9 * x;
        points.push_back(p);
      }
      return points;
    case Shape::kUniform:
      for (int i = 0; i < size; ++i) add([&](std::size_t) { return uniform(random, -1, 1); });
      return points;
  }
  return points;
}

}  // namespace sinkmesh::test
