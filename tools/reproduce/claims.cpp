// SPDX-License-Identifier: MIT
#include "tools/reproduce/claims.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/text/numbers.h"

namespace sinkmesh::reproduce {
namespace {

struct Range {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  void include(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  void include(const Range& range) {
    include(range.low);
    include(range.high);
  }
};

std::string words(const Range& range) {
  const auto number = [](double x) { return fmt::format("{:.{}f}", x, x < 10 ? 2 : 0); };
  return fmt::format("{} to {}", number(range.low), number(range.high));
}

// Over the models in space: value(circumcenter run) / value(sink run).
template <class Value>
Range ratios(const std::vector<Study>& studies, Schedule schedule, bool literal, Value&& value) {
  Range range;
  for (const Study& study : studies) {
    if (study.dimension != 3) continue;
    range.include(static_cast<double>(value(study.run({Insert::circumcenter, schedule, literal}))) /
                  static_cast<double>(value(study.run({Insert::sink, schedule, literal}))));
  }
  return range;
}

double simplices(const Run& run) { return static_cast<double>(run.mesh.simplices); }
double average(const Run& run) { return run.mesh.ratio_avg; }
double candidates(const Run& run) { return static_cast<double>(run.result.candidates); }
double seconds(const Run& run) { return run.cpu_seconds; }

std::string verdict(bool holds, bool in_part = false) {
  return holds ? "holds" : in_part ? "holds in part" : "does not hold";
}

Claim same_quality(const std::vector<Study>& studies) {
  Range size;
  Range quality;
  for (const Schedule schedule : {Schedule::incremental, Schedule::block, Schedule::parallel}) {
    size.include(ratios(studies, schedule, false, simplices));
    quality.include(ratios(studies, schedule, false, average));
  }
  const auto close_to_one = [](const Range& r) { return r.low > 0.9 && r.high < 1.1; };
  return {"Sinks give about the same mesh quality as circumcenters.",
          verdict(close_to_one(size) && close_to_one(quality)),
          fmt::format(
              "Over the four models in space and all schedules, circumcenter / sink is {} for the number of "
              "tetrahedra and {} for the average ratio.",
              words(size), words(quality))};
}

Claim shared_sinks(const std::vector<Study>& studies) {
  const Range range = ratios(studies, Schedule::parallel, true, candidates);
  std::string initial;
  for (const Study& study : studies) {
    if (study.dimension != 3) continue;
    const auto first = [&](Insert insert) {
      return study.run({insert, Schedule::parallel, true}).rounds.at(1).candidates;
    };
    initial += fmt::format(
        "{}{} for {} ({})", initial.empty() ? "" : ", ", text::count(first(Insert::sink), "sink", "sinks"),
        text::count(first(Insert::circumcenter), "circumcenter", "circumcenters"), study.model);
  }
  return {"Tetrahedra of low quality cluster and share sinks, so that far fewer points are tried.",
          verdict(range.low > 1.5),
          fmt::format(
              "Candidates over all literal parallel rounds, circumcenter / sink: {}. In the first round: {}.",
              words(range), initial)};
}

Claim faster_in_parallel(const std::vector<Study>& studies) {
  const Range range = ratios(studies, Schedule::parallel, true, seconds);
  return {
      "In the parallel schedule, insertion of sinks is several times faster.", verdict(range.low > 1.5),
      fmt::format(
          "CPU time of the literal rounds, circumcenter / sink: {}. Nearly all of it goes into the prestars "
          "of candidates.",
          words(range))};
}

Claim faster_in_every_schedule(const std::vector<Study>& studies) {
  const Range incremental = ratios(studies, Schedule::incremental, false, seconds);
  const Range block = ratios(studies, Schedule::block, false, seconds);
  const Range pruned = ratios(studies, Schedule::parallel, false, seconds);
  return {
      "Insertion of sinks is faster (read as a claim on every schedule).",
      verdict(incremental.low > 1.25, pruned.low > 1),
      fmt::format(
          "The advantage belongs to the schedule. With pruned parallel rounds the ratio is {}, in blocks {}, "
          "in the incremental schedule {}: there each candidate is tried once, almost every one is "
          "inserted, and both kinds of points cost about the same.",
          words(pruned), words(block), words(incremental))};
}

Claim conditioning(const std::vector<Study>& studies) {
  double sinks = 0;
  double circumcenters = 0;
  for (const Study& study : studies) {
    sinks = std::max(sinks, study.conditioning.sinks);
    circumcenters = std::max(circumcenters, study.conditioning.circumcenters);
  }
  return {
      "Sinks are numerically well-conditioned; circumcenters of flat tetrahedra are not.",
      verdict(circumcenters > 10 * sinks, circumcenters > sinks),
      fmt::format(
          "Largest error of the textbook formula in doubles against the exact center, in units of the radius, "
          "over the low-quality simplices of all initial meshes: {:.1e} for sinks, {:.1e} for "
          "circumcenters. Here it does no harm: centers are computed exactly and rounded once.",
          sinks, circumcenters)};
}

Claim schedules_agree(const std::vector<Study>& studies) {
  Range range;
  for (const Study& study : studies) {
    for (const Insert insert : {Insert::sink, Insert::circumcenter}) {
      const double incremental = simplices(study.run({insert, Schedule::incremental, false}));
      range.include(simplices(study.run({insert, Schedule::block, false})) / incremental);
      range.include(simplices(study.run({insert, Schedule::parallel, false})) / incremental);
    }
  }
  return {"The schedule has no significant effect on size and quality.",
          verdict(range.low > 0.9 && range.high < 1.1),
          fmt::format("Simplices in blocks and in parallel over those of the incremental schedule: {}.",
                      words(range))};
}

Claim literal_is_pruned(const std::vector<Study>& studies) {
  bool same = true;
  for (const Study& study : studies) {
    for (const Run& run : study.runs) {
      if (run.plan.literal)
        same = same && run.hash == study.run({run.plan.insert, run.plan.schedule, false}).hash;
    }
  }
  return {"(Ours.) Pruned rounds find the meshes of the literal ones.", verdict(same),
          "The hashes of all meshes were compared."};
}

}  // namespace

std::vector<Claim> weigh_claims(const std::vector<Study>& studies) {
  return {same_quality(studies),       shared_sinks(studies),
          faster_in_parallel(studies), faster_in_every_schedule(studies),
          schedules_agree(studies),    conditioning(studies),
          literal_is_pruned(studies)};
}

}  // namespace sinkmesh::reproduce
