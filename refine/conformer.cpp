// SPDX-License-Identifier: MIT
#include "refine/conformer.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/mix.h"
#include "core/vector.h"
#include "predicates/input_gate.h"
#include "refine/quality.h"

namespace sinkmesh {
namespace {

using Kind = Feature::Kind;

template <int Dim>
constexpr typename Domain<Dim>::Region kUnknown = ~typename Domain<Dim>::Region{0};

template <int Dim>
bool is_reachable(const Point<Dim>& p) {
  // Far beyond the gate a point only tells a direction; NaN and infinity do not even that.
  return std::all_of(p.begin(), p.end(), [](double x) { return std::abs(x) < 0x1p20; });
}

}  // namespace

template <int Dim>
Conformer<Dim>::Conformer(Triangulation<Dim>& triangulation, Domain<Dim>& domain, Flow<Dim>& flow,
                          Boundary<Dim>& boundary, const Collars& collars, double lambda, double floor,
                          bool projects)
    : triangulation_(&triangulation),
      domain_(&domain),
      flow_(&flow),
      boundary_(&boundary),
      collars_(&collars),
      lambda_(lambda),
      floor2_(floor * floor),
      projects_(projects) {}

template <int Dim>
void Conformer<Dim>::start() {
  if constexpr (Dim == 3) PatchTriangulation(*boundary_).flip_all();
  boundary_->sub_facets().for_each([this](SubFacet f) { enqueue(f); });
  divide_at_collars();
}

template <int Dim>
auto Conformer<Dim>::entry_of(const SubSegment& s) const -> SegmentEntry {
  const Point<Dim>& u = complex().point(s.u);
  const Point<Dim>& v = complex().point(s.v);
  return {squared_distance(u, v), hash_points<Dim>(std::array{&u, &v}), s};
}

template <int Dim>
void Conformer<Dim>::enqueue(SubFacet f) {
  if (boundary_->is_missing(f)) {
    if constexpr (Dim == 3) {  // in the plane they are the sub-facets
      for (const SubSegment& s : boundary_->sub_segments(f)) segment_queue_.push(entry_of(s));
    }
  } else if (boundary_->encroaching_apexes(f).empty()) {
    return;
  }
  facet_queue_.push(entry_of(f));
}

template <int Dim>
auto Conformer<Dim>::entry_of(SubFacet f) const -> Entry {
  const FacetCorners<Dim> corners = boundary_->corner_points(f);
  return {facet_shape<Dim>(corners).radius2, hash_points<Dim>(corners), f, boundary_->sub_facets()[f].birth};
}

template <int Dim>
void Conformer<Dim>::enqueue_created() {
  for (const SubFacet f : created_) {
    if (boundary_->sub_facets().is_alive(f)) enqueue(f);
  }
  created_.clear();
}

template <int Dim>
bool Conformer<Dim>::conform(const std::function<bool()>& may_continue) {
  while (given_up_.empty()) {
    if (!segment_queue_.empty()) {
      const SegmentEntry entry = segment_queue_.top();
      const SubSegment s = entry.segment;
      segment_queue_.pop();
      if (boundary_->sub_facets().segment_of(s.u, s.v) != s.segment || boundary_->has_edge(s.u, s.v)) continue;
      if (!may_continue()) {
        segment_queue_.push(entry);
        return false;
      }
      mend(s);
    } else if (!facet_queue_.empty()) {
      const Entry entry = facet_queue_.top();
      facet_queue_.pop();
      if (!boundary_->sub_facets().is_current(entry.facet, entry.birth)) continue;
      if (!boundary_->is_missing(entry.facet) && boundary_->encroaching_apexes(entry.facet).empty()) continue;
      if (!may_continue()) {
        facet_queue_.push(entry);
        return false;
      }
      mend(entry.facet);
    } else {
      return true;
    }
  }
  return false;
}

// ------------------------------------------------------------------------------------------------
//  What is wrong, and what to do about it.

template <int Dim>
void Conformer<Dim>::mend(const SubSegment& s) {
  const auto& features = boundary_->features();
  const double t = (features.position(s.u, s.segment) + features.position(s.v, s.segment)) / 2;
  const Vertex nearest = boundary_->star_walk().nearest(complex(), features.point_at(s.segment, t), s.u);
  if (split_segment(s, nearest == s.u || nearest == s.v ? Vertex() : nearest, 0)) return;
  for (const auto& side : boundary_->sub_facets().around(s.u, s.v)) {
    given_up_.push_back(side.facet);
  }
}

template <int Dim>
void Conformer<Dim>::mend(SubFacet f) {
  const std::uint32_t birth = boundary_->sub_facets()[f].birth;
  if constexpr (Dim == 3) {
    if (boundary_->is_missing(f)) {
      for (const SubSegment& s : boundary_->sub_segments(f)) {
        if (!boundary_->has_edge(s.u, s.v)) {
          mend(s);
          return;
        }
      }
      PatchTriangulation(*boundary_).flip_around(f, created_);
      enqueue_created();
      if (!boundary_->sub_facets().is_current(f, birth)) return;
    }
  }
  const Vertex q = culprit(f);
  if ((!q.is_null() && insert_alike(f, q)) || split_at_center(f, q, 0)) {
    if (boundary_->sub_facets().is_current(f, birth)) enqueue(f);
  } else {
    given_up_.push_back(f);
  }
}

// The vertex that is to blame: of those strictly inside the diametral sphere the one nearest to its center.
// Null if there is none.
template <int Dim>
Vertex Conformer<Dim>::culprit(SubFacet f) {
  const Point<Dim> center = facet_center<Dim>(boundary_->corner_points(f));
  if (!is_reachable<Dim>(center)) return {};
  const auto& corners = boundary_->sub_facets()[f].corners;
  if (boundary_->is_missing(f)) {
    const Vertex nearest = boundary_->star_walk().nearest(complex(), center, corners[0]);
    return std::find(corners.begin(), corners.end(), nearest) == corners.end() ? nearest : Vertex();
  }
  Vertex best;
  for (const Vertex v : boundary_->encroaching_apexes(f)) {
    const auto key = [&](Vertex w) {
      return std::pair(squared_distance(complex().point(w), center), complex().point(w));
    };
    if (best.is_null() || key(v) < key(best)) best = v;
  }
  return best;
}

// ------------------------------------------------------------------------------------------------
//  Insertions.

// Against a culprit that was itself inserted because of another one: a point that is placed as it is.
template <int Dim>
bool Conformer<Dim>::insert_alike(SubFacet f, Vertex q) {
  if constexpr (Dim == 2) {
    return false;
  } else {
    if (boundary_->features().vertex(q).level == 0) return false;
    const Plane& plane = boundary_->features().patches()[boundary_->sub_facets()[f].owner].plane;
    const double radius2 = facet_shape<3>(boundary_->corner_points(f)).radius2;
    constexpr double kCloseness2 = 1e-6;
    for (const std::optional<Point3>& image : {mirror_image(f, q), sphere_point(f, q)}) {
      if (!image || !is_reachable<3>(*image)) continue;
      const Point2 projected = on_grid<2>(plane.project(*image));
      const auto at = PatchTriangulation(*boundary_).walk(f, projected);
      if (!at || at->barrier) continue;
      const Point3 x = plane.lift(projected);
      triangulation_->announce(x);
      if (triangulation_->predicates().diametral_side(boundary_->corner_points(f), x) >= 0) continue;
      if (is_inside_collar(boundary_->sub_facets()[f].owner, x)) continue;
      if (distance2_of_segments(*at, x) < kCloseness2 * radius2) continue;
      if (insert_on_patch(*at, x, q, kCloseness2 * radius2)) return true;
    }
    return false;
  }
}

// At the circumcenter of the sub-facet, unless a sub-segment lies between or would be too near, or it would be
// inside a collar or destroy what is there: then an arc is divided.
template <int Dim>
bool Conformer<Dim>::split_at_center(SubFacet f, Vertex q, double distance2) {
  if constexpr (Dim == 2) {
    return split_segment(boundary_->sub_segments(f).front(), q, distance2);
  } else {
    if (const auto corner = collared_corner(f)) return split_arc(f, *corner, q, distance2);
    const Point3 center = facet_center<Dim>(boundary_->corner_points(f));
    if (!is_reachable<3>(center)) return false;
    const Plane& plane = boundary_->features().patches()[boundary_->sub_facets()[f].owner].plane;
    const Point2 projected = on_grid<2>(plane.project(center));
    const auto at = PatchTriangulation(*boundary_).walk(f, projected);
    if (!at) return false;
    if (const auto corner = collared_corner(at->facet)) return split_arc(at->facet, *corner, q, distance2);
    if (at->barrier) return split_segment(*at->barrier, q, distance2);
    const Point3 x = plane.lift(projected);
    triangulation_->announce(x);
    std::vector<SubFacet> destroyed = destroyed_by(*at, x);
    sort_by_size(destroyed);
    for (const SubFacet other : destroyed) {
      if (const auto corner = collared_corner(other)) return split_arc(other, *corner, q, distance2);
    }
    if (const auto segment = encroached_segment(destroyed, x)) return split_segment(*segment, q, distance2);
    return insert_on_patch(*at, x, q, distance2);
  }
}

// The sub-facets of the patch that a point on it would destroy.
template <int Dim>
std::vector<SubFacet> Conformer<Dim>::destroyed_by(const PatchTriangulation::Location& at,
                                                   const Point<Dim>& x) const {
  std::vector<SubFacet> found = {at.facet};
  if constexpr (Dim == 3) {
    for (std::size_t head = 0; head < found.size(); ++head) {
      const SubFacet f = found[head];
      for (std::size_t k = 0; k < 3; ++k) {
        if (boundary_->sub_facets()[f].segment[k] != SubFacets<3>::kNone) continue;
        const SubFacet next = boundary_->sub_facets().across(f, k).facet;
        // A patch that is joined across more than rounding may be folded; then an edge of it may have no other
        // side.
        if (next.is_null() || std::find(found.begin(), found.end(), next) != found.end()) continue;
        if (triangulation_->predicates().diametral_side(boundary_->corner_points(next), x) < 0) {
          found.push_back(next);
        }
      }
    }
  }
  return found;
}

// Of those at sub-facets of the patch that x would destroy: next to one that x is not on, it could not be
// divided.
template <int Dim>
double Conformer<Dim>::distance2_of_segments(const PatchTriangulation::Location& at,
                                             const Point<Dim>& x) const {
  double least2 = HUGE_VAL;
  for (const SubFacet f : destroyed_by(at, x)) {
    for (const SubSegment& s : boundary_->sub_segments(f)) {
      least2 = std::min(least2, boundary_->features().distance2(x, {Kind::segment, s.segment}));
    }
  }
  return least2;
}

// The largest first.
template <int Dim>
void Conformer<Dim>::sort_by_size(std::vector<SubFacet>& facets) const {
  std::sort(facets.begin(), facets.end(), [this](SubFacet f, SubFacet g) { return entry_of(g) < entry_of(f); });
}

// The longest sub-segment with x inside its diametral sphere, among those at the sub-facets of the patch that x
// would destroy.
template <int Dim>
std::optional<SubSegment> Conformer<Dim>::encroached_segment(const std::vector<SubFacet>& destroyed,
                                                             const Point<Dim>& x) const {
  std::optional<SegmentEntry> longest;
  for (const SubFacet f : destroyed) {
    for (const SubSegment& s : boundary_->sub_segments(f)) {
      if (dot(complex().point(s.u) - x, complex().point(s.v) - x) >= 0) continue;
      if (!longest || *longest < entry_of(s)) longest = entry_of(s);
    }
  }
  return longest ? std::optional(longest->segment) : std::nullopt;
}

template <int Dim>
bool Conformer<Dim>::split_arc(SubFacet f, Vertex corner, Vertex q, double distance2) {
  if constexpr (Dim == 2) {
    return false;
  } else {
    const Plane& plane = boundary_->features().patches()[boundary_->sub_facets()[f].owner].plane;
    const Point2 projected = on_grid<2>(plane.project(point_on_arc(f, corner)));
    const auto at = PatchTriangulation(*boundary_).walk(f, projected);
    return at && !at->barrier && insert_on_patch(*at, plane.lift(projected), q, distance2);
  }
}

// ------------------------------------------------------------------------------------------------
//  Points into the complex.

template <int Dim>
bool Conformer<Dim>::insert_on_patch(const PatchTriangulation::Location& at, const Point<Dim>& x, Vertex q,
                                     double distance2) {
  if constexpr (Dim == 3) {
    const auto& record = boundary_->sub_facets()[at.facet];
    const Vertex v = insert(x, complex().incident_simplex(record.corners[0]), distance2);
    if (v.is_null()) return false;
    settle(v, {Kind::patch, record.owner}, 0, q);
    ++points_on_patches_;
    PatchTriangulation(*boundary_).divide(at.facet, at.side, v, created_);
    enqueue_created();
  }
  return true;
}

template <int Dim>
bool Conformer<Dim>::split_segment(const SubSegment& s, Vertex q, double distance2) {
  return insert_on_segment(s, split_position(s, q), q, distance2);
}

template <int Dim>
bool Conformer<Dim>::insert_on_segment(const SubSegment& s, double t, Vertex q, double distance2) {
  const Point<Dim> x = boundary_->features().point_at(s.segment, t);
  const Vertex v = insert(x, complex().incident_simplex(s.u), distance2);
  if (v.is_null()) return false;
  settle(v, {Kind::segment, s.segment}, t, q);
  ++points_on_segments_;
  if constexpr (Dim == 3) {
    PatchTriangulation(*boundary_).divide(s, v, created_);
  } else {
    boundary_->divide_edge(s.u, s.v, v, created_);
  }
  enqueue_created();
  return true;
}

// Into the triangulation, whatever is there. Null if a vertex would be nearer than it may.
template <int Dim>
Vertex Conformer<Dim>::insert(const Point<Dim>& x, Simplex hint, double distance2) {
  triangulation_->announce(x);
  const Location<Dim> at = triangulation_->locate(x, hint);
  if (at.is_at_corner()) return {};
  triangulation_->grow_prestar(cavity_, x, at.simplex);
  // All vertices of the closure of a prestar are on its border.
  nearest2_ = HUGE_VAL;
  for (std::size_t i = 0; i < cavity_.num_facets(); ++i) {
    for (const Vertex v : complex().facet(HalfFacet(cavity_.facet(i).inner))) {
      if (!v.is_infinite()) nearest2_ = std::min(nearest2_, squared_distance(x, complex().point(v)));
    }
  }
  if (nearest2_ < std::max(distance2, floor2_)) {
    triangulation_->release(cavity_);
    return {};
  }
  boundary_->before_insertion(cavity_);
  for (std::size_t i = 0; i < cavity_.num_simplices(); ++i) {
    const typename Domain<Dim>::Region region = domain_->region(cavity_.simplex(i));
    if (on_removal && region != kUnknown<Dim> && region != Domain<Dim>::kOutside)
      on_removal(cavity_.simplex(i));
  }
  const Vertex v = triangulation_->substitute_star(cavity_, x);
  for (std::size_t i = 0; i < cavity_.num_facets(); ++i) {
    flow_->forget(cavity_.star(i));
    domain_->set_region(cavity_.star(i), kUnknown<Dim>);
    fresh_.push_back(cavity_.star(i));
  }
  for (const SubFacet f : boundary_->after_insertion(cavity_)) created_.push_back(f);
  return v;
}

// What is to be known of a new vertex.
template <int Dim>
void Conformer<Dim>::settle(Vertex v, const Feature& on, double t, Vertex q) {
  BoundaryVertex info{on, t, 1, nearest2_, {}};
  boundary_->set_vertex(v, info);
  if (q.is_null()) return;
  const BoundaryVertex& culprit = boundary_->features().vertex(q);
  info.level = culprit.level + 1;
  // In the plane a rung itself is all that is excused (Miller, Pav, Walkington 2003).
  if (Dim == 3 && culprit.relaxed2 > info.relaxed2 && boundary_->features().rung(v, q, lambda_)) {
    info.relaxed2 = culprit.relaxed2;
    info.culprit = q;
  }
  boundary_->set_vertex(v, info);
}

// ------------------------------------------------------------------------------------------------
//  Regions of new simplices.

// Whether the simplex of h sees the corners of f in their order, or turned.
template <int Dim>
std::size_t Conformer<Dim>::side_of(SubFacet f, HalfFacet h) const {
  const auto& corners = boundary_->sub_facets()[f].corners;
  const auto facet = complex().facet(h);
  const auto first = std::find(facet.begin(), facet.end(), corners[0]);
  if constexpr (Dim == 2) return first == facet.begin() ? 0 : 1;
  const auto next = first + 1 == facet.end() ? facet.begin() : first + 1;
  return *next == corners[1] ? 0 : 1;
}

template <int Dim>
void Conformer<Dim>::remember_regions() {
  fresh_.clear();
  const auto& features = boundary_->features();
  regions_.resize(Dim == 3 ? features.patches().size() : features.segments().size());
  boundary_->sub_facets().for_each([this](SubFacet f) {
    const HalfFacet h = boundary_->sub_facets()[f].at;
    for (const HalfFacet side : {h, complex().mate(h)}) {
      regions_[boundary_->sub_facets()[f].owner][side_of(f, side)] =
          domain_->region(Complex<Dim>::simplex_of(side));
    }
  });
}

template <int Dim>
std::vector<Simplex> Conformer<Dim>::label_new() {
  std::erase_if(fresh_,
                [this](Simplex s) { return !complex().is_alive(s) || domain_->region(s) != kUnknown<Dim>; });
  const auto region_of = [this](Simplex s) {
    if (complex().is_ghost(s)) return Domain<Dim>::kOutside;
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet h = Complex<Dim>::half_facet(s, i);
      if (domain_->is_wall(h)) {
        const SubFacet f = boundary_->at(h);
        return regions_[boundary_->sub_facets()[f].owner][side_of(f, h)];
      }
      const auto region = domain_->region(complex().neighbor(s, i));
      if (region != kUnknown<Dim>) return region;
    }
    return kUnknown<Dim>;
  };
  std::vector<Simplex> stack;
  for (const Simplex s : fresh_) {
    if (domain_->region(s) != kUnknown<Dim>) continue;  // listed twice
    domain_->set_region(s, region_of(s));
    if (domain_->region(s) != kUnknown<Dim>) stack.push_back(s);
  }
  while (!stack.empty()) {
    const Simplex s = stack.back();
    stack.pop_back();
    for (int i = 0; i <= Dim; ++i) {
      const Simplex t = complex().neighbor(s, i);
      if (domain_->region(t) != kUnknown<Dim> || domain_->is_wall(Complex<Dim>::half_facet(s, i))) continue;
      domain_->set_region(t, domain_->region(s));
      stack.push_back(t);
    }
  }
  std::sort(fresh_.begin(), fresh_.end());
  fresh_.erase(std::unique(fresh_.begin(), fresh_.end()), fresh_.end());
  std::vector<Simplex> inside;
  for (const Simplex s : fresh_) {
    if (domain_->is_inside(s)) inside.push_back(s);
  }
  fresh_.clear();
  return inside;
}

