// SPDX-License-Identifier: MIT
#include "refine/refiner.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "refine/quality.h"

namespace sinkmesh {
namespace {

// Both positive: orders by the 20 highest bits of the mantissa of the first, then by the second.
double with_low_bits(double high, float low) {
  const std::uint64_t high_bits = std::bit_cast<std::uint64_t>(high) >> 32 << 32;
  return std::bit_cast<double>(high_bits | std::bit_cast<std::uint32_t>(low));
}

// The 40 highest bits of the mantissa: numbers are equal that differ by the rounding of coordinates only.
double but_for_rounding(double x) { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) >> 12 << 12); }

}  // namespace

template <int Dim>
Refiner<Dim>::Refiner(Triangulation<Dim>& triangulation, Domain<Dim>& domain, Flow<Dim>& flow,
                      const RefineOptions& options)
    : options_(options),
      budget_(options_),
      flow_(&flow),
      inserter_(triangulation, domain, flow, options.max_ratio) {
  require_valid(options);
  result_.order = options.order.value_or(default_order<Dim>(options.insert, false));
}

template <int Dim>
Refiner<Dim>::Refiner(Triangulation<Dim>& triangulation, Domain<Dim>& domain, Flow<Dim>& flow,
                      Boundary<Dim>& boundary, Conformer<Dim>& conformer, const BoundaryRules<Dim>& rules,
                      const RefineOptions& options)
    : options_(options),
      budget_(options_),
      flow_(&flow),
      boundary_(&boundary),
      conformer_(&conformer),
      inserter_(triangulation, domain, flow, options.max_ratio, rules),
      on_segments_before_(conformer.points_on_segments()),
      on_patches_before_(conformer.points_on_patches()) {
  require_valid(options);
  result_.order = options.order.value_or(default_order<Dim>(options.insert, true));
  conformer.on_removal = [this](Simplex s) { inserter_.remove(s); };
  inserter_.on_new_at_wall = [this](HalfFacet wall) { boundary_->refresh(wall); };
}

// Boundary last: interior points alone do most of the work, and what they leave is all that the boundary has to
// be divided for.
template <int Dim>
RefineResult Refiner<Dim>::run() {
  if (options_.schedule == Schedule::incremental) {
    run_incremental(false);
  } else {
    inserter_.measure_all();
    run_rounds();
  }
  if (conformer_ != nullptr) refine_boundary();
  result_.stop = budget_.stop();
  if (!is_valid_ && !is_known_ && result_.stop == Stop::no_candidate) result_.stop = Stop::floor;
  result_.prestars = inserter_.num_prestars();
  result_.inserted = num_inserted();
  result_.rejected = inserter_.rejections();
  result_.rejected.dependent += dependent_;
  if (is_valid_) classify_remaining(conformer_ == nullptr);
  if (is_valid_ && is_stopped()) result_.centers_beyond = count_centers_beyond();
  if (conformer_ != nullptr) {
    result_.points_on_segments = conformer_->points_on_segments() - on_segments_before_;
    result_.points_on_patches = conformer_->points_on_patches() - on_patches_before_;
    conformer_->on_removal = nullptr;
  }
  result_.separation =
      std::ldexp(std::sqrt(inserter_.separation2()), -inserter_.triangulation().gate().exponent());
  return result_;
}

template <int Dim>
RefineResult Refiner<Dim>::look() {
  inserter_.measure_all();
  if (conformer_ == nullptr) test_points();
  classify_remaining(conformer_ == nullptr);
  if (conformer_ != nullptr) conformer_->on_removal = nullptr;
  result_.centers_beyond = count_centers_beyond();
  return result_;
}

template <int Dim>
void Refiner<Dim>::find_leftovers() {
  inserter_.measure_all();
  test_points();
  classify_remaining(true);
  if (conformer_ != nullptr) conformer_->on_removal = nullptr;
}

