// SPDX-License-Identifier: MIT
//
// Which triangle is seen where: a z-buffer that keeps triangles instead of colours. Colours, edges and shadows
// are worked out afterwards, once per sample that is seen.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tools/reproduce/view.h"

namespace sinkmesh::reproduce {

using ScreenTriangle = std::array<ScreenPoint, 3>;

/// Twice the area, in square pixels: positive if the corners go round counterclockwise as seen.
double signed_area(const ScreenTriangle& triangle);

/// A triangle prepared for questions about points of the picture: affine functions a x + b y + c.
struct TriangleFunctions {
  using Affine = std::array<double, 3>;

  /// Distances in pixels from the three edges, positive inside. Two triangles that share an edge have exactly
  /// opposite functions for it, so that no sample between them is missed.
  std::array<Affine, 3> inside;
  Affine nearness;

  explicit TriangleFunctions(const ScreenTriangle& triangle);
};
inline double value(const TriangleFunctions::Affine& f, double x, double y) {
  return f[0] * x + f[1] * y + f[2];
}

/// Samples on a square grid, `density` x `density` in each pixel, at the centers of their squares.
class VisibilityBuffer {
 public:
  static constexpr std::uint32_t kNothing = ~std::uint32_t{0};
  struct Sample {
    float nearness = 0;
    std::uint32_t triangle = kNothing;
  };

  VisibilityBuffer(int width, int height, int density);

  /// Enters a triangle where it is nearer than what is there; where it is as near, the first one stays. Both
  /// sides are seen. Triangles without area in the picture are passed over.
  void draw(const ScreenTriangle& triangle, std::uint32_t id);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int density() const { return density_; }
  const Sample& at(int column, int row) const { return samples_[index(column, row)]; }
  /// In pixels, of a column of samples or of a row.
  double position(int column_or_row) const { return (column_or_row + 0.5) / density_; }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  int columns_;
  int rows_;
  int density_;
  std::vector<Sample> samples_;
};

}  // namespace sinkmesh::reproduce
