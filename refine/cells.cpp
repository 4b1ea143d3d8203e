// SPDX-License-Identifier: MIT
#include "refine/cells.h"

#include <algorithm>
#include <array>

#include "predicates/error.h"
#include "refine/domain.h"
#include "refine/ridge_uses.h"
#include "refine/union_find.h"

namespace sinkmesh {

template <int Dim>
Cells<Dim>::Cells(const Complex<Dim>& complex, const Domain<Dim>& walls) {
  constexpr std::uint32_t kNone = ~std::uint32_t{0};
  cell_.assign(complex.num_slots(), kNone);
  std::vector<Simplex> stack;
  const auto enter = [&](Simplex s, std::uint32_t cell) {
    if (cell_[s.index()] != kNone) return;
    cell_[s.index()] = cell;
    stack.push_back(s);
  };
  const auto flood = [&] {
    while (!stack.empty()) {
      const Simplex s = stack.back();
      stack.pop_back();
      for (int i = 0; i <= Dim; ++i) {
        if (!walls.is_wall(Complex<Dim>::half_facet(s, i))) enter(complex.neighbor(s, i), cell_[s.index()]);
      }
    }
  };
  for (const Simplex s : complex.simplices()) {
    if (complex.is_ghost(s)) enter(s, kUnbounded);
  }
  flood();
  size_ = 1;
  for (const Simplex s : complex.simplices()) {
    if (cell_[s.index()] != kNone) continue;
    enter(s, size_++);
    flood();
  }
  std::replace(cell_.begin(), cell_.end(), kNone, kUnbounded);
}

template <int Dim>
SurfaceComponents<Dim>::SurfaceComponents(std::span<const std::array<Vertex, Dim>> facets)
    : component_(facets.size()) {
  const auto corners_of = [&](std::size_t f) -> const std::array<Vertex, Dim>& { return facets[f]; };
  UnionFind connected(facets.size());
  std::vector<bool> is_odd_at(facets.size(), false);  // at some ridge of the facet
  for_each_ridge<Dim>(facets.size(), corners_of, [&](auto first, auto last) {
    for (auto use = first; use != last; ++use) connected.unite(first->facet, use->facet);
    if ((last - first) % 2 != 0) is_odd_at[first->facet] = true;
  });
  // A class is met first at its smallest member.
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    const std::size_t root = connected.find(f);
    if (root == f) {
      component_[f] = static_cast<std::uint32_t>(is_even_.size());
      is_even_.push_back(true);
    }
    component_[f] = component_[root];
    if (is_odd_at[f]) is_even_[component_[f]] = false;
  }
}

// Breadth first, so that a component is met from its own outside first: every way from there to what it
// encloses crosses it.
std::vector<bool> CellGraph::label(const std::vector<bool>& component_is_even) const {
  constexpr std::uint32_t kNone = ~std::uint32_t{0};
  std::vector<std::uint32_t> outside_of(component_is_even.size(), kNone);
  std::vector<bool> inside(walls_.size(), false);
  std::vector<bool> is_known(walls_.size(), false);
  std::vector<std::uint32_t> queue = {0};
  is_known[0] = true;
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const std::uint32_t cell = queue[head];
    for (const Way& way : walls_[cell]) {
      std::uint32_t& outside = outside_of[way.component];
      if (outside == kNone) outside = cell;
      const bool label =
          component_is_even[way.component] ? !inside[cell] : inside[outside] != (way.cell != outside);
      if (!is_known[way.cell]) {
        is_known[way.cell] = true;
        inside[way.cell] = label;
        queue.push_back(way.cell);
      } else if (inside[way.cell] != label) {
        throw InputError(
            "the surface does not separate inside from outside: it is not closed, or crosses itself");
      }
    }
  }
  return inside;
}

template class Cells<2>;
template class Cells<3>;
template class SurfaceComponents<2>;
template class SurfaceComponents<3>;

}  // namespace sinkmesh
