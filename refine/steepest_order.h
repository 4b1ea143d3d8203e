// SPDX-License-Identifier: MIT
//
// Which successor of a simplex the flow prefers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "core/complex.h"
#include "refine/quality.h"

namespace sinkmesh {

/// Sorts simplices by circumradius, the largest, to which the flow is the steepest, last: the flow leads to
/// larger ones, so this is the longest way down. Ghosts are infinitely large; equal radii are ordered by their
/// corners. A function of the geometry alone. Holds working memory only; keep one and reuse it.
template <int Dim>
class SteepestOrder {
 public:
  void sort(const Complex<Dim>& complex, std::span<Simplex> simplices) {
    if (simplices.size() < 2) return;
    keys_.clear();
    for (const Simplex s : simplices) {
      Key key{complex.is_ghost(s) ? HUGE_VAL : shape<Dim>(complex.corners(s)).radius2, {}, s};
      for (int k = 0; k <= Dim; ++k)
        key.corners[static_cast<std::size_t>(k)] = complex.point(complex.corner(s, k));
      std::sort(key.corners.begin(), key.corners.end());
      keys_.push_back(key);
    }
    std::sort(keys_.begin(), keys_.end(), [](const Key& a, const Key& b) {
      return a.radius2 != b.radius2 ? a.radius2 < b.radius2 : a.corners < b.corners;
    });
    for (std::size_t i = 0; i < keys_.size(); ++i) simplices[i] = keys_[i].simplex;
  }

 private:
  struct Key {
    double radius2;
    std::array<Point<Dim>, Dim + 1> corners;
    Simplex simplex;
  };

  std::vector<Key> keys_;
};

}  // namespace sinkmesh
