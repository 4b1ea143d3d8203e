// SPDX-License-Identifier: MIT
//
// Dividing the boundary: for quality, and to bring every circumcenter inside [BR, 6].
//
// Points on the boundary go in one at a time, after the rounds of all schedules: they are few, and what
// follows from one is not local in advance.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/location.h"
#include "core/mix.h"
#include "core/vector.h"
#include "predicates/input_gate.h"
#include "refine/refiner.h"

namespace sinkmesh {

// After a point on the boundary: the mesh is valid again when what it set off has come to its end. Copying the
// boundary whenever there is a 32nd more costs as much as the points do, and no more than that is ever lost.
template <int Dim>
void Refiner<Dim>::settle_boundary() {
  constexpr std::size_t kPart = 32;
  constexpr std::size_t kFew = 256;
  is_valid_ = conformer_->conform([this] { return may_continue(); });
  if (!is_valid_) return;
  for (const Simplex s : conformer_->label_new()) inserter_.add(s);
  const std::size_t num_new = inserter_.complex().num_vertices() - last_valid_->num_vertices;
  if (!is_known_ && num_new > kFew + last_valid_->num_vertices / kPart) last_valid_ = boundary_->snapshot();
}

// First what has to be. Then points on the boundary for quality: in space, and on a surface that needs no point
// to conform, they may leave more simplices that a small angle excuses than they mend; and anywhere they may
// breed down to the floor. Then they are taken back: the mesh without them is complete, too.
template <int Dim>
void Refiner<Dim>::refine_boundary() {
  last_valid_ = boundary_->snapshot();
  generous_ = true;
  while (!is_stopped() && (bring_centers_inside() || expel_flat_simplices())) run_incremental(false);
  const std::size_t undivided = inserter_.num_low_quality();
  if (undivided == 0 || is_stopped()) return;
  const typename Boundary<Dim>::Snapshot state = boundary_->snapshot();
  classify_remaining(true);
  const auto leftovers = leftovers_;
  const auto remaining = result_.remaining;
  const bool is_as_given = on_segments_before_ + on_patches_before_ == 0;
  divide_boundary(is_as_given ? undivided : std::numeric_limits<std::size_t>::max());
  const bool is_comparable = Dim == 3 || is_as_given;
  if (budget_.stop() != Stop::no_candidate) return;
  if (is_valid_ && !(is_comparable && inserter_.num_low_quality() > undivided)) return;
  last_valid_ = state;
  leftovers_ = leftovers;
  result_.remaining = remaining;
  is_valid_ = false;
  is_known_ = true;
}

// At first only with points that are nearly as far from all vertices as the center for which they stand; that
// keeps the mesh small. What is left then has to be content with any that makes no edge shorter than the one
// that is to go. Fewer are excused then, until there are no more of low quality than is enough.
template <int Dim>
void Refiner<Dim>::divide_boundary(std::size_t enough) {
  // Of 17 degrees: further down spirals begin, in the plane at once.
  constexpr double kLeastLambda = Dim == 2 ? HUGE_VAL : 0.2956;
  constexpr double kStep = 0.6;
  for (double lambda = conformer_->lambda();; lambda = std::max(lambda * kStep, kLeastLambda)) {
    last_valid_ = boundary_->snapshot();
    if (lambda != conformer_->lambda()) {
      is_known_ = true;
      classify_remaining(false);
      boundary_->forget_relaxed_radii();
      conformer_->set_lambda(lambda);
      inserter_.set_lambda(lambda);
    }
    for (generous_ = false;; generous_ = true) {
      inserter_.reconsider_all();
      run_incremental(true);
      if (is_stopped() || (generous_ && !bring_centers_inside() && !expel_flat_simplices())) break;
    }
    if (inserter_.num_low_quality() <= enough || lambda <= kLeastLambda || is_stopped()) return;
  }
}

// How far, squared, a point for a simplex has to be from all vertices.
template <int Dim>
double Refiner<Dim>::least_distance2(double radius2, double relaxed2) const {
  constexpr double kStrict2 = 0.7;
  return generous_ ? relaxed2 : std::max(relaxed2, kStrict2 * radius2);
}

template <int Dim>
bool Refiner<Dim>::divide_for(Simplex s) {
  const double relaxed2 = inserter_.relaxed_length2(s);
  Candidate<Dim> center;
  const bool has_center = inserter_.make_center(s, center);
  if (has_center && insert_withdrawn(center, relaxed2)) return true;
  if (options_.insert != Insert::circumcenter && visit_owners(s, [&](Simplex owner) {
        Candidate<Dim> candidate;
        const bool is_center_of_s = owner == s && options_.insert == Insert::sink;  // its turn comes below
        if (is_center_of_s || inserter_.is_hopeless(owner)) return false;
        if (make_candidate(owner, false, candidate) && divide_for(candidate, relaxed2)) return true;
        if (owner != s) inserter_.give_up(owner);
        return false;
      })) {
    return true;
  }
  if (inserter_.is_hopeless(s)) return false;
  if (has_center && divide_for(center, relaxed2)) return true;
  inserter_.give_up(s);
  return false;
}

// The sub-facets that the point of a candidate encroaches, the deepest first.
template <int Dim>
auto Refiner<Dim>::encroached_sub_facets(const Candidate<Dim>& candidate) -> std::vector<Encroached> {
  std::vector<Encroached> result;
  for (const HalfFacet h : inserter_.encroached_walls(candidate)) {
    const SubFacet f = boundary_->at(h);
    const FacetCorners<Dim> corners = boundary_->corner_points(f);
    const Point<Dim> center = facet_center<Dim>(corners);
    const double radius2 = facet_shape<Dim>(corners).radius2;
    result.push_back(
        {squared_distance(candidate.point, center) / radius2, hash_points<Dim>(corners), f, center});
  }
  std::sort(result.begin(), result.end(), [](const Encroached& a, const Encroached& b) {
    return a.depth2 != b.depth2 ? a.depth2 < b.depth2 : a.tie < b.tie;
  });
  return result;
}

// Instead of the boundary, the point gives way: it moves straight out of the diametral sphere that it
// encroaches the deepest, then perhaps out of another. It stays inside, so no cascade follows from it; inside
// the sphere of s, or it would not be inserted; and no nearer to a vertex than a point on the boundary would
// be, so the proof of termination holds for it, too.
template <int Dim>
bool Refiner<Dim>::insert_withdrawn(Candidate<Dim> candidate, double relaxed2) {
  constexpr int kSteps = 4;
  constexpr double kOut = 1 + 0x1p-20;
  candidate.least2 = least_distance2(candidate.radius2, relaxed2);
  for (int step = 0; step < kSteps; ++step) {
    const std::vector<Encroached> encroached = encroached_sub_facets(candidate);
    if (encroached.empty() || encroached.front().depth2 == 0) return false;
    const Encroached& deepest = encroached.front();
    const double scale = kOut / std::sqrt(deepest.depth2);
    for (std::size_t k = 0; k < Dim; ++k) {
      candidate.point[k] = deepest.center[k] + scale * (candidate.point[k] - deepest.center[k]);
    }
    candidate.point = on_grid<Dim>(candidate.point);
    ++round_.candidates;
    if (inserter_.insert_other(candidate) == Verdict::inserted) return true;
  }
  return false;
}

template <int Dim>
bool Refiner<Dim>::divide_for(const Candidate<Dim>& candidate, double relaxed2) {
  const std::vector<Encroached> encroached = encroached_sub_facets(candidate);
  // Perhaps it was refused because of what has been divided since.
  if (encroached.empty()) {
    ++round_.candidates;
    return try_insert(candidate);
  }
  // In the plane: what a shell at a third of a segment leaves of the radius of a center that encroaches it.
  constexpr double kShell2 = 0.22;
  const double least2 = least_distance2(candidate.radius2, Dim == 2 ? kShell2 * candidate.radius2 : relaxed2);
  for (const Encroached& e : encroached) {
    if (!conformer_->split(e.facet, least2)) continue;
    settle_boundary();
    return true;
  }
  return false;
}

// The wall that bars the way from a simplex to its circumcenter, or null.
template <int Dim>
HalfFacet Refiner<Dim>::wall_before_center(Simplex s) {
  HalfFacet wall;
  visibility_walk(
      inserter_.complex(), inserter_.triangulation().predicates(), inserter_.center_or_direction(s), s,
      [](Simplex) { return false; },
      [&](HalfFacet h) {
        if (inserter_.domain().is_wall(h)) wall = h;
        return wall.is_null();
      });
  return wall;
}

template <int Dim>
std::size_t Refiner<Dim>::count_centers_beyond() {
  std::size_t count = 0;
  for (const Simplex s : inserter_.domain().simplices()) count += is_center_beyond(s) ? 1 : 0;
  return count;
}

// Calls mend(s) for the inside simplices with is_wanted(s), in an order that only the geometry decides, while
// they live. mend returns whether it has changed the mesh.
template <int Dim>
template <class IsWanted, class Mend>
bool Refiner<Dim>::mend_each(IsWanted&& is_wanted, Mend&& mend) {
  struct Entry {
    std::uint64_t tie;
    Simplex simplex;
    std::uint32_t birth;
  };
  std::vector<Entry> entries;
  for (const Simplex s : inserter_.domain().simplices()) {
    if (is_wanted(s)) entries.push_back({inserter_.tie(s), s, inserter_.birth(s)});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.tie < b.tie; });
  bool has_changed = false;
  for (const Entry& entry : entries) {
    if (!inserter_.is_current(entry.simplex, entry.birth)) continue;
    if (!may_continue()) break;
    has_changed = mend(entry.simplex) || has_changed;
  }
  return has_changed;
}

