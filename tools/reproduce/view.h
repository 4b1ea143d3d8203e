// SPDX-License-Identifier: MIT
//
// From space to the picture.
#pragma once

#include <array>
#include <span>

#include "predicates/point.h"

namespace sinkmesh::reproduce {

/// Where the eye is, up to what follows from fitting the object into the picture.
struct View {
  Point3 towards_eye = {1, -2, 1};  ///< from the object; any length but 0
  Point3 up = {0, 0, 1};            ///< upwards in the picture; not parallel to towards_eye
  double field_of_view = 25;        ///< of the object's bounding sphere, in degrees; 0: orthographic
};

/// In pixels from the upper left corner. `nearness` grows towards the eye, and over the picture of a plane it
/// is an affine function of x and y, which is what a z-buffer needs.
struct ScreenPoint {
  double x;
  double y;
  double nearness;
};

/// A view of given points, which touch a margin in the picture.
class Projection {
 public:
  /// @throws InputError if there is no point, a direction of the view is 0, or both are parallel.
  Projection(const View& view, std::span<const Point3> points, int width, int height, double margin = 8);

  ScreenPoint project(const Point3& p) const;
  /// A direction as seen by the eye: to the right, upwards, towards the eye.
  Point3 rotate(const Point3& direction) const;
  /// Distance from the eye's plane, as a multiple of the radius of the points' bounding sphere.
  double depth(double nearness) const;

 private:
  Point3 right_{}, up_{}, towards_{};
  Point3 center_{};
  double radius_ = 1;
  double distance_ = 0;  // of the eye from the center; 0: orthographic
  double scale_ = 1;
  std::array<double, 2> shift_{};
};

}  // namespace sinkmesh::reproduce
