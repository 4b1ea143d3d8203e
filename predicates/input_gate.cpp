// SPDX-License-Identifier: MIT
#include "predicates/input_gate.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

#include "predicates/error.h"

namespace sinkmesh {
namespace {

constexpr int kSmallestExponent = -800;

std::string text_of(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.17g", x);
  return buffer;
}

template <int Dim>
double largest_coordinate(std::span<const Point<Dim>> points) {
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < Dim; ++k) {
      const double x = std::abs(points[i][k]);
      if (!std::isfinite(x)) {
        throw InputError(std::string("coordinate ") + "xyz"[k] + " of point " + std::to_string(i) + " is " +
                         text_of(points[i][k]) + ": coordinates must be finite");
      }
      largest = std::max(largest, x);
    }
  }
  return largest;
}

// The exponent of the lowest set bit of a double that is not 0.
int lowest_bit(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::abs(fraction), 53));
  return exponent - 53 + std::countr_zero(mantissa);
}

// 2^exponent as two factors that are normal doubles.
std::array<double, 2> power_of_two(int exponent) {
  const int half = exponent / 2;
  return {std::ldexp(1.0, half), std::ldexp(1.0, exponent - half)};
}

}  // namespace

template <int Dim>
InputGate<Dim>::InputGate(std::span<const Point<Dim>> points) {
  const double largest = largest_coordinate<Dim>(points);
  if (largest > 0) {
    exponent_ = -std::ilogb(largest);
    if (exponent_ > -kSmallestExponent) {
      throw InputError("the largest coordinate is " + text_of(largest) +
                       ": too small for doubles to hold what is computed from it; scale the input up");
    }
  }
  to_gated_ = power_of_two(exponent_);
  to_input_ = power_of_two(-exponent_);
  int lowest = 0;
  for (const Point<Dim>& p : points) {
    const Point<Dim> gated = in(p);
    box_.include(gated);
    bool is_rounded = false;
    for (std::size_t k = 0; k < Dim; ++k) {
      // Largest first, so that neither product leaves the range: to_gated_ has equal halves.
      is_rounded = is_rounded || gated[k] != p[k] * to_gated_[0] * to_gated_[1];
      if (gated[k] != 0) lowest = std::min(lowest, lowest_bit(gated[k]));
    }
    rounded_points_ += is_rounded ? 1 : 0;
  }
  granularity_ = -lowest;
}

template class InputGate<2>;
template class InputGate<3>;

}  // namespace sinkmesh
