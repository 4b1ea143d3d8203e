// SPDX-License-Identifier: MIT
//
// Angles of simplices: between the facets of a tetrahedron, between the edges of a triangle.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "predicates/point.h"

namespace sinkmesh {

/// The smallest and the largest dihedral angle of a tetrahedron, angle of a triangle; in degrees.
struct Angles {
  double min;
  double max;
};
template <int Dim>
Angles angles(const Corners<Dim>& corners);

/// The extremes of many angles, as squares of cotangents with their signs: what falls as the angle grows, and
/// needs neither a root nor an arc tangent. Infinite at 0 and 180 degrees.
struct Cotangents {
  double largest = -HUGE_VAL;
  double smallest = HUGE_VAL;

  void include(double signed_square) {
    largest = std::max(largest, signed_square);
    smallest = std::min(smallest, signed_square);
  }
  /// In degrees.
  double smallest_angle() const;
  double largest_angle() const;
};

/// All angles of a simplex, 6 or 3, as signed squares of cotangents; rounded.
template <int Dim>
std::array<double, Dim == 2 ? 3 : 6> cotangents2(const Corners<Dim>& corners);

/// The signed square of the cotangent of an angle, in degrees.
double cotangent2(double degrees);

/// How the angles of the simplices of a mesh are distributed.
class AngleCensus {
 public:
  /// Of each simplex counts whose smallest angle is below, in degrees.
  static constexpr std::array<double, 3> kSmall = {5, 10, 15};
  /// The width of a bin of the histogram, in degrees; the first begins at 0, the last ends at 180.
  static constexpr int kBinWidth = 5;

  AngleCensus();

  /// @param is_inner  whether a corner of the simplex is an inner vertex, on no boundary facet: if none is, no
  ///                  point inside can be moved to mend it.
  template <int Dim>
  void add(const Corners<Dim>& corners, bool is_inner);

  /// Of all angles.
  const std::array<std::uint64_t, 180 / kBinWidth>& histogram() const { return histogram_; }
  /// Simplices with an angle below kSmall[i], and those of them that have an inner vertex.
  std::size_t below(std::size_t i) const { return below_[i]; }
  std::size_t inner_below(std::size_t i) const { return inner_below_[i]; }

 private:
  std::array<double, 180 / kBinWidth - 1> ends_{};  // of bins, falling
  std::array<double, kSmall.size()> small_{};
  std::array<std::uint64_t, 180 / kBinWidth> histogram_{};
  std::array<std::size_t, kSmall.size()> below_{};
  std::array<std::size_t, kSmall.size()> inner_below_{};
};

}  // namespace sinkmesh
