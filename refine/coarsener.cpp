// SPDX-License-Identifier: MIT
#include "refine/coarsener.h"

#include <algorithm>
#include <utility>

#include "core/mix.h"

namespace sinkmesh {

template <int Dim>
Coarsener<Dim>::Coarsener(InteriorEditor<Dim>& editor, const RefineOptions& options, std::size_t num_vertices)
    : editor_(&editor),
      options_(options),
      budget_(options_),
      cost_of_(options.min_dihedral, options.max_ratio),
      num_vertices_(num_vertices) {}

template <int Dim>
CoarsenResult Coarsener<Dim>::run() {
  is_settled_.assign(editor_->complex().num_vertices(), false);
  while (remove_all()) {
  }
  result_.stop = budget_.stop();
  return result_;
}

template <int Dim>
bool Coarsener<Dim>::can_go(Vertex v) {
  using Cost = typename SliverCost<Dim>::Cost;
  const Complex<Dim>& complex = editor_->complex();
  Cost sum = 0;
  Cost worst = 0;
  for (const Simplex s : editor_->star(v)) {
    const Cost cost = cost_of_(complex.corners(s));
    sum += cost;
    worst = std::max(worst, cost);
  }
  worst = std::min(worst, SliverCost<Dim>::kLow - 1);
  const Simplex near = complex.incident_simplex(v);
  const auto filling = editor_->without(v);
  return !filling.empty() && std::all_of(filling.begin(), filling.end(), [&](const auto& vertices) {
    Corners<Dim> corners;
    for (std::size_t i = 0; i <= Dim; ++i) corners[i] = &complex.point(vertices[i]);
    const Cost cost = cost_of_(corners);
    sum -= cost;
    return cost <= worst && sum >= 0 && editor_->has_center_inside(corners, near);
  });
}

template <int Dim>
bool Coarsener<Dim>::remove_all() {
  const Complex<Dim>& complex = editor_->complex();
  std::vector<std::pair<std::uint64_t, Vertex>> order;
  for (std::uint32_t i = 0; i < is_settled_.size(); ++i) {
    const Vertex v(i);
    if (!is_settled_[i] && editor_->is_movable(v)) order.emplace_back(hash_point<Dim>(complex.point(v)), v);
  }
  std::sort(order.begin(), order.end());
  bool has_removed = false;
  for (const auto& [tie, v] : order) {
    if (!budget_.may_continue(num_vertices_, complex.bytes())) return false;
    ++result_.tried;
    is_settled_[v.index()] = !can_go(v);
    if (is_settled_[v.index()]) continue;
    for (const Simplex s : editor_->remove(v)) {
      for (int i = 0; i <= Dim; ++i) is_settled_[complex.corner(s, i).index()] = false;
    }
    --num_vertices_;
    ++result_.removed;
    has_removed = true;
  }
  return has_removed;
}

template class Coarsener<2>;
template class Coarsener<3>;

}  // namespace sinkmesh
