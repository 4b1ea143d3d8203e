// SPDX-License-Identifier: MIT
//
// Dividing the boundary: for quality, and to bring every circumcenter inside [BR, 6].
//
// Points on the boundary go in one at a time, between the rounds of all schedules: they are few, and what follows
// from one is not local in advance.
#include <algorithm>
#include <cmath>

#include "core/mix.h"
#include "refine/refiner.h"
#include "refine/vector.h"

namespace sinkmesh {

// After a point on the boundary: the cascade that it set off is not interrupted, because the mesh is not valid
// before its end.
template <int Dim>
void Refiner<Dim>::settle_boundary() {
  conformer_->conform([] { return true; });
  for (const Simplex s : conformer_->label_new()) inserter_.add(s);
}

// For the simplices that no interior point could mend, the worst first.
template <int Dim>
bool Refiner<Dim>::divide_for_quality() {
  struct Entry {
    double ratio2;
    std::uint64_t tie;
    Simplex simplex;
    std::uint32_t birth;
  };
  std::vector<Entry> entries;
  for (const Simplex s : inserter_.low_quality()) {
    if (inserter_.is_excused(s)) continue;
    entries.push_back(
        {shape<Dim>(inserter_.complex().corners(s)).ratio2(), inserter_.tie(s), s, inserter_.birth(s)});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.ratio2 != b.ratio2 ? a.ratio2 > b.ratio2 : a.tie < b.tie;
  });
  bool has_inserted = false;
  for (const Entry& entry : entries) {
    if (!may_continue()) return false;
    if (inserter_.is_current(entry.simplex, entry.birth) && divide_for(entry.simplex)) has_inserted = true;
  }
  return has_inserted;
}

template <int Dim>
bool Refiner<Dim>::divide_for(Simplex s) {
  if (options_.insert == Insert::sink &&
      visit_sinks(s, [this](Simplex sink) { return divide_for_center_of(sink); })) {
    return true;
  }
  return divide_for_center_of(s);
}

// The sub-facets that the center encroaches, the deepest first.
template <int Dim>
bool Refiner<Dim>::divide_for_center_of(Simplex s) {
  if (inserter_.is_hopeless(s)) return false;
  Candidate<Dim> candidate;
  if (inserter_.make_candidate(s, candidate)) {
    struct Entry {
      double depth2;
      std::uint64_t tie;
      SubFacet facet;
    };
    std::vector<Entry> entries;
    for (const HalfFacet h : inserter_.encroached_walls(candidate)) {
      const SubFacet f = boundary_->at(h);
      const FacetCorners<Dim> corners = boundary_->corner_points(f);
      std::uint64_t tie = 0;
      for (const Point<Dim>* p : corners) tie += hash_point<Dim>(*p);
      entries.push_back(
          {squared_distance(candidate.center, conformer_->center(f)) / facet_shape<Dim>(corners).radius2, tie,
           f});
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return a.depth2 != b.depth2 ? a.depth2 < b.depth2 : a.tie < b.tie;
    });
    if (entries.empty() && !inserter_.is_rejected(s)) return insert_center_of(s);
    for (const Entry& entry : entries) {
      if (!conformer_->split(entry.facet, candidate.radius2 / 2, candidate.radius2 / 4)) continue;
      settle_boundary();
      return true;
    }
  }
  inserter_.give_up(s);
  return false;
}

// The wall that bars the way from a simplex to its circumcenter, or null: a visibility walk, as in locate().
template <int Dim>
HalfFacet Refiner<Dim>::wall_before_center(Simplex s) {
  const Complex<Dim>& complex = inserter_.complex();
  const Predicates<Dim>& predicates = inserter_.triangulation().predicates();
  const Point<Dim> center = inserter_.center_or_direction(s);
  HalfFacet entry;
  for (Simplex at = s;;) {
    HalfFacet exit;
    for (int i = 0; i <= Dim && exit.is_null(); ++i) {
      const HalfFacet h = Complex<Dim>::half_facet(at, i);
      if (h == entry) continue;
      Corners<Dim> corners = complex.corners(at);
      corners[static_cast<std::size_t>(i)] = &center;
      if (predicates.orient(corners) < 0) exit = h;
    }
    if (exit.is_null() || inserter_.domain().is_wall(exit)) return exit;
    entry = complex.mate(exit);
    at = Complex<Dim>::simplex_of(entry);
  }
}

// No flow crosses the boundary, but in space a circumcenter may still lie beyond it. Where the way from a simplex to
// its center is barred, the sub-facet there is divided.
template <int Dim>
bool Refiner<Dim>::bring_centers_inside() {
  struct Barrier {
    std::uint64_t tie;
    SubFacet facet;
    std::uint32_t birth;
  };
  std::vector<Barrier> barriers;
  for (const Simplex s : inserter_.domain().simplices()) {
    if (flow_->is_sink(s)) continue;
    const HalfFacet wall = wall_before_center(s);
    if (wall.is_null()) continue;
    const SubFacet f = boundary_->at(wall);
    barriers.push_back({inserter_.tie(s), f, boundary_->sub_facets()[f].birth});
  }
  std::sort(barriers.begin(), barriers.end(), [](const Barrier& a, const Barrier& b) { return a.tie < b.tie; });
  bool has_inserted = false;
  for (const Barrier& barrier : barriers) {
    if (!boundary_->sub_facets().is_current(barrier.facet, barrier.birth)) continue;
    if (!conformer_->split(barrier.facet, 0, 0)) continue;
    settle_boundary();
    has_inserted = true;
  }
  return has_inserted;
}

template class Refiner<2>;
template class Refiner<3>;

}  // namespace sinkmesh
