// SPDX-License-Identifier: MIT
#include "refine/sphere_set.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/mix.h"
#include "core/vector.h"

namespace sinkmesh {
namespace {

template <int Dim>
Corners<Dim> pointers(const std::array<Point<Dim>, Dim + 1>& points) {
  Corners<Dim> corners;
  for (std::size_t i = 0; i <= Dim; ++i) corners[i] = &points[i];
  return corners;
}

int exponent_of(double radius2) { return std::ilogb(std::sqrt(radius2)) + 1; }

std::int64_t cell_of(double coordinate, int exponent) {
  return static_cast<std::int64_t>(std::floor(std::ldexp(coordinate, -exponent)));
}

}  // namespace

template <int Dim>
std::size_t SphereSet<Dim>::CellHash::operator()(const Cell& cell) const {
  std::uint64_t h = 0;
  for (const std::int64_t c : cell) h = mix(h + static_cast<std::uint64_t>(c));
  return static_cast<std::size_t>(h);
}

template <int Dim>
bool SphereSet<Dim>::is_orthogonal(const Sphere& a, const Sphere& b) const {
  if (a.corners && b.corners) {
    return predicates_->orthogonality(pointers<Dim>(*a.corners), pointers<Dim>(*b.corners)) >= 0;
  }
  return squared_distance(a.center, b.center) >= a.radius2 + b.radius2;
}

template <int Dim>
bool SphereSet<Dim>::is_orthogonal_to_all(const Sphere& sphere) const {
  const auto is_far = [&](const std::vector<std::uint32_t>& ids) {
    return std::all_of(ids.begin(), ids.end(),
                       [&](std::uint32_t i) { return is_orthogonal(sphere, spheres_[i]); });
  };
  for (const Level& level : levels_) {
    // Closer than orthogonal means distance < sqrt(r^2 + R^2) < r + R; the factor covers the rounding of both
    // radii.
    const double reach = (std::sqrt(sphere.radius2) + std::ldexp(1.0, level.exponent)) * (1 + 0x1p-20);
    Cell low;
    Cell high;
    double num_cells = 1;
    for (std::size_t k = 0; k < Dim; ++k) {
      low[k] = cell_of(sphere.center[k] - reach, level.exponent);
      high[k] = cell_of(sphere.center[k] + reach, level.exponent);
      num_cells *= static_cast<double>(high[k] - low[k] + 1);
    }
    if (num_cells > static_cast<double>(level.cells.size())) {  // a large sphere among small ones
      for (const auto& [cell, ids] : level.cells) {
        if (!is_far(ids)) return false;
      }
      continue;
    }
    for (Cell cell = low;;) {
      const auto found = level.cells.find(cell);
      if (found != level.cells.end() && !is_far(found->second)) return false;
      std::size_t k = 0;
      while (k < Dim && ++cell[k] > high[k]) {
        cell[k] = low[k];
        ++k;
      }
      if (k == Dim) break;
    }
  }
  return true;
}

template <int Dim>
void SphereSet<Dim>::add(const Sphere& sphere) {
  const int exponent = exponent_of(sphere.radius2);
  auto level =
      std::find_if(levels_.begin(), levels_.end(), [&](const Level& l) { return l.exponent == exponent; });
  if (level == levels_.end()) level = levels_.insert(levels_.end(), Level{exponent, {}});
  Cell cell;
  for (std::size_t k = 0; k < Dim; ++k) cell[k] = cell_of(sphere.center[k], exponent);
  level->cells[cell].push_back(static_cast<std::uint32_t>(spheres_.size()));
  spheres_.push_back(sphere);
}

template class SphereSet<2>;
template class SphereSet<3>;

}  // namespace sinkmesh
