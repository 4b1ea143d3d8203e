// SPDX-License-Identifier: MIT
//
// The cells into which walls divide a triangulation, and which of them are inside.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/complex.h"

namespace sinkmesh {

template <int Dim>
class Domain;

/// The classes of simplices that are connected without crossing a wall. Cell 0 is the unbounded one: it has all
/// ghosts, which are connected, because no wall ends at infinity.
template <int Dim>
class Cells {
 public:
  static constexpr std::uint32_t kUnbounded = 0;

  /// Linear.
  Cells(const Complex<Dim>& complex, const Domain<Dim>& walls);

  std::uint32_t of(Simplex s) const { return cell_[s.index()]; }
  std::size_t size() const { return size_; }
  /// By index of a simplex; slots without a simplex are in cell 0.
  const std::vector<std::uint32_t>& all() const { return cell_; }

 private:
  std::vector<std::uint32_t> cell_;
  std::uint32_t size_ = 0;
};

/// Facets of a surface that are connected through ridges (edges in space, vertices in the plane).
template <int Dim>
class SurfaceComponents {
 public:
  /// Log-linear.
  explicit SurfaceComponents(std::span<const std::array<Vertex, Dim>> facets);

  std::uint32_t of(std::uint32_t facet) const { return component_[facet]; }
  /// By component: whether each of its ridges has an even number of facets.
  const std::vector<bool>& is_even() const { return is_even_; }

 private:
  std::vector<std::uint32_t> component_;
  std::vector<bool> is_even_;
};

/// Cells, and the walls between them.
class CellGraph {
 public:
  explicit CellGraph(std::size_t num_cells) : walls_(num_cells) {}

  void add(std::uint32_t cell, std::uint32_t other, std::uint32_t component) {
    if (cell == other) return;  // a membrane
    walls_[cell].push_back({other, component});
    walls_[other].push_back({cell, component});
  }

  /// Whether each cell is inside: Domain::label().
  /// @throws InputError if labels contradict each other.
  std::vector<bool> label(const std::vector<bool>& component_is_even) const;

 private:
  struct Way {
    std::uint32_t cell;  // on the other side
    std::uint32_t component;
  };
  std::vector<std::vector<Way>> walls_;  // by cell
};

}  // namespace sinkmesh
