// SPDX-License-Identifier: MIT
#include "refine/sliver_mover.h"

#include <algorithm>
#include <utility>

#include "core/mix.h"
#include "refine/angles.h"
#include "refine/corner_order.h"
#include "refine/quality.h"

namespace sinkmesh {

template <int Dim>
SliverMover<Dim>::SliverMover(InteriorEditor<Dim>& editor, const RefineOptions& options,
                              std::size_t num_vertices)
    : editor_(&editor),
      options_(options),
      budget_(options_),
      cost_of_(options.min_dihedral, options.max_ratio),
      num_vertices_(num_vertices) {}

template <int Dim>
auto SliverMover<Dim>::cost(Simplex s) -> Cost {
  if (s.index() >= costs_.size()) costs_.resize(complex().records().capacity(), -1);
  Cost& cost = costs_[s.index()];
  if (cost < 0) cost = cost_of_(complex().corners(s));
  return cost;
}

template <int Dim>
auto SliverMover<Dim>::cost(const std::vector<Simplex>& simplices) -> Cost {
  Cost sum = 0;
  for (const Simplex s : simplices) sum += cost(s);
  return sum;
}

// Moving comes first: it makes the mesh smaller, and gives room for points that are added.
template <int Dim>
SliverResult SliverMover<Dim>::run() {
  const std::vector<Simplex> inside = editor_->domain().simplices();
  max_simplices_ = num_simplices_ = inside.size();
  result_.cost_before = cost(inside);
  for (const Simplex s : inside) {
    if (is_low(cost(s))) worst_ratio2_ = std::max(worst_ratio2_, shape<Dim>(complex().corners(s)).ratio2());
  }
  do {
    while (move_all()) {
    }
  } while (pick_all());
  result_.cost_after = cost(editor_->domain().simplices());
  result_.stop = budget_.stop();
  return result_;
}

// Each movable vertex of a sliver, with the cost of its star.
template <int Dim>
auto SliverMover<Dim>::vertices_of_slivers() -> std::vector<Entry> {
  std::vector<Entry> entries;
  std::vector<bool> met(complex().num_vertices(), false);
  for (const Simplex s : editor_->domain().simplices()) {
    if (!is_sliver(s)) continue;
    for (int i = 0; i <= Dim; ++i) {
      const Vertex v = complex().corner(s, i);
      if (met[v.index()]) continue;
      met[v.index()] = true;
      if (!editor_->is_movable(v)) continue;
      entries.push_back({cost(editor_->star(v)), hash_point<Dim>(complex().point(v)), v.index()});
    }
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

// Each returns whether another pass may do more.
template <int Dim>
bool SliverMover<Dim>::move_all() {
  ++pass_;
  bool is_promising = false;
  for (const Entry& entry : vertices_of_slivers()) {
    if (!may_continue()) return false;
    const Vertex v(entry.id);
    if (hash_point<Dim>(complex().point(v)) != entry.tie) continue;
    is_promising = move(v) || is_promising;
  }
  return is_promising;
}

template <int Dim>
bool SliverMover<Dim>::is_tolerable(Cost cost, const Corners<Dim>& corners) const {
  return !is_low(cost) || shape<Dim>(corners).ratio2() <= worst_ratio2_;
}

// Whether the mesh has no more simplices than at the beginning when the prestar has given way to a star.
template <int Dim>
bool SliverMover<Dim>::has_room() const {
  const Cavity<Dim>& cavity = editor_->cavity();
  return num_simplices_ + cavity.num_facets() <= max_simplices_ + cavity.num_simplices();
}

// Those that have spoilt other places come first: most places are bad for the same few reasons, and one is
// enough.
template <int Dim>
void SliverMover<Dim>::order_facets() {
  const Cavity<Dim>& cavity = editor_->cavity();
  facets_.resize(cavity.num_facets());
  std::size_t front = 0;
  for (std::size_t i = 0; i < facets_.size(); ++i) {
    facets_[i] = i;
    const bool is_obstacle =
        std::find(obstacles_.begin(), obstacles_.end(), cavity.facet(i).outer) != obstacles_.end();
    if (is_obstacle) std::swap(facets_[front++], facets_[i]);
  }
}

// The last one comes first.
template <int Dim>
void SliverMover<Dim>::remember_obstacle(std::uint32_t outer) {
  constexpr std::size_t kMost = 4;
  const auto known = std::find(obstacles_.begin(), obstacles_.end(), outer);
  if (known != obstacles_.end()) {
    std::rotate(obstacles_.begin(), known, known + 1);
    return;
  }
  if (obstacles_.size() == kMost) obstacles_.pop_back();
  obstacles_.insert(obstacles_.begin(), outer);
}

// While the prestar of x is found: whether inserting x is worth more than the best so far. `change` is what has
// changed already.
template <int Dim>
bool SliverMover<Dim>::is_better(const Point<Dim>& x, Cost change, Place& best) {
  const Cavity<Dim>& cavity = editor_->cavity();
  if (!has_room()) return false;
  for (std::size_t i = 0; i < cavity.num_simplices(); ++i) change -= cost(cavity.simplex(i));
  Cost star = 0;
  const auto corners_on = [&](std::size_t i) {
    const FacetCorners<Dim> facet = complex().facet_corners(HalfFacet(cavity.facet(i).inner));
    Corners<Dim> corners;
    corners[Dim] = &x;
    std::copy(facet.begin(), facet.end(), corners.begin());
    return corners;
  };
  order_facets();
  for (const std::size_t i : facets_) {
    const Cost cost = cost_of_(corners_on(i));
    star += cost;
    if (change + star < best.change && is_tolerable(cost, corners_on(i))) continue;
    if (cost >= SliverCost<Dim>::kSliver) remember_obstacle(cavity.facet(i).outer);
    return false;
  }
  change += star;
  for (const Simplex s : fresh_) {
    if (editor_->is_in_prestar(s)) continue;
    if (!is_tolerable(s) || !editor_->has_center_inside(complex().corners(s), s)) return false;
  }
  for (std::size_t i = 0; i < cavity.num_facets(); ++i) {
    const Simplex near = Complex<Dim>::simplex_of(HalfFacet(cavity.facet(i).inner));
    if (!editor_->has_center_inside(corners_on(i), near)) return false;
  }
  best = {x, change};
  return true;
}

template <int Dim>
void SliverMover<Dim>::put(const Place& place, Simplex near, Vertex v) {
  editor_->insert(place.point, near, v);
  const Cavity<Dim>& cavity = editor_->cavity();
  num_simplices_ += cavity.num_facets() - cavity.num_simplices();
  for (std::size_t i = 0; i < cavity.num_facets(); ++i) forget(cavity.star(i));
}

// Whether it is of no use to try v again: its star is as it was the last times.
template <int Dim>
bool SliverMover<Dim>::is_stuck(Vertex v, const std::vector<Simplex>& star) {
  std::uint64_t fingerprint = 0;
  for (const Simplex s : star) fingerprint += mix(hash_points<Dim>(complex().corners(s)));
  if (v.index() >= tries_.size()) tries_.resize(complex().num_vertices());
  Tries& tries = tries_[v.index()];
  if (std::exchange(tries.star, fingerprint) != fingerprint) tries.number = 0;
  return tries.are_enough();
}

// Twenty places are enough for nine vertices of ten [OS, 3]. Each time that v is tried again with the same star
// there are four times as many.
template <int Dim>
bool SliverMover<Dim>::move(Vertex v) {
  constexpr int kPlaces = 20;
  if (!editor_->is_movable(v)) return false;
  const std::vector<Simplex>& star = editor_->star(v);
  const bool has_sliver = std::any_of(star.begin(), star.end(), [this](Simplex s) { return is_sliver(s); });
  if (!has_sliver || is_stuck(v, star)) return false;

  ++result_.tried;
  const Cost before = cost(star);
  const auto& places = places_.around(complex(), star, v, pass_, kPlaces << (2 * tries_[v.index()].number));
  num_simplices_ -= star.size();
  Place best{complex().point(v), 0};
  fresh_ = editor_->remove(v);
  num_simplices_ += fresh_.size();
  for (const Simplex s : fresh_) forget(s);
  const Cost without = cost(fresh_) - before;
  const Simplex near = fresh_.front();
  obstacles_.clear();
  for (const Point<Dim>& x : places) {
    editor_->look(x, near, [&] { return is_better(x, without, best); });
  }
  const bool can_go = without <= best.change && num_simplices_ <= max_simplices_ &&
                      std::all_of(fresh_.begin(), fresh_.end(), [&](Simplex s) {
                        return is_tolerable(s) && editor_->has_center_inside(complex().corners(s), s);
                      });
  if (can_go) {
    ++result_.removed;
    --num_vertices_;
    return true;
  }
  put(best, near, v);
  if (best.change == 0) {
    Tries& tries = tries_[v.index()];
    ++tries.number;
    ++tries.total;
    return !tries.are_enough();
  }
  ++result_.moved;
  return true;
}

template <int Dim>
auto SliverMover<Dim>::all_slivers() -> std::vector<Entry> {
  std::vector<Entry> entries;
  for (const Simplex s : editor_->domain().simplices()) {
    if (is_sliver(s)) entries.push_back({cost(s), hash_points<Dim>(complex().corners(s)), s.index()});
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

template <int Dim>
bool SliverMover<Dim>::pick_all() {
  ++pass_;
  bool has_picked = false;
  for (const Entry& entry : all_slivers()) {
    if (!may_continue()) return false;
    const Simplex s(entry.id);
    const bool is_current = complex().is_solid(s) && editor_->domain().is_inside(s) &&
                            hash_points<Dim>(complex().corners(s)) == entry.tie;
    if (is_current) has_picked = pick(s) || has_picked;
  }
  return has_picked;
}

template <int Dim>
bool SliverMover<Dim>::pick(Simplex s) {
  constexpr int kPlaces = 60;                 // most are refused near the boundary
  Place best{{}, -SliverCost<Dim>::kSliver};  // less is not worth a point
  obstacles_.clear();
  fresh_.clear();
  bool found = false;
  for (const Point<Dim>& x : places_.in_sphere(complex().corners(s), pass_, kPlaces)) {
    found = editor_->look(x, s, [&] { return is_better(x, 0, best); }) || found;
  }
  if (!found) return false;
  put(best, s, Vertex());
  ++num_vertices_;
  ++result_.inserted;
  return true;
}

template <int Dim>
std::vector<Sliver<Dim>> SliverMover<Dim>::slivers() {
  std::vector<std::pair<std::uint64_t, Sliver<Dim>>> found;
  for (const Simplex s : editor_->domain().simplices()) {
    Corners<Dim> corners = complex().corners(s);
    const std::uint64_t tie = hash_points<Dim>(corners);
    sort_corners(corners);
    Sliver<Dim> sliver;
    sliver.angle = angles<Dim>(corners).min;
    if (!(sliver.angle < options_.min_dihedral)) continue;
    bool is_movable = false;
    for (int i = 0; i <= Dim; ++i) {
      const Vertex v = complex().corner(s, i);
      sliver.corners[static_cast<std::size_t>(i)] = v.index();
      is_movable = is_movable || editor_->is_movable(v);
    }
    if (!is_movable) {
      sliver.reason = SliverReason::boundary_vertices;
    } else if (result_.stop == Stop::no_candidate) {
      sliver.reason = SliverReason::no_better_place;
    }
    found.emplace_back(tie, sliver);
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return a.second.angle != b.second.angle ? a.second.angle < b.second.angle : a.first < b.first;
  });
  std::vector<Sliver<Dim>> result;
  for (const auto& [tie, sliver] : found) result.push_back(sliver);
  return result;
}

const char* name(SliverReason reason) {
  switch (reason) {
    case SliverReason::untried:
      return "untried";
    case SliverReason::boundary_vertices:
      return "boundary_vertices";
    case SliverReason::no_better_place:
      return "no_better_place";
  }
  return "";
}

template class SliverMover<2>;
template class SliverMover<3>;

}  // namespace sinkmesh
