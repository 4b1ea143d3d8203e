// SPDX-License-Identifier: MIT
//
// How good a simplex is: the ratio r/l of circumradius to shortest edge [EG01, 4.3], and its angles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "predicates/point.h"
#include "refine/angles.h"

namespace sinkmesh {

/// Squared circumradius and squared length of the shortest edge, in the units of the coordinates.
struct Shape {
  double radius2;    ///< infinite if there is no volume
  double shortest2;  ///< of the edges

  /// (r/l)^2; at least 3/8 for a tetrahedron and 1/3 for a triangle, attained by the regular ones.
  double ratio2() const { return radius2 / shortest2; }
};

/// Rounded, with a relative error below 2^-9 however flat the simplex is; a function of the set of corners, not
/// of their order, so that every comparison of shapes is reproducible. Requires points that passed the input
/// gate. Decides only which simplex is worked on first, or at all; never what is connected to what.
template <int Dim>
Shape shape(Corners<Dim> corners);

/// The same for a facet, as a (Dim-1)-simplex of its own; infinite where rounding sees no area. Of an edge in
/// the plane: r/l = 1/2.
template <int Dim>
Shape facet_shape(FacetCorners<Dim> corners);

/// Square of the area of a facet (in the plane: length), up to a constant factor; rounded.
template <int Dim>
double facet_area2(FacetCorners<Dim> corners);

/// The center of the diametral sphere of a facet; rounded. Not finite if the facet has no area that doubles
/// see.
template <int Dim>
Point<Dim> facet_center(FacetCorners<Dim> corners);

/// Volume divided by the longest edge to the power of Dim; rounded.
template <int Dim>
double flatness(const Corners<Dim>& corners);

/// Statistics over the simplices of a mesh.
class QualityStatistics {
 public:
  /// Upper ends of the bins of the histogram of r/l; the last bin is open.
  static constexpr std::array<double, 12> kBins = {0.65, 0.7, 0.8, 0.9, 1.0,  1.2,
                                                   1.5,  2.0, 3.0, 5.0, 10.0, 1e300};

  /// @param max_ratio  bound above which a simplex is of low quality.
  explicit QualityStatistics(double max_ratio) : max_ratio2_(max_ratio * max_ratio) {}

  template <int Dim>
  void add(const Corners<Dim>& corners);

  std::size_t simplices() const { return count_; }
  std::size_t low_quality() const { return low_; }
  double min_ratio() const;
  double average_ratio() const;
  double max_ratio() const;
  double min_angle() const { return cotangents_.smallest_angle(); }
  double max_angle() const { return cotangents_.largest_angle(); }
  const std::array<std::uint64_t, kBins.size()>& histogram() const { return histogram_; }

 private:
  double max_ratio2_;
  std::size_t count_ = 0;
  std::size_t low_ = 0;
  double min2_ = HUGE_VAL;
  double max2_ = 0;
  double sum_ = 0;
  Cotangents cotangents_;
  std::array<std::uint64_t, kBins.size()> histogram_{};
};

}  // namespace sinkmesh
