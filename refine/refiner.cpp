// SPDX-License-Identifier: MIT
#include "refine/refiner.h"

#include <cmath>
#include <string>

#include "refine/quality.h"

namespace sinkmesh {

template <int Dim>
Refiner<Dim>::Refiner(Triangulation<Dim>& triangulation, Domain<Dim>& domain, Flow<Dim>& flow,
                      const RefineOptions& options)
    : options_(options), flow_(&flow), inserter_(triangulation, domain, flow, options.max_ratio) {
  require_valid(options);
}

template <int Dim>
RefineResult Refiner<Dim>::run() {
  if (options_.schedule == Schedule::incremental) {
    run_incremental();
  } else {
    run_rounds();
  }
  result_.prestars = inserter_.num_prestars();
  result_.inserted = inserter_.num_inserted();
  result_.rejected = inserter_.rejections();
  result_.rejected.dependent += dependent_;
  result_.remaining = classify_remaining();
  result_.separation =
      std::ldexp(std::sqrt(inserter_.separation2()), -inserter_.triangulation().gate().exponent());
  return result_;
}

template <int Dim>
bool Refiner<Dim>::may_continue() {
  constexpr std::size_t kPollEvery = 128;
  if (stopped_) return false;
  if (inserter_.num_vertices() >= options_.max_vertices) {
    result_.stop = Stop::budget;
    stopped_ = true;
  } else if (until_poll_-- == 0) {
    until_poll_ = kPollEvery;
    const Continue answer = options_.should_continue ? options_.should_continue() : Continue::yes;
    if (inserter_.complex().bytes() >= options_.max_bytes || answer == Continue::budget_spent) {
      result_.stop = Stop::budget;
      stopped_ = true;
    } else if (answer == Continue::cancelled) {
      result_.stop = Stop::cancelled;
      stopped_ = true;
    }
  }
  return !stopped_;
}

template <int Dim>
void Refiner<Dim>::begin_round() {
  ++result_.rounds;
  round_ = {};
  round_.round = result_.rounds;
  inserted_before_round_ = inserter_.num_inserted();
}

template <int Dim>
void Refiner<Dim>::end_round() {
  result_.candidates += round_.candidates;
  if (!options_.observer) return;
  round_.inserted = inserter_.num_inserted() - inserted_before_round_;
  round_.vertices = inserter_.num_vertices();
  round_.simplices = inserter_.num_simplices();
  round_.low_quality = inserter_.num_low_quality();
  round_.statistics = [this] {
    QualityStatistics statistics(options_.max_ratio);
    for (const Simplex s : inserter_.domain().simplices()) statistics.add<Dim>(inserter_.complex().corners(s));
    return statistics;
  };
  options_.observer(round_);
}

template <int Dim>
Remaining Refiner<Dim>::classify_remaining() {
  Remaining remaining;
  const double max_ratio2 = options_.max_ratio * options_.max_ratio;
  const Complex<Dim>& complex = inserter_.complex();
  for (const Simplex s : inserter_.low_quality()) {
    bool on_low_facet = false;
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet h = Complex<Dim>::half_facet(s, i);
      on_low_facet = on_low_facet || (inserter_.domain().is_wall(h) &&
                                      !(facet_shape<Dim>(complex.facet_corners(h)).ratio2() <= max_ratio2));
    }
    std::size_t sinks = 0;
    std::array<bool, 5> met{};
    const auto meet = [&](Simplex center) {
      ++sinks;
      met[static_cast<std::size_t>(inserter_.rejection(center))] = true;
      return false;
    };
    if (options_.insert == Insert::sink) visit_sinks(s, meet);
    if (options_.insert == Insert::circumcenter || options_.fallback == Fallback::circumcenter) meet(s);
    const auto rejected = [&](Verdict verdict) { return met[static_cast<std::size_t>(verdict)]; };
    if (on_low_facet) {
      ++remaining.boundary_facet;
    } else if (rejected(Verdict::inserted)) {
      ++remaining.untried;
    } else if (rejected(Verdict::boundary)) {
      ++remaining.boundary;
    } else if (rejected(Verdict::crossing)) {
      ++remaining.crossing;
    } else if (rejected(Verdict::separation)) {
      ++remaining.separation;
    } else {
      ++remaining.omega;
    }
  }
  return remaining;
}

template class Refiner<2>;
template class Refiner<3>;

}  // namespace sinkmesh
