// SPDX-License-Identifier: MIT
#include "tools/reproduce/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/vector.h"
#include "predicates/error.h"

namespace sinkmesh::reproduce {
namespace {

Point3 unit(const Point3& v) {
  const double length = std::sqrt(dot(v, v));
  if (!(length > 0)) throw InputError("a view needs two directions that are neither 0 nor parallel");
  return {v[0] / length, v[1] / length, v[2] / length};
}

}  // namespace

Projection::Projection(const View& view, std::span<const Point3> points, int width, int height, double margin) {
  if (points.empty()) throw InputError("a view needs at least one point");
  towards_ = unit(view.towards_eye);
  right_ = unit(cross(view.up, towards_));
  up_ = cross(towards_, right_);

  Box<3> box;
  for (const Point3& p : points) box.include(p);
  for (std::size_t k = 0; k < 3; ++k) center_[k] = (box.low[k] + box.high[k]) / 2;
  double radius2 = 0;
  for (const Point3& p : points) radius2 = std::max(radius2, squared_distance(p, center_));
  if (radius2 > 0) radius_ = std::sqrt(radius2);
  // The eye sees the bounding sphere under the angle asked for, hence is outside, and nothing lies behind it.
  if (view.field_of_view > 0) {
    distance_ = radius_ / std::sin(std::min(view.field_of_view, 170.0) * std::numbers::pi / 360);
  }

  Box<2> seen;
  for (const Point3& p : points) {
    const ScreenPoint q = project(p);
    seen.include({q.x, q.y});
  }
  const double room_x = std::max(1.0, width - 2 * margin);
  const double room_y = std::max(1.0, height - 2 * margin);
  const double extent_x = seen.high[0] - seen.low[0];
  const double extent_y = seen.high[1] - seen.low[1];
  if (extent_x > 0 || extent_y > 0) scale_ = 1 / std::max(extent_x / room_x, extent_y / room_y);
  shift_ = {width / 2.0 - scale_ * (seen.low[0] + seen.high[0]) / 2,
            height / 2.0 - scale_ * (seen.low[1] + seen.high[1]) / 2};
}

Point3 Projection::rotate(const Point3& direction) const {
  return {dot(direction, right_), dot(direction, up_), dot(direction, towards_)};
}

ScreenPoint Projection::project(const Point3& p) const {
  const Point3 q = rotate(p - center_);
  const double nearness = distance_ > 0 ? 1 / (distance_ - q[2]) : q[2];
  const double shrink = distance_ > 0 ? distance_ * nearness : 1;
  return {scale_ * shrink * q[0] + shift_[0], -scale_ * shrink * q[1] + shift_[1], nearness};
}

double Projection::depth(double nearness) const { return (distance_ > 0 ? 1 / nearness : -nearness) / radius_; }

}  // namespace sinkmesh::reproduce
