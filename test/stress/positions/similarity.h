// SPDX-License-Identifier: MIT
//
// Rotations by integers: they keep spheres, planes and right angles exactly, and leave no axis where it was.
#pragma once

#include <array>
#include <cstddef>

#include "test/stress/positions/positions.h"

namespace sinkmesh::stress {

/// The rotation of a quaternion times its squared length; in the plane of a complex number, the first two
/// components, times its length. A quaternion of integers has a matrix of integers.
template <int Dim>
class Similarity {
 public:
  explicit Similarity(const std::array<double, 4>& q) {
    const auto [a, b, c, d] = q;
    if constexpr (Dim == 2) {
      matrix_ = {{{a, -b}, {b, a}}};
    } else {
      matrix_ = {{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
                  {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
                  {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}}};
    }
  }

  Point<Dim> operator()(const Point<Dim>& p) const {
    Point<Dim> q{};
    for (std::size_t i = 0; i < Dim; ++i) {
      for (std::size_t k = 0; k < Dim; ++k) q[i] += matrix_[i][k] * p[k];
    }
    return q;
  }

 private:
  std::array<Point<Dim>, Dim> matrix_;
};

}  // namespace sinkmesh::stress