// Finds out which points are refused, and inserts none.
template <int Dim>
void Refiner<Dim>::test_points() {
  std::vector<Vertex> closure;
  for (const Simplex s : inserter_.low_quality()) {
    visit_owners(s, [&](Simplex owner) {
      Candidate<Dim> candidate;
      if (!inserter_.is_rejected(owner) && make_candidate(owner, false, candidate)) {
        inserter_.test(candidate, closure);
      }
      return false;
    });
  }
}

template <int Dim>
std::size_t Refiner<Dim>::num_boundary_points() const {
  if (conformer_ == nullptr) return 0;
  return conformer_->points_on_segments() + conformer_->points_on_patches() - on_segments_before_ -
         on_patches_before_;
}

template <int Dim>
bool Refiner<Dim>::may_continue() {
  return is_valid_ && budget_.may_continue(num_vertices(), inserter_.complex().bytes());
}

template <int Dim>
void Refiner<Dim>::begin_round() {
  ++result_.rounds;
  round_ = {};
  round_.round = result_.rounds;
}

template <int Dim>
void Refiner<Dim>::end_round() {
  result_.candidates += round_.candidates;
  // Points that bring circumcenters inside, between two rounds, belong to the second.
  round_.inserted = num_inserted() - inserted_before_round_;
  inserted_before_round_ = num_inserted();
  if (!is_valid_ || !options_.observer) return;
  round_.vertices = num_vertices();
  round_.simplices = inserter_.num_simplices();
  round_.low_quality = inserter_.num_low_quality();
  round_.statistics = [this] {
    QualityStatistics statistics(options_.max_ratio);
    for (const Simplex s : inserter_.domain().simplices()) statistics.add<Dim>(inserter_.complex().corners(s));
    return statistics;
  };
  options_.observer(round_);
}

// 2^200 keeps the priorities of simplices of any size that doubles see in space behind the gate above 1.
//
// On a plate all simplices have the same shortest edge, up to rounding: where the boundary is divided, of
// lengths that agree in 20 bits the worst ratio comes first. Then large pieces are halved before small ones,
// and what is aligned stays so.
template <int Dim>
double Refiner<Dim>::priority(const Shape& shape) const {
  switch (result_.order) {
    case Order::ratio:
      return shape.ratio2();
    case Order::shortest:
      if (conformer_ == nullptr) return but_for_rounding(0x1p200 / shape.shortest2);
      return with_low_bits(0x1p200 / shape.shortest2, static_cast<float>(shape.ratio2()));
    case Order::smallest:
      return std::max(1.0, 0x1p200 / shape.radius2);
  }
  return 1;
}

// All simplices around a short edge have it in common. Within a fixed boundary the smallest of them comes
// first, as with Order::smallest: that leaves fewer of low quality than the worst ratio first, or no order.
template <int Dim>
std::uint64_t Refiner<Dim>::tie(Simplex s, const Shape& shape) const {
  const std::uint64_t hash = inserter_.tie(s);
  if (result_.order != Order::shortest || conformer_ != nullptr) return hash;
  const auto size = std::bit_cast<std::uint32_t>(static_cast<float>(1 / shape.radius2));
  return std::uint64_t{size} << 32 | hash >> 32;
}

template <int Dim>
bool Refiner<Dim>::make_candidate(Simplex owner, bool own_center, Candidate<Dim>& candidate) {
  if (own_center || options_.insert != Insert::off_sink) return inserter_.make_center(owner, candidate);
  return inserter_.make_off_sink(owner, options_.reach.value_or(kDefaultReach<Dim>), candidate);
}

template <int Dim>
bool Refiner<Dim>::try_insert(const Candidate<Dim>& candidate) {
  const bool inserted = inserter_.insert(candidate) == Verdict::inserted;
  round_.passed_boundary += inserted ? 1 : 0;
  return inserted;
}

template <int Dim>
bool Refiner<Dim>::has_fallback() const {
  return options_.insert == Insert::sink && options_.fallback == Fallback::circumcenter;
}

