// SPDX-License-Identifier: MIT
//
// How the sign of a polynomial changes when its points change places.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

#include "predicates/polynomials.h"

namespace sinkmesh::stress {

template <std::size_t N>
struct Symmetry {
  std::array<std::size_t, N> order;
  int sign;

  template <class T>
  std::array<T, N> operator()(const std::array<T, N>& points) const {
    std::array<T, N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = points[order[i]];
    return result;
  }
};

/// All permutations of the points first .. first+count-1. The sign is the parity if `alternating`, else 1.
template <std::size_t N>
std::vector<Symmetry<N>> permutations(std::size_t first, std::size_t count, bool alternating) {
  std::array<std::size_t, N> order;
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto begin = order.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = begin + static_cast<std::ptrdiff_t>(count);
  std::vector<Symmetry<N>> result;
  do {
    int sign = 1;
    for (auto i = begin; alternating && i != end; ++i) {
      for (auto j = i + 1; j != end; ++j) sign = *i > *j ? -sign : sign;
    }
    result.push_back({order, sign});
  } while (std::next_permutation(begin, end));
  return result;
}

template <int Dim>
auto symmetries(detail::Orientation<Dim>) {
  return permutations<Dim + 1>(0, Dim + 1, true);
}
template <int Dim>
auto symmetries(detail::InSphere<Dim>) {
  return permutations<Dim + 2>(0, Dim + 2, true);
}
template <int Dim>
auto symmetries(detail::Diametral<Dim>) {
  return permutations<Dim + 1>(0, Dim, false);
}
/// The two normals change places; in space so do the corners of the edge that both facets share.
template <int Dim>
auto symmetries(detail::FacetNormals<Dim>) {
  auto result = permutations<Dim + 1>(1, Dim - 1, false);
  for (std::size_t i = 0, n = result.size(); i < n; ++i) {
    auto exchanged = result[i];
    std::swap(exchanged.order.front(), exchanged.order.back());
    result.push_back(exchanged);
  }
  return result;
}
/// Of each simplex alone, and the two simplices change places.
template <int Dim>
auto symmetries(detail::Orthogonality<Dim>) {
  constexpr std::size_t kCorners = Dim + 1;
  auto result = permutations<2 * kCorners>(0, kCorners, true);
  for (const auto& s : permutations<2 * kCorners>(kCorners, kCorners, true)) {
    result.push_back(s);
    std::rotate(result.back().order.begin(), result.back().order.begin() + kCorners, result.back().order.end());
    result.push_back(s);
  }
  return result;
}

}  // namespace sinkmesh::stress
