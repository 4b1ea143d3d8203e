// SPDX-License-Identifier: MIT
//
// One order of the corners of a simplex, so that rounding does not depend on how they are numbered.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace sinkmesh {

/// Puts the corners in lexicographic order: rounding then depends on the simplex alone. Which of two comes
/// first is a coin toss, so ranks are counted, without a branch; only equal coordinates need one.
template <std::size_t N, class P>
void sort_corners(std::array<const P*, N>& corners) {
  std::array<std::size_t, N> rank{};
  bool has_ties = false;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const std::size_t is_first = (*corners[i])[0] < (*corners[j])[0] ? 1 : 0;
      rank[i] += 1 - is_first;
      rank[j] += is_first;
      has_ties |= (*corners[i])[0] == (*corners[j])[0];
    }
  }
  if (has_ties) [[unlikely]] {
    std::sort(corners.begin(), corners.end(), [](const P* p, const P* q) { return *p < *q; });
    return;
  }
  const std::array<const P*, N> unsorted = corners;
  for (std::size_t i = 0; i < N; ++i) corners[rank[i]] = unsorted[i];
}

}  // namespace sinkmesh
