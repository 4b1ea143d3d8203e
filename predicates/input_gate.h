// SPDX-License-Identifier: MIT
//
// The door for coordinates: after it, every predicate is exact unconditionally [PS, 11].
#pragma once

#include <cstddef>
#include <span>

#include "predicates/point.h"

namespace sinkmesh {

/// The grid of the gate: gated coordinates are multiples of 2^-kGridBits.
inline constexpr int kGridBits = 121;

/// The nearest point of the grid, ties to even; -0.0 becomes +0.0. What is constructed behind the gate has to
/// pass it before predicates see it; only coordinates below 2^-69 change. Requires coordinates in (-2, 2).
template <int Dim>
Point<Dim> on_grid(Point<Dim> p);

/// Scales by one power of two, so that the largest |coordinate| is in [1,2), rounds to the grid 2^-121 (which
/// changes nothing unless a coordinate is smaller than the largest by more than a factor of about 2^68), and
/// turns -0.0 into +0.0.
template <int Dim>
class InputGate {
 public:
  /// No points, or all at the origin, pass unscaled.
  /// @throws InputError naming the index and value of the first coordinate that is not finite, or if the
  ///         largest is so small (below 2^-800) that results would not be representable in the units of the
  ///         input.
  /// Cost: one pass.
  explicit InputGate(std::span<const Point<Dim>> points);

  /// Whether p is finite and its gated coordinates are in (-2, 2): whether the predicates are exact for it.
  bool admits(const Point<Dim>& p) const;
  /// To gated coordinates. Requires |coordinate| at most the largest of the input (Steiner points lie inside
  /// the box).
  Point<Dim> in(const Point<Dim>& p) const;
  /// Back to the units of the input; exact.
  Point<Dim> out(const Point<Dim>& p) const;

  /// Gated = input * 2^exponent().
  int exponent() const { return exponent_; }
  /// Number of points that had to be rounded to the grid.
  std::size_t rounded_points() const { return rounded_points_; }
  /// All gated coordinates are multiples of 2^-granularity(); at most kGridBits.
  int granularity() const { return granularity_; }
  /// Of the gated points.
  const Box<Dim>& box() const { return box_; }

 private:
  int exponent_ = 0;
  double factor_ = 1;   // 2^exponent_, from 2^-1023, which is exact although subnormal, to 2^800
  double inverse_ = 1;  // 2^-exponent_
  std::size_t rounded_points_ = 0;
  int granularity_ = 0;
  Box<Dim> box_;
};

extern template Point2 on_grid<2>(Point2);
extern template Point3 on_grid<3>(Point3);
extern template class InputGate<2>;
extern template class InputGate<3>;

}  // namespace sinkmesh
