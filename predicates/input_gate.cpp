// SPDX-License-Identifier: MIT
#include "predicates/input_gate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "predicates/detail/grid.h"
#include "predicates/error.h"

namespace sinkmesh {
namespace {

constexpr int kSmallestExponent = -800;

std::string coordinate_text(std::size_t index, std::size_t axis, double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.17g (%a)", value, value);
  return "point " + std::to_string(index) + ": coordinate " + "xyz"[axis] + " is " + text;
}

/// To the nearest multiple of 2^-kGridBits, ties to even; -0.0 becomes +0.0. From 2^(52-kGridBits) on, every
/// double is one already; below, x 2^kGridBits is exact or far below one half.
double round_to_grid(double x) {
  static_assert(kGridBits == 121);
  if (std::abs(x) >= 0x1p-69) return x;
  return std::nearbyint(x * 0x1p121) * 0x1p-121 + 0.0;
}

}  // namespace

template <int Dim>
Point<Dim> on_grid(Point<Dim> p) {
  for (double& x : p) x = round_to_grid(x);
  return p;
}

template <int Dim>
InputGate<Dim>::InputGate(std::span<const Point<Dim>> points) {
  double largest = 0;
  std::size_t index_of_largest = 0;
  std::size_t axis_of_largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < Dim; ++k) {
      const double x = points[i][k];
      if (!std::isfinite(x)) {
        throw InputError(coordinate_text(i, k, x) +
                         "; every coordinate must be a finite number: remove or repair this point");
      }
      if (std::abs(x) > std::abs(largest)) {
        largest = x;
        index_of_largest = i;
        axis_of_largest = k;
      }
    }
  }
  if (largest != 0) exponent_ = -std::ilogb(largest);
  if (exponent_ > -kSmallestExponent) {
    throw InputError(coordinate_text(index_of_largest, axis_of_largest, largest) +
                     ", the largest of all, and below 2^-800: results would not be representable; multiply all "
                     "coordinates by a large constant (choose another unit of length)");
  }
  // Multiplication by a power of two rounds as ldexp() does, and is many times as fast.
  factor_ = std::ldexp(1.0, exponent_);
  inverse_ = std::ldexp(1.0, -exponent_);
  for (const Point<Dim>& p : points) {
    const Point<Dim> gated = in(p);
    box_.include(gated);
    for (const double x : gated) granularity_ = std::max(granularity_, detail::fraction_bits(x));
    if (out(gated) != p) ++rounded_points_;
  }
}

template <int Dim>
bool InputGate<Dim>::admits(const Point<Dim>& p) const {
  return std::all_of(p.begin(), p.end(), [this](double x) { return std::abs(std::ldexp(x, exponent_)) < 2; });
}

template <int Dim>
Point<Dim> InputGate<Dim>::in(const Point<Dim>& p) const {
  Point<Dim> scaled;
  for (std::size_t k = 0; k < Dim; ++k) scaled[k] = p[k] * factor_;
  return on_grid<Dim>(scaled);
}

template <int Dim>
Point<Dim> InputGate<Dim>::out(const Point<Dim>& p) const {
  Point<Dim> raw;
  for (std::size_t k = 0; k < Dim; ++k) raw[k] = p[k] * inverse_;
  return raw;
}

template Point2 on_grid<2>(Point2);
template Point3 on_grid<3>(Point3);
template class InputGate<2>;
template class InputGate<3>;

}  // namespace sinkmesh