// ------------------------------------------------------------------------------------------------
//  Flat simplices.

template <int Dim>
bool Conformer<Dim>::is_on_one_patch(Simplex s) const {
  if constexpr (Dim == 2) return false;
  const auto& features = boundary_->features();
  for (int i = 0; i <= Dim; ++i) {
    if (!features.is_on_boundary(complex().corner(s, i))) return false;
  }
  for (const std::uint32_t patch : features.patches_at(complex().corner(s, 0))) {
    bool all_on = true;
    for (int i = 1; i <= Dim; ++i) all_on = all_on && features.is_on_patch(complex().corner(s, i), patch);
    if (all_on) return true;
  }
  return false;
}

template <int Dim>
bool Conformer<Dim>::expel(Simplex s) {
  if constexpr (Dim == 2) {
    return false;
  } else {
    std::vector<int> walls;
    std::vector<int> others;
    for (int i = 0; i < 4; ++i) (domain_->is_wall(Complex<3>::half_facet(s, i)) ? walls : others).push_back(i);
    if (walls.empty()) return false;  // its turn comes when those before it are out
    const SubFacet f = boundary_->at(Complex<3>::half_facet(s, walls[0]));
    const auto beyond = domain_->region(complex().neighbor(s, walls[0]));
    const auto is_gabriel = [&](int i) {
      const HalfFacet h = Complex<3>::half_facet(s, i);
      for (const HalfFacet side : {h, complex().mate(h)}) {
        const Point3& apex = complex().point(complex().apex(side));
        if (triangulation_->predicates().diametral_side(complex().facet_corners(h), apex) < 0) return false;
      }
      return true;
    };
    if (walls.size() == 2 && beyond == Domain<3>::kOutside && is_gabriel(others[0]) && is_gabriel(others[1])) {
      const auto& corners = boundary_->sub_facets()[f].corners;
      const Vertex off_edge = complex().corner(s, walls[1]);
      const auto k =
          static_cast<std::size_t>(std::find(corners.begin(), corners.end(), off_edge) - corners.begin());
      if (PatchTriangulation(*boundary_).flip(f, k, created_)) {
        created_.clear();
        if (on_removal) on_removal(s);
        domain_->set_region(s, beyond);
        return true;
      }
    }
    return split(f, 0);
  }
}

template class Conformer<2>;
template class Conformer<3>;

}  // namespace sinkmesh
