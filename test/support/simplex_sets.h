// SPDX-License-Identifier: MIT
//
// Triangulations as sets of simplices, for comparing them with each other and with the oracle.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/triangulation.h"
#include "test/support/brute_force.h"
#include "test/support/clouds.h"

namespace sinkmesh::test {

inline constexpr std::array kEngines{Engine::star, Engine::flips};

/// Corners by increasing id; infinity has the largest one.
template <int Dim>
IdSet<Dim + 1> ids_of(const Complex<Dim>& complex, Simplex s) {
  IdSet<Dim + 1> ids;
  for (int i = 0; i <= Dim; ++i) ids[static_cast<std::size_t>(i)] = complex.corner(s, i).index();
  std::sort(ids.begin(), ids.end());
  return ids;
}

/// All simplices, ghosts too, in lexicographic order: equal for equal complexes over the same ids.
template <int Dim>
std::vector<IdSet<Dim + 1>> simplex_sets(const Complex<Dim>& complex) {
  std::vector<IdSet<Dim + 1>> sets;
  for (const Simplex s : complex.simplices()) sets.push_back(ids_of(complex, s));
  std::sort(sets.begin(), sets.end());
  return sets;
}

/// Points with coordinates low .. low + side - 1; the sides differ by axis. Distinct, in random order.
template <int Dim>
std::vector<Point<Dim>> grid_cloud(std::size_t most, int low, int largest_side, Random& random) {
  std::array<int, Dim> side;
  for (int& s : side) s = uniform_int(random, 2, largest_side);
  std::vector<Point<Dim>> points(most);
  for (auto& p : points) {
    for (std::size_t k = 0; k < Dim; ++k) p[k] = uniform_int(random, low, low + side[k] - 1);
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

/// The points of {0 .. side-1}^Dim.
template <int Dim>
std::vector<Point<Dim>> full_grid(int side) {
  std::vector<Point<Dim>> points{{}};
  for (std::size_t k = 0; k < Dim; ++k) {
    std::vector<Point<Dim>> next;
    for (Point<Dim> p : points) {
      for (int x = 0; x < side; ++x) {
        p[k] = x;
        next.push_back(p);
      }
    }
    points = next;
  }
  return points;
}

/// No value if the points do not span the space.
template <int Dim>
std::optional<Triangulation<Dim>> triangulate(const std::vector<Point<Dim>>& points,
                                              Engine engine = Engine::star) {
  try {
    return Triangulation<Dim>(points, engine);
  } catch (const DegenerateInput&) {
    return std::nullopt;
  }
}

/// Whether points with small integer coordinates span the whole space.
template <int Dim>
bool spans_space(const std::vector<Point<Dim>>& points) {
  bool found = false;
  for_all_subsets<Dim + 1>(static_cast<std::uint32_t>(points.size()), [&](const IdSet<Dim + 1>& ids) {
    std::array<Point<Dim>, Dim + 1> p;
    for (std::size_t i = 0; i <= Dim; ++i) p[i] = points[ids[i]];
    found = found || integer_volume<Dim>(p) != 0;
  });
  return found;
}

/// The same points, those that form a simplex of nonzero volume first. Requires spans_space().
template <int Dim>
std::vector<Point<Dim>> with_basis_first(std::vector<Point<Dim>> points) {
  bool found = false;
  const auto original = points;
  for_all_subsets<Dim + 1>(static_cast<std::uint32_t>(points.size()), [&](const IdSet<Dim + 1>& ids) {
    if (found) return;
    std::array<Point<Dim>, Dim + 1> p;
    for (std::size_t i = 0; i <= Dim; ++i) p[i] = original[ids[i]];
    if (integer_volume<Dim>(p) == 0) return;
    found = true;
    for (std::size_t i = 0; i <= Dim; ++i) std::swap(points[i], points[ids[i]]);
  });
  return points;
}

}  // namespace sinkmesh::test
