// SPDX-License-Identifier: MIT
//
// Solids made of unit cubes (squares in the plane) of a grid, whose surfaces are facets of the triangulation of
// the grid: the perturbed triangulation divides each cube by itself, so that a cube is a union of simplices.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/triangulation.h"
#include "test/support/clouds.h"
#include "test/support/point_sets.h"

namespace sinkmesh::test {

/// n cubes along each axis, each with a material; 0 at the border of the grid.
template <int Dim>
class Voxels {
 public:
  using Facet = std::array<Vertex, Dim>;

  explicit Voxels(int n)
      : n_(n),
        material_(static_cast<std::size_t>(std::pow(n, Dim)), 0),
        triangulation_(grid_points<Dim>(n + 1)) {}

  const Triangulation<Dim>& triangulation() const { return triangulation_; }
  int size() const { return n_; }
  std::size_t num_voxels() const { return material_.size(); }
  int& material(std::size_t voxel) { return material_[voxel]; }
  int material(std::size_t voxel) const { return material_[voxel]; }

  std::size_t voxel_at(const Point<Dim>& p) const {
    std::size_t voxel = 0;
    for (const double x : p) voxel = voxel * static_cast<std::size_t>(n_) + static_cast<std::size_t>(x);
    return voxel;
  }
  /// The least corner of a voxel.
  Point<Dim> corner(std::size_t voxel) const {
    Point<Dim> p;
    for (std::size_t k = Dim; k-- > 0; voxel /= static_cast<std::size_t>(n_)) {
      p[k] = static_cast<double>(voxel % static_cast<std::size_t>(n_));
    }
    return p;
  }
  Point<Dim> middle(std::size_t voxel) const {
    Point<Dim> p = corner(voxel);
    for (double& x : p) x += 0.4;
    return p;
  }
  bool is_at_border(std::size_t voxel) const {
    const Point<Dim> p = corner(voxel);
    return std::any_of(p.begin(), p.end(), [this](double x) { return x == 0 || x == n_ - 1; });
  }
  /// Everything in [low, high) gets a material.
  void fill(const Point<Dim>& low, const Point<Dim>& high, int material) {
    for (std::size_t v = 0; v < material_.size(); ++v) {
      const Point<Dim> p = corner(v);
      bool is_in = true;
      for (std::size_t k = 0; k < Dim; ++k) is_in = is_in && p[k] >= low[k] && p[k] < high[k];
      if (is_in) material_[v] = material;
    }
  }
  /// Materials 0 .. largest at random, where it is not the border.
  void fill_at_random(int largest, Random& random) {
    for (std::size_t v = 0; v < material_.size(); ++v) {
      material_[v] = is_at_border(v) ? 0 : uniform_int(random, 0, largest);
    }
  }

  /// Of a solid simplex.
  std::size_t voxel_of(Simplex s) const {
    Point<Dim> center{};
    for (int i = 0; i <= Dim; ++i) {
      const Point<Dim> p = triangulation_.point(triangulation_.complex().corner(s, i));
      for (std::size_t k = 0; k < Dim; ++k) center[k] += p[k] / (Dim + 1);
    }
    return voxel_at(center);
  }
  /// 0 for ghosts.
  int material_of(Simplex s) const { return triangulation_.complex().is_ghost(s) ? 0 : material_[voxel_of(s)]; }

  /// The facets between different materials, each once, as half-facets.
  std::vector<HalfFacet> interfaces() const {
    const Complex<Dim>& complex = triangulation_.complex();
    std::vector<HalfFacet> result;
    for (const Simplex s : complex.simplices()) {
      for (int i = 0; i <= Dim; ++i) {
        const Simplex t = complex.neighbor(s, i);
        if (s < t && material_of(s) != material_of(t)) result.push_back(Complex<Dim>::half_facet(s, i));
      }
    }
    return result;
  }
  std::vector<Facet> facets(const std::vector<HalfFacet>& half_facets) const {
    std::vector<Facet> result;
    for (const HalfFacet h : half_facets) result.push_back(triangulation_.complex().facet(h));
    return result;
  }

  /// By voxel: the number of its component of equal material, connected through sides; counted from 0 in the
  /// order of their first voxels.
  std::vector<std::uint32_t> components() const {
    std::vector<std::uint32_t> parent(material_.size());
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&](std::uint32_t v) {
      while (parent[v] != v) v = parent[v];
      return v;
    };
    std::uint32_t stride = 1;
    for (std::size_t k = Dim; k-- > 0; stride *= static_cast<std::uint32_t>(n_)) {
      for (std::uint32_t v = 0; v < material_.size(); ++v) {
        if (corner(v)[k] + 1 >= n_ || material_[v] != material_[v + stride]) continue;
        const std::uint32_t a = root(v);
        const std::uint32_t b = root(v + stride);
        parent[std::max(a, b)] = std::min(a, b);
      }
    }
    std::vector<std::uint32_t> number(material_.size());
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < material_.size(); ++v) number[v] = root(v) == v ? count++ : number[root(v)];
    return number;
  }

 private:
  int n_;
  std::vector<int> material_;
  Triangulation<Dim> triangulation_;
};

}  // namespace sinkmesh::test
