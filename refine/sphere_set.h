// SPDX-License-Identifier: MIT
//
// The spheres of a block: is a new one orthogonal to all, or further [EG01, 4.4]?
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "predicates/staged.h"

namespace sinkmesh {

/// Circumspheres of simplices, kept by their corners, so that they outlive them: between two of these the test
/// is exact. Other spheres are given by their rounded centers and radii. A grid for each binade of radii only
/// narrows down which spheres are tested.
template <int Dim>
class SphereSet {
 public:
  explicit SphereSet(const Predicates<Dim>& predicates) : predicates_(&predicates) {}

  struct Sphere {
    Point<Dim> center;  ///< rounded, in [-2, 2]^Dim
    double radius2;     ///< rounded
    std::optional<std::array<Point<Dim>, Dim + 1>> corners = {};
  };

  /// Whether the sphere is orthogonal to or further from every sphere in the set.
  /// Cost: constant for each binade of radii if no sphere in the set is much smaller, as when they are added by
  /// decreasing radius; at worst linear.
  bool is_orthogonal_to_all(const Sphere& sphere) const;
  void add(const Sphere& sphere);

 private:
  using Cell = std::array<std::int64_t, Dim>;
  struct CellHash {
    std::size_t operator()(const Cell& cell) const;
  };
  struct Level {
    int exponent;  // of the radii: in [2^(exponent-1), 2^exponent), which is also the size of a cell
    std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells;
  };

  bool is_orthogonal(const Sphere& a, const Sphere& b) const;

  const Predicates<Dim>* predicates_;
  std::vector<Sphere> spheres_;
  std::vector<Level> levels_;
};

}  // namespace sinkmesh
