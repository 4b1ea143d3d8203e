// SPDX-License-Identifier: MIT
//
// Row by row: the three edges cut out of each row of samples the interval that is inside, and only this is
// visited. Thin triangles, of which poor meshes are made, cost no more than their area.
#include "tools/reproduce/rasterizer.h"

#include <algorithm>
#include <cmath>

namespace sinkmesh::reproduce {
namespace {

using Affine = TriangleFunctions::Affine;

// Zero on the line through p and q, positive on its right side as seen (y points down). Exactly the opposite
// for (q, p).
Affine line(const ScreenPoint& p, const ScreenPoint& q) {
  const double dx = q.x - p.x;
  const double dy = q.y - p.y;
  const double length = std::sqrt(dx * dx + dy * dy);
  return {-dy / length, dx / length, (p.x * q.y - p.y * q.x) / length};
}

Affine plane(const ScreenTriangle& t) {
  const double dx1 = t[1].x - t[0].x, dy1 = t[1].y - t[0].y, dz1 = t[1].nearness - t[0].nearness;
  const double dx2 = t[2].x - t[0].x, dy2 = t[2].y - t[0].y, dz2 = t[2].nearness - t[0].nearness;
  const double area = dx1 * dy2 - dx2 * dy1;
  const double a = (dz1 * dy2 - dz2 * dy1) / area;
  const double b = (dx1 * dz2 - dx2 * dz1) / area;
  return {a, b, t[0].nearness - a * t[0].x - b * t[0].y};
}

struct Range {
  double low;
  double high;
};

// Where f >= 0 along a row.
void clip(Range& x, const Affine& f, double y) {
  const double rest = f[1] * y + f[2];
  if (f[0] > 0) {
    x.low = std::max(x.low, -rest / f[0]);
  } else if (f[0] < 0) {
    x.high = std::min(x.high, -rest / f[0]);
  } else if (rest < 0) {
    x.high = -HUGE_VAL;
  }
}

}  // namespace

double signed_area(const ScreenTriangle& t) {
  return (t[2].x - t[0].x) * (t[1].y - t[0].y) - (t[1].x - t[0].x) * (t[2].y - t[0].y);
}

TriangleFunctions::TriangleFunctions(const ScreenTriangle& t) : inside{}, nearness(plane(t)) {
  const bool clockwise = signed_area(t) < 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const ScreenPoint& p = t[(i + 1) % 3];
    const ScreenPoint& q = t[(i + 2) % 3];
    inside[i] = clockwise ? line(p, q) : line(q, p);
  }
}

VisibilityBuffer::VisibilityBuffer(int width, int height, int density)
    : columns_(width * density),
      rows_(height * density),
      density_(density),
      samples_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void VisibilityBuffer::draw(const ScreenTriangle& triangle, std::uint32_t id) {
  if (signed_area(triangle) == 0) return;
  const TriangleFunctions functions(triangle);
  const auto [top, bottom] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
  const auto [left, right] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
  // Where a triangle is seen nearly from the side, rounding may put its plane anywhere; no further than its
  // corners.
  const auto [farthest, nearest] =
      std::minmax({triangle[0].nearness, triangle[1].nearness, triangle[2].nearness});

  // The first and the last sample of an interval; the picture's border first, so that no conversion overflows.
  const auto first = [&](double low) {
    return static_cast<int>(std::ceil(std::max(low, 0.0) * density_ - 0.5));
  };
  const auto last = [&](double high, int count) {
    return static_cast<int>(std::floor(std::clamp(high * density_ - 0.5, -1.0, count - 1.0)));
  };
  const int last_row = last(bottom, rows_);
  for (int row = top * density_ > rows_ ? rows_ : first(top); row <= last_row; ++row) {
    const double y = position(row);
    Range x{left, right};
    for (const Affine& f : functions.inside) clip(x, f, y);
    if (x.low > x.high || x.low * density_ > columns_) continue;
    const int last_column = last(x.high, columns_);
    for (int column = first(x.low); column <= last_column; ++column) {
      const auto nearness =
          static_cast<float>(std::clamp(value(functions.nearness, position(column), y), farthest, nearest));
      Sample& sample = samples_[index(column, row)];
      if (sample.triangle == kNothing || nearness > sample.nearness) sample = {nearness, id};
    }
  }
}

}  // namespace sinkmesh::reproduce
