// SPDX-License-Identifier: MIT
//
// Dividing the boundary: for quality, and to bring every circumcenter inside [BR, 6].
//
// Points on the boundary go in one at a time, after the rounds of all schedules: they are few, and what
// follows from one is not local in advance.
#include <algorithm>
#include <cmath>

#include "core/mix.h"
#include "refine/refiner.h"
#include "refine/vector.h"

namespace sinkmesh {

// After a point on the boundary: the mesh is valid again when what it set off has come to its end.
template <int Dim>
void Refiner<Dim>::settle_boundary() {
  is_valid_ = conformer_->conform([this] { return may_continue(); }) && conformer_->unconformed().empty();
  if (!is_valid_) return;
  for (const Simplex s : conformer_->label_new()) inserter_.add(s);
}

// At first only where a point on the boundary is nearly as far from all vertices as the center for which it
// stands; that keeps the mesh small. What is left then has to be content with any that makes no edge shorter
// than the one that is to go.
//
// Points on the boundary may leave more simplices that a small angle excuses than they mend. On a surface that
// is conforming as given, fewer are excused then, until there are no more of low quality than a fixed boundary
// leaves.
template <int Dim>
void Refiner<Dim>::refine_boundary() {
  constexpr double kLeastLambda = Dim == 2 ? HUGE_VAL : 0.29;
  constexpr double kStep = 0.6;
  const bool is_given = may_excuse_fewer_ && on_segments_before_ + on_patches_before_ == 0;
  const std::size_t fixed = inserter_.num_low_quality();
  for (double lambda = conformer_->lambda();; lambda *= kStep) {
    last_valid_ = boundary_->snapshot();
    if (lambda != conformer_->lambda()) {
      is_bold_ = true;
      boundary_->forget_relaxed_radii();
      conformer_->set_lambda(lambda);
      inserter_.set_lambda(lambda);
    }
    for (const bool generous : {false, true}) {
      generous_ = generous;
      do {
        inserter_.reconsider_all();
        run_incremental(true);
      } while (!is_stopped() && (bring_centers_inside() || expel_flat_simplices()));
    }
    if (!is_given || inserter_.num_low_quality() <= fixed || lambda * kStep < kLeastLambda || is_stopped())
      return;
  }
}

template <int Dim>
bool Refiner<Dim>::divide_for(Simplex s) {
  const double relaxed2 = inserter_.relaxed_length2(s);
  if (options_.insert == Insert::sink &&
      visit_sinks(s, [&](Simplex sink) { return divide_for_center_of(sink, relaxed2); })) {
    return true;
  }
  return divide_for_center_of(s, relaxed2);
}

// The sub-facets that the center encroaches, the deepest first.
template <int Dim>
bool Refiner<Dim>::divide_for_center_of(Simplex s, double relaxed2) {
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
          {squared_distance(candidate.center, facet_center<Dim>(corners)) / facet_shape<Dim>(corners).radius2,
           tie, f});
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return a.depth2 != b.depth2 ? a.depth2 < b.depth2 : a.tie < b.tie;
    });
    if (entries.empty()) {
      // Perhaps it was refused because of what has been divided since.
      inserter_.reconsider(s);
      return insert_center_of(s);
    }
    constexpr double kStrict2 = 0.7;
    // In the plane: what a shell at a third of a segment leaves of the radius of a center that encroaches it.
    constexpr double kShell2 = 0.22;
    const double generous2 = Dim == 2 ? kShell2 * candidate.radius2 : relaxed2;
    const double least2 = generous_ ? generous2 : kStrict2 * candidate.radius2;
    for (const Entry& entry : entries) {
      if (!conformer_->split(entry.facet, least2, least2)) continue;
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

// No flow crosses the boundary, but in space a circumcenter may still lie beyond it. Where the way from a
// simplex to its center is barred, the sub-facet there is divided.
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
    if (!may_continue()) break;
    if (!conformer_->split(barrier.facet, 0, 0)) continue;
    settle_boundary();
    has_inserted = true;
  }
  return has_inserted;
}

// Whether the volume of a simplex is nothing but rounding, and its corners are not all given.
template <int Dim>
bool Refiner<Dim>::is_flat(Simplex s) const {
  constexpr double kFlat = 1e-9;  // volume to longest edge cubed
  const Complex<Dim>& complex = inserter_.complex();
  bool is_given = true;
  for (int i = 0; i <= Dim; ++i) {
    is_given = is_given && boundary_->features().vertex(complex.corner(s, i)).on.kind == Feature::Kind::corner;
  }
  return !is_given && flatness<Dim>(complex.corners(s)) < kFlat;
}

template <int Dim>
bool Refiner<Dim>::insert_center_of_circle(Simplex s) {
  const Complex<Dim>& complex = inserter_.complex();
  Point<Dim> center{};
  double largest2 = -1;
  for (int i = 0; i <= Dim; ++i) {
    const FacetCorners<Dim> corners = complex.facet_corners(Complex<Dim>::half_facet(s, i));
    const double area2 = facet_area2<Dim>(corners);
    if (area2 <= largest2) continue;
    largest2 = area2;
    center = facet_center<Dim>(corners);
  }
  Candidate<Dim> candidate = inserter_.describe(s);
  candidate.center = center;
  ++round_.candidates;
  if (inserter_.insert(candidate) == Verdict::inserted) return true;
  for (const HalfFacet h : inserter_.encroached_walls(candidate)) {
    if (!conformer_->split(boundary_->at(h), 0, 0)) continue;
    settle_boundary();
    return true;
  }
  return false;
}

// Each time one is moved out there is one less, or there is one more vertex.
template <int Dim>
bool Refiner<Dim>::expel_flat_simplices() {
  struct Entry {
    std::uint64_t tie;
    Simplex simplex;
    std::uint32_t birth;
  };
  std::vector<Entry> entries;
  for (const Simplex s : inserter_.domain().simplices()) {
    if (conformer_->is_on_one_patch(s) || is_flat(s))
      entries.push_back({inserter_.tie(s), s, inserter_.birth(s)});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.tie < b.tie; });
  bool has_changed = false;
  for (const Entry& entry : entries) {
    const Simplex s = entry.simplex;
    if (!inserter_.is_current(s, entry.birth)) continue;
    if (!may_continue()) break;
    if (conformer_->expel(s)) {
      settle_boundary();
      has_changed = true;
      continue;
    }
    // A trapezoid inside, of points that are placed alike. Its center is noise, but not that of its circle.
    has_changed = insert_center_of_circle(s) || has_changed;
  }
  return has_changed;
}

template class Refiner<2>;
template class Refiner<3>;

}  // namespace sinkmesh
