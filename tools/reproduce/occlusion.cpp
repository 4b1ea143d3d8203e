// SPDX-License-Identifier: MIT
//
// Unsharp masking of the depth buffer (Luft, Colditz, Deussen 2006). The bell is approximated by a box filter,
// three times in each direction, and normalised by the coverage filtered in the same way.
#include "tools/reproduce/occlusion.h"

#include <algorithm>
#include <cstddef>

namespace sinkmesh::reproduce {
namespace {

// Filters `count` values that are `stride` apart; outside there are zeros.
void box_filter(float* values, std::size_t count, std::size_t stride, std::size_t radius,
                std::vector<float>& copy) {
  for (std::size_t i = 0; i < count; ++i) copy[i] = values[i * stride];
  double sum = 0;
  for (std::size_t i = 0; i < std::min(radius, count); ++i) sum += copy[i];
  const auto width = static_cast<double>(2 * radius + 1);
  for (std::size_t i = 0; i < count; ++i) {
    if (i + radius < count) sum += copy[i + radius];
    if (i > radius) sum -= copy[i - radius - 1];
    values[i * stride] = static_cast<float>(sum / width);
  }
}

void blur(Plane& plane, std::size_t radius) {
  const auto width = static_cast<std::size_t>(plane.width);
  const auto height = static_cast<std::size_t>(plane.height);
  std::vector<float> copy(std::max(width, height));
  for (int pass = 0; pass < 3; ++pass) {
    for (std::size_t y = 0; y < height; ++y) box_filter(&plane.values[y * width], width, 1, radius, copy);
    for (std::size_t x = 0; x < width; ++x) box_filter(&plane.values[x], height, width, radius, copy);
  }
}

}  // namespace

Plane behind_surroundings(const Plane& depth, const Plane& coverage, int radius) {
  Plane mean = depth;
  Plane weight = coverage;
  blur(mean, static_cast<std::size_t>(radius));
  blur(weight, static_cast<std::size_t>(radius));
  Plane result{depth.width, depth.height, std::vector<float>(depth.values.size(), 0.0f)};
  for (std::size_t i = 0; i < depth.values.size(); ++i) {
    if (coverage.values[i] <= 0) continue;
    result.values[i] = depth.values[i] / coverage.values[i] - mean.values[i] / weight.values[i];
  }
  return result;
}

}  // namespace sinkmesh::reproduce
