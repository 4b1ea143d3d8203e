// SPDX-License-Identifier: MIT
#include "refine/steiner_inserter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/mix.h"
#include "core/vector.h"
#include "predicates/circumcenter.h"
#include "predicates/constructions.h"
#include "predicates/input_gate.h"
#include "predicates/predicates.h"
#include "refine/quality.h"

namespace sinkmesh {
namespace {

bool is_strictly_inside(const Corners<2>& s, const Point2& x) { return incircle(*s[0], *s[1], *s[2], x) > 0; }
bool is_strictly_inside(const Corners<3>& s, const Point3& x) {
  return insphere(*s[0], *s[1], *s[2], *s[3], x) > 0;
}

// Below this fraction of the largest coordinate, which is in [1,2) behind the gate, rounding a center moves it
// by a noticeable part of the distance between vertices.
constexpr double kResolution2 = 0x1p-80;

// What rounding the coordinates of a point, and the way there, may take from its distances.
constexpr double kRounding = 0x1p-50;

}  // namespace

template <int Dim>
SteinerInserter<Dim>::SteinerInserter(Triangulation<Dim>& triangulation, Domain<Dim>& domain, Flow<Dim>& flow,
                                      double max_ratio)
    : triangulation_(&triangulation), domain_(&domain), flow_(&flow), max_ratio2_(max_ratio * max_ratio) {
  // The nearest neighbour of a vertex is a Delaunay neighbour: the shortest edge is the shortest distance.
  double shortest2 = HUGE_VAL;
  for (const Simplex s : complex().simplices()) {
    if (!complex().is_ghost(s)) shortest2 = std::min(shortest2, shape<Dim>(complex().corners(s)).shortest2);
  }
  separation2_ = shortest2 * kSurely;
  if (separation2_ < kResolution2) {
    char distance[32];
    std::snprintf(distance, sizeof distance, "%.2g", std::sqrt(shortest2) / 2);
    throw InputError(
        std::string("two vertices are ") + distance +
        " times the largest coordinate apart: the input is at the resolution of doubles; move it to the "
        "origin, or merge vertices");
  }
  count_vertices();
}

template <int Dim>
SteinerInserter<Dim>::SteinerInserter(Triangulation<Dim>& triangulation, Domain<Dim>& domain, Flow<Dim>& flow,
                                      double max_ratio, const BoundaryRules<Dim>& rules)
    : triangulation_(&triangulation),
      domain_(&domain),
      flow_(&flow),
      max_ratio2_(max_ratio * max_ratio),
      separation2_(rules.floor * rules.floor),
      rules_(rules) {
  count_vertices();
}

template <int Dim>
void SteinerInserter<Dim>::count_vertices() {
  std::vector<bool> used(complex().num_vertices(), false);
  for (const Simplex s : complex().simplices()) {
    if (!domain_->is_inside(s)) continue;
    for (int i = 0; i <= Dim; ++i) used[complex().corner(s, i).index()] = true;
  }
  num_vertices_ = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

template <int Dim>
void SteinerInserter<Dim>::measure_all() {
  for (const Simplex s : complex().simplices()) {
    if (domain_->is_inside(s)) add(s);
  }
}

// Records a new simplex of the domain.
template <int Dim>
void SteinerInserter<Dim>::add(Simplex s) {
  if (s.index() >= birth_.size()) {
    birth_.resize(complex().records().capacity(), 0);
    notes_.resize(complex().records().capacity(), 0);
  }
  birth_[s.index()] = ++births_;
  notes_[s.index()] = 0;
  ++num_simplices_;
  const Shape shape = sinkmesh::shape<Dim>(complex().corners(s));
  const double ratio2 = shape.ratio2();
  if (ratio2 <= max_ratio2_) return;
  notes_[s.index()] = kLow;
  ++num_low_;
  low_.emplace_back(s, births_);
  if (rules_.features != nullptr && is_excused_by_angle(s, shape)) {
    notes_[s.index()] |= kExcused;
    return;
  }
  if (on_low_quality) on_low_quality(s, shape);
}

template <int Dim>
template <class Visit>
void SteinerInserter<Dim>::for_each_shortest_edge(Simplex s, double shortest2, Visit&& visit) const {
  for (int i = 0; i <= Dim; ++i) {
    for (int j = 0; j < i; ++j) {
      const Vertex p = complex().corner(s, i);
      const Vertex q = complex().corner(s, j);
      if (squared_distance(complex().point(p), complex().point(q)) <= shortest2) visit(p, q);
    }
  }
}

// Below a ratio of 2 a point on a segment may be nearer than the edge is long.
template <int Dim>
double SteinerInserter<Dim>::least_length2() const {
  const double least = rules_.floor * std::max(1.0, 2 / std::sqrt(max_ratio2_));
  return least * least;
}

template <int Dim>
bool SteinerInserter<Dim>::is_at_floor(Simplex s) const {
  return shape<Dim>(complex().corners(s)).shortest2 <= least_length2();
}

// The square of L [BR, 6].
template <int Dim>
double SteinerInserter<Dim>::relaxed_length2(Simplex s, double shortest2) const {
  if (rules_.features == nullptr) return shortest2;
  double length2 = std::max(shortest2, least_length2());
  for_each_shortest_edge(s, shortest2, [&](Vertex p, Vertex q) {
    length2 = std::max(length2, rules_.features->vertex(std::max(p, q)).relaxed2);
    if (const auto rung = rules_.features->rung(p, q, rules_.lambda)) length2 = std::max(length2, rung->reach2);
  });
  return length2;
}

template <int Dim>
bool SteinerInserter<Dim>::is_excused_by_angle(Simplex s, const Shape& shape) const {
  return sharp_corner(s) >= 0 || shape.radius2 <= max_ratio2_ * relaxed_length2(s, shape.shortest2);
}

template <int Dim>
int SteinerInserter<Dim>::sharp_corner(Simplex s) const {
  if constexpr (Dim == 2) {
    const double shortest2 = shape<Dim>(complex().corners(s)).shortest2;
    const auto is_wall = [&](int i) { return domain_->is_wall(Complex<Dim>::half_facet(s, i)); };
    for (int i = 0; i <= Dim; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      const Point2& a = complex().point(complex().corner(s, j));
      const Point2& b = complex().point(complex().corner(s, k));
      if (is_wall(j) && is_wall(k) && squared_distance(a, b) <= shortest2) return i;
    }
  }
  return -1;
}

template <int Dim>
void SteinerInserter<Dim>::set_lambda(double lambda) {
  rules_.lambda = lambda;
  for (const Simplex s : low_quality()) {
    std::uint8_t& notes = notes_[s.index()];
    const bool is_excused = is_excused_by_angle(s, shape<Dim>(complex().corners(s)));
    notes = static_cast<std::uint8_t>(is_excused ? notes | kExcused : notes & ~kExcused);
  }
}

template <int Dim>
std::optional<Rung> SteinerInserter<Dim>::rung(Simplex s) const {
  using Ends = typename BoundaryFeatures<Dim>::Ends;
  std::optional<Rung> result;
  const Ends ends = is_excused(s) ? Ends::no_corners : Ends::any;
  for_each_shortest_edge(s, shape<Dim>(complex().corners(s)).shortest2, [&](Vertex p, Vertex q) {
    if (!result) result = rules_.features->rung(p, q, rules_.lambda, ends);
    const Vertex young = std::max(p, q);
    const Vertex culprit = rules_.features->vertex(young).culprit;
    if (!result && !culprit.is_null()) result = rules_.features->rung(young, culprit, rules_.lambda);
  });
  return result;
}

template <int Dim>
const std::vector<Simplex>& SteinerInserter<Dim>::low_quality() {
  std::erase_if(low_, [this](const auto& entry) { return !is_current(entry.first, entry.second); });
  low_alive_.clear();
  for (const auto& [simplex, birth] : low_) low_alive_.push_back(simplex);
  return low_alive_;
}

template <int Dim>
std::vector<HalfFacet> SteinerInserter<Dim>::encroached_walls(const Candidate<Dim>& candidate) {
  struct Collector : FreeGuide {
    const SteinerInserter* inserter;
    const Point<Dim>* x;
    std::vector<HalfFacet>* found;

    Passage cross(HalfFacet inner, HalfFacet) const {
      if (!inserter->domain_->is_wall(inner)) return Passage::pass;
      const FacetCorners<Dim> corners = inserter->complex().facet_corners(inner);
      if (inserter->triangulation_->predicates().diametral_side(corners, *x) <= 0) found->push_back(inner);
      return Passage::wall;
    }
  };
  std::vector<HalfFacet> walls;
  if (!is_strictly_inside(complex().corners(candidate.simplex), candidate.point)) return walls;
  triangulation_->announce(candidate.point);
  triangulation_->grow_prestar(cavity_, candidate.point, candidate.simplex,
                               Collector{{}, this, &candidate.point, &walls});
  triangulation_->release(cavity_);
  return walls;
}

template <int Dim>
std::uint64_t SteinerInserter<Dim>::tie(Simplex s) const {
  return hash_points<Dim>(complex().corners(s));
}

template <int Dim>
Candidate<Dim> SteinerInserter<Dim>::describe(Simplex s) const {
  Candidate<Dim> candidate;
  candidate.owner = candidate.simplex = s;
  candidate.owner_birth = candidate.birth = birth(s);
  candidate.corner = complex().corner(s, 0);
  const Corners<Dim> corners = complex().corners(s);
  for (std::size_t i = 0; i <= Dim; ++i) candidate.corners[i] = *corners[i];
  candidate.radius2 = shape<Dim>(corners).radius2;
  candidate.priority = candidate.radius2;
  candidate.tie = tie(s);
  return candidate;
}

template <int Dim>
bool SteinerInserter<Dim>::make_center(Simplex s, Candidate<Dim>& candidate) {
  candidate = describe(s);
  if (circumcenter(complex().corners(s), candidate.point)) return true;
  refuse(candidate, Verdict::crossing);
  return false;
}

template <int Dim>
bool SteinerInserter<Dim>::make_off_sink(Simplex s, double reach, Candidate<Dim>& candidate) {
  const double length2 = relaxed_length2(s);
  const std::optional<OffSink<Dim>> at = off_sink_walk_(*flow_, s, reach * reach * max_ratio2_ * length2);
  candidate = describe(at ? at->simplex : s);
  candidate.owner = s;
  candidate.owner_birth = birth(s);
  candidate.is_center = false;
  candidate.tie = tie(s);
  const double least = std::max(0.0, std::sqrt(length2) - kRounding);
  candidate.least2 = least * least;
  if (!at) {
    refuse(candidate, Verdict::crossing);
    return false;
  }
  candidate.point = at->point;
  candidate.radius2 = at->distance2;
  return true;
}

template <int Dim>
Point<Dim> SteinerInserter<Dim>::center_or_direction(Simplex s) {
  Point<Dim> center;
  if (!circumcenter(complex().corners(s), center)) {
    const Point<Dim>& from = complex().point(complex().corner(s, 0));
    center = vector_to_circumcenter<Dim>(complex().corners(s), from);
    double reach = 0;
    for (const double x : center) reach = std::max(reach, std::abs(x));
    // Coordinates are below 2; one of them ends between 2 and 4.
    for (std::size_t k = 0; k < Dim; ++k) center[k] = from[k] + center[k] * (4 / reach);
  }
  center = on_grid<Dim>(center);
  triangulation_->announce(center);
  return center;
}

// Finds an inside simplex in conflict with the point.
template <int Dim>
Verdict SteinerInserter<Dim>::locate(const Candidate<Dim>& candidate, Simplex& start) {
  if (is_current(candidate.simplex, candidate.birth)) {
    start = candidate.simplex;
    // Where a circumcenter lies on a wall, the flow may lead beyond: its ties are broken, those of encroachment
    // are not.
    if (!domain_->is_inside(start)) return Verdict::crossing;
    return is_strictly_inside(complex().corners(start), candidate.point) ? Verdict::inserted
                                                                         : Verdict::separation;
  }
  triangulation_->announce(candidate.point);
  const Location<Dim> at =
      triangulation_->locate(candidate.point, complex().incident_simplex(candidate.corner));
  start = at.simplex;
  if (at.is_at_corner()) return Verdict::separation;
  return domain_->is_inside(start) ? Verdict::inserted : Verdict::crossing;
}

template <int Dim>
Verdict SteinerInserter<Dim>::test(const Candidate<Dim>& candidate, std::vector<Vertex>& closure) {
  Simplex start;
  Verdict verdict = locate(candidate, start);
  if (verdict == Verdict::inserted) verdict = grow(candidate, start, [](Vertex) { return false; });
  if (verdict != Verdict::inserted) return refuse(candidate, verdict);
  closure.clear();
  for (std::size_t i = 0; i < cavity_.num_simplices(); ++i) {
    for (int k = 0; k <= Dim; ++k) closure.push_back(complex().corner(cavity_.simplex(i), k));
  }
  std::sort(closure.begin(), closure.end());
  closure.erase(std::unique(closure.begin(), closure.end()), closure.end());
  triangulation_->release(cavity_);
  return verdict;
}

template <int Dim>
Verdict SteinerInserter<Dim>::refuse(const Candidate<Dim>& candidate, Verdict verdict) {
  switch (verdict) {
    case Verdict::inserted:
      break;
    case Verdict::boundary:
      ++rejections_.boundary;
      break;
    case Verdict::crossing:
      ++rejections_.crossing;
      break;
    case Verdict::separation:
      ++rejections_.separation;
      break;
    case Verdict::dependent:
      ++rejections_.dependent;
      return verdict;
  }
  if (is_current(candidate.owner, candidate.owner_birth)) {
    constexpr unsigned kOthers = (1U << kVerdictShift) - 1;
    std::uint8_t& notes = notes_[candidate.owner.index()];
    notes = static_cast<std::uint8_t>((notes & kOthers) | static_cast<unsigned>(verdict) << kVerdictShift);
  }
  return verdict;
}

template <int Dim>
void SteinerInserter<Dim>::commit(const Point<Dim>& x) {
  for (std::size_t i = 0; i < cavity_.num_simplices(); ++i) remove(cavity_.simplex(i));
  const typename Domain<Dim>::Region region = domain_->region(cavity_.simplex(0));
  triangulation_->substitute_star(cavity_, x);
  ++num_vertices_;
  ++num_inserted_;
  domain_->inherit(cavity_, region);
  for (std::size_t i = 0; i < cavity_.num_facets(); ++i) {
    const Simplex s = cavity_.star(i);
    flow_->forget(s);
    add(s);
    const HalfFacet outer(cavity_.facet(i).outer);
    if (on_new_at_wall && domain_->is_wall(outer)) on_new_at_wall(outer);
  }
}

template class SteinerInserter<2>;
template class SteinerInserter<3>;

}  // namespace sinkmesh
