// SPDX-License-Identifier: MIT
#include "refine/sliver_cost.h"

#include <algorithm>
#include <numbers>

#include "refine/angles.h"
#include "refine/corner_order.h"
#include "refine/quality.h"

namespace sinkmesh {

template <int Dim>
SliverCost<Dim>::SliverCost(double min_angle, double max_ratio)
    : max_ratio2_(max_ratio * max_ratio),
      least_sine_(std::sin(min_angle * 4 / 3 * (std::numbers::pi / 180))),
      largest_cotangent2_(cotangent2(min_angle * 4 / 3)),
      bound2_{cotangent2(min_angle / 3), cotangent2(min_angle * 2 / 3), cotangent2(min_angle)} {}

template <int Dim>
auto SliverCost<Dim>::operator()(Corners<Dim> corners) const -> Cost {
  constexpr std::array<Cost, 3> kSteps = {1000, 200, kSliver};
  sort_corners(corners);
  Cost cost = 0;
  if (const double ratio2 = shape<Dim>(corners).ratio2(); !(ratio2 <= max_ratio2_)) {
    const double excess = std::ceil(kRatioSlope * (std::sqrt(ratio2 / max_ratio2_) - 1));
    cost = kLow + static_cast<Cost>(std::min(kMostForRatio, excess));
  }
  const auto cotangents = cotangents2<Dim>(corners);
  const double largest = *std::max_element(cotangents.begin(), cotangents.end());
  if (largest <= largest_cotangent2_) return cost;
  // Where the cotangent is c the sine is 1 / sqrt(1 + c^2): no arc tangent, which libraries round differently.
  const double sine = 1 / std::sqrt(1 + std::max(largest, 0.0));
  cost += static_cast<Cost>(std::ceil(kSlope * std::max(0.0, 1 - sine / least_sine_)));
  for (std::size_t i = 0; i < bound2_.size(); ++i) {
    if (largest > bound2_[i]) return cost + kSteps[i];
  }
  return cost;
}

template class SliverCost<2>;
template class SliverCost<3>;

}  // namespace sinkmesh
