// SPDX-License-Identifier: MIT
//
// Where to try a vertex: the places that SliverMover compares.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/complex.h"

namespace sinkmesh {

/// Proposes places, gated and on the grid. They are functions of coordinates and seeds alone, not of the
/// numbering: sums are taken in an order that the geometry decides, and random points come from a generator
/// that is seeded with a hash of coordinates. Holds working memory only; keep one and reuse it.
template <int Dim>
class Places {
 public:
  /// Around a vertex of the complex, by its star: its place in the optimal Delaunay triangulation, which is the
  /// mean of the circumcenters by volume (Chen, Xu 2004); the center of gravity; and `count` points at random,
  /// at first near the vertex, then up to half the mean length of its edges away.
  /// @return valid until the next call.
  const std::vector<Point<Dim>>& around(const Complex<Dim>& complex, std::span<const Simplex> star, Vertex v,
                                        std::uint64_t seed, int count);
  /// In the circumsphere of a simplex: `count` points at random, at first near the center, then up to 0.9 of
  /// the radius away. Farther out another vertex would be too near. The picking region of Li and Teng 2001 has
  /// half the radius; but near the boundary there is room on one side only.
  const std::vector<Point<Dim>>& in_sphere(Corners<Dim> corners, std::uint64_t seed, int count);

 private:
  void add(const Point<Dim>& place);
  void add_random(const Point<Dim>& center, double radius, std::uint64_t seed, int count);

  std::vector<Point<Dim>> places_;
  std::vector<std::pair<std::uint64_t, FacetCorners<Dim>>> link_;  // and hashes, which order it
};

extern template class Places<2>;
extern template class Places<3>;

}  // namespace sinkmesh
