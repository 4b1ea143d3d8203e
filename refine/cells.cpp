// SPDX-License-Identifier: MIT
#include "refine/cells.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "predicates/error.h"
#include "refine/domain.h"

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
  struct Use {
    std::array<Vertex, Dim - 1> ridge;
    std::uint32_t facet;
    auto operator<=>(const Use&) const = default;
  };
  std::vector<Use> uses;
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    for (std::size_t k = 0; k < Dim; ++k) {
      Use use{{}, f};
      for (std::size_t j = 0; j + 1 < Dim; ++j) use.ridge[j] = facets[f][(k + j) % Dim];
      std::sort(use.ridge.begin(), use.ridge.end());
      uses.push_back(use);
    }
  }
  std::sort(uses.begin(), uses.end());

  std::vector<std::uint32_t> parent(facets.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t f) {
    while (parent[f] != f) f = parent[f] = parent[parent[f]];
    return f;
  };
  for (std::size_t i = 1; i < uses.size(); ++i) {
    if (uses[i].ridge == uses[i - 1].ridge) parent[root(uses[i].facet)] = root(uses[i - 1].facet);
  }
  std::vector<std::uint32_t> number(parent.size(), 0);
  for (std::uint32_t f = 0; f < parent.size(); ++f) {
    if (root(f) != f) continue;
    number[f] = static_cast<std::uint32_t>(is_even_.size());
    is_even_.push_back(true);
  }
  for (std::uint32_t f = 0; f < parent.size(); ++f) component_[f] = number[root(f)];
  for (std::size_t first = 0; first < uses.size();) {
    std::size_t last = first;
    while (last < uses.size() && uses[last].ridge == uses[first].ridge) ++last;
    if ((last - first) % 2 != 0) is_even_[component_[uses[first].facet]] = false;
    first = last;
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
