// SPDX-License-Identifier: MIT
//
// The door for coordinates: after it, every predicate is exact unconditionally [PS, 11].
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "predicates/point.h"

namespace sinkmesh {

/// Scales by one power of two, so that the largest |coordinate| is in [1,2), rounds to the grid 2^-121 (which
/// changes nothing unless a coordinate is smaller than the largest by more than a factor of about 2^68), and
/// turns -0.0 into +0.0.
template <int Dim>
class InputGate {
 public:
  /// @throws InputError naming the index and value of the first coordinate that is not finite, or if the
  /// largest is
  ///         so small (below 2^-800) that results would not be representable in the units of the input.
  /// Cost: one pass.
  explicit InputGate(std::span<const Point<Dim>> points);

  /// To gated coordinates. Requires |coordinate| at most twice the largest of the input.
  Point<Dim> in(const Point<Dim>& p) const {
    Point<Dim> gated;
    for (int k = 0; k < Dim; ++k) gated[k] = on_grid(p[k] * to_gated_[0] * to_gated_[1]);
    return gated;
  }
  /// Back to the units of the input; exact.
  Point<Dim> out(const Point<Dim>& p) const {
    Point<Dim> input;
    for (int k = 0; k < Dim; ++k) input[k] = p[k] * to_input_[0] * to_input_[1];
    return input;
  }

  /// Gated = input * 2^exponent().
  int exponent() const { return exponent_; }
  /// Number of points that had to be rounded to the grid.
  std::size_t rounded_points() const { return rounded_points_; }
  /// All gated coordinates are multiples of 2^-granularity(); at most 121.
  int granularity() const { return granularity_; }
  /// Of the gated points.
  const Box<Dim>& box() const { return box_; }

 private:
  /// To a multiple of 2^-121, ties to even, and -0.0 to 0.0. Doubles from 2^-69 to 2^-68 have the grid's
  /// spacing: adding 2^-69 to a smaller magnitude rounds there, and taking it away again is exact. Larger ones
  /// are on the grid.
  static double on_grid(double x) {
    constexpr double kToGrid = 0x1p-69;
    const double magnitude = std::abs(x);
    if (magnitude < kToGrid) return std::copysign((magnitude + kToGrid) - kToGrid, x) + 0.0;
    return x;
  }

  // Powers of two from -1074 to 1023 and their inverses do not always fit one factor.
  std::array<double, 2> to_gated_{1, 1};
  std::array<double, 2> to_input_{1, 1};
  int exponent_ = 0;
  std::size_t rounded_points_ = 0;
  int granularity_ = 0;
  Box<Dim> box_;
};

extern template class InputGate<2>;
extern template class InputGate<3>;

/// The grid of the gate: gated coordinates are multiples of 2^-kGridBits.
inline constexpr int kGridBits = 121;

}  // namespace sinkmesh