// No flow crosses the boundary, but in space a circumcenter may still lie beyond it. Where the way from a
// simplex to its center is barred, the sub-facet there is divided.
template <int Dim>
bool Refiner<Dim>::bring_centers_inside() {
  return mend_each([this](Simplex s) { return is_center_beyond(s); },
                   [this](Simplex s) {
                     const HalfFacet wall = wall_before_center(s);  // another one by now, or none
                     return !wall.is_null() && divide_at(wall);
                   });
}

template <int Dim>
bool Refiner<Dim>::divide_at(HalfFacet wall) {
  if (!conformer_->split(boundary_->at(wall), 0)) return false;
  settle_boundary();
  return true;
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

// The center of its sphere is noise, but not that of the circle of its largest facet.
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
  candidate.point = on_grid<Dim>(center);
  ++round_.candidates;
  if (inserter_.insert_other(candidate) == Verdict::inserted) return true;
  const std::vector<HalfFacet> walls = inserter_.encroached_walls(candidate);
  return std::any_of(walls.begin(), walls.end(), [this](HalfFacet wall) { return divide_at(wall); });
}

// Each time one is moved out there is one less, or there is one more vertex.
template <int Dim>
bool Refiner<Dim>::expel_flat_simplices() {
  return mend_each([this](Simplex s) { return is_to_expel(s); },
                   [this](Simplex s) {
                     // What cannot be expelled is a trapezoid inside, of points that are placed alike.
                     if (!conformer_->expel(s)) return insert_center_of_circle(s);
                     settle_boundary();
                     return true;
                   });
}

template class Refiner<2>;
template class Refiner<3>;

}  // namespace sinkmesh