template <int Dim>
typename Leftover<Dim>::Reason Refiner<Dim>::reason_for(Simplex s, bool is_fixed) {
  using Reason = typename Leftover<Dim>::Reason;
  if (inserter_.sharp_corner(s) >= 0) return Reason::small_angle;
  const bool is_excused = inserter_.is_excused(s);
  const bool has_reason = is_excused && !inserter_.is_at_floor(s);
  if (has_reason || (boundary_ != nullptr && (is_excused || is_fixed) && inserter_.rung(s))) {
    return Reason::small_angle;
  }
  if (!is_excused && !is_fixed && !inserter_.is_hopeless(s)) return Reason::untried;
  const double max_ratio2 = options_.max_ratio * options_.max_ratio;
  for (int i = 0; i <= Dim; ++i) {
    const HalfFacet h = Complex<Dim>::half_facet(s, i);
    if (inserter_.domain().is_wall(h) &&
        !(facet_shape<Dim>(inserter_.complex().facet_corners(h)).ratio2() <= max_ratio2)) {
      return Reason::boundary_facet;
    }
  }
  if (is_excused) return Reason::separation;
  std::array<bool, 5> met{};
  const auto meet = [&](Simplex center) {
    met[static_cast<std::size_t>(inserter_.rejection(center))] = true;
    return false;
  };
  visit_owners(s, meet);
  if (has_fallback()) meet(s);
  const auto rejected = [&](Verdict verdict) { return met[static_cast<std::size_t>(verdict)]; };
  if (rejected(Verdict::inserted)) return Reason::untried;
  if (rejected(Verdict::boundary)) return Reason::boundary;
  if (rejected(Verdict::crossing)) return Reason::crossing;
  if (rejected(Verdict::separation)) return Reason::separation;
  return Reason::omega;
}

// The small angle that is the reason for s: the features that meet there.
template <int Dim>
void Refiner<Dim>::explain(Simplex s, Leftover<Dim>& leftover) const {
  if (const int i = inserter_.sharp_corner(s); i >= 0) {
    const auto segment = [&](int k) {
      const HalfFacet wall = Complex<Dim>::half_facet(s, (i + k) % (Dim + 1));
      if (boundary_ != nullptr) {
        return boundary_->describe(
            {Feature::Kind::segment, boundary_->sub_facets()[boundary_->at(wall)].owner});
      }
      const auto ends = inserter_.complex().facet(wall);
      return BoundaryFeature{BoundaryFeature::Kind::segment, {ends[0].index(), ends[1].index()}};
    };
    leftover.first = segment(1);
    leftover.second = segment(2);
    leftover.common = {BoundaryFeature::Kind::corner, {inserter_.complex().corner(s, i).index(), 0}};
  } else if (const auto rung = inserter_.rung(s)) {
    leftover.first = boundary_->describe(rung->first);
    leftover.second = boundary_->describe(rung->second);
    leftover.common = boundary_->describe(rung->common);
  }
}

template <int Dim>
void Refiner<Dim>::classify_remaining(bool is_fixed) {
  const Complex<Dim>& complex = inserter_.complex();
  std::vector<std::pair<std::uint64_t, Leftover<Dim>>> found;
  for (const Simplex s : inserter_.low_quality()) {
    Leftover<Dim> leftover;
    for (int i = 0; i <= Dim; ++i) leftover.corners[static_cast<std::size_t>(i)] = complex.corner(s, i).index();
    leftover.ratio = std::sqrt(shape<Dim>(complex.corners(s)).ratio2());
    leftover.reason = reason_for(s, is_fixed);
    if (leftover.reason == LeftoverReason::small_angle) explain(s, leftover);
    found.emplace_back(inserter_.tie(s), leftover);
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return a.second.ratio != b.second.ratio ? a.second.ratio > b.second.ratio : a.first < b.first;
  });
  leftovers_.clear();
  result_.remaining = {};
  for (const auto& [tie, leftover] : found) {
    leftovers_.push_back(leftover);
    ++result_.remaining.count(leftover.reason);
  }
}

template class Refiner<2>;
template class Refiner<3>;

}  // namespace sinkmesh
