// SPDX-License-Identifier: MIT
//
// How bad a simplex is, as a whole number: what moving and removing vertices must not let grow.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "predicates/point.h"

namespace sinkmesh {

/// Cost of a simplex by its smallest (dihedral) angle and its ratio r/l [OS, 3]. With t the least angle that is
/// good enough: 0 from 4/3 t on, then up to 30 as the sine of the angle falls to 0; 50 more below t, 200 below
/// 2/3 t, 1000 below t/3. If r/l is above the bound, 2^32 more, and, up to 1000, 50 for each multiple of the
/// bound: where a simplex of low quality cannot be mended, a better one is worth more.
///
/// Costs are whole numbers so that their sums are exact: they do not depend on the order of summation, and one
/// that falls at every step falls by one at least.
template <int Dim>
class SliverCost {
 public:
  using Cost = std::int64_t;
  static constexpr Cost kSliver = 50;  ///< at least that of a simplex with an angle below t
  static constexpr Cost kLow = Cost{1} << 32;

  /// @param min_angle  t, in degrees, above 0 and below 60.
  /// @param max_ratio  bound on r/l.
  SliverCost(double min_angle, double max_ratio);

  /// A function of the set of corners, not of their order.
  Cost operator()(Corners<Dim> corners) const;

 private:
  static constexpr Cost kSlope = 30;
  static constexpr double kRatioSlope = 50;
  static constexpr double kMostForRatio = 1000;

  double max_ratio2_;
  double least_sine_;               // of 4/3 t
  double largest_cotangent2_;       // of that angle
  std::array<double, 3> bound2_{};  // squares of cotangents of t/3, 2/3 t and t
};

extern template class SliverCost<2>;
extern template class SliverCost<3>;

}  // namespace sinkmesh
