// SPDX-License-Identifier: MIT
#include "tools/program/history.h"

#include <fmt/format.h>

#include <iterator>

namespace sinkmesh::program {

History::History(std::size_t vertices, const QualityStatistics& initial)
    : csv_(
          "round,vertices,simplices,low_quality,candidates,passed_boundary,inserted,"
          "ratio_min,ratio_avg,ratio_max\n") {
  Progress start;
  start.vertices = vertices;
  start.simplices = initial.simplices();
  start.low_quality = initial.low_quality();
  start.statistics = [&initial] { return initial; };
  add(start);
}

void History::add(const Progress& progress) {
  const QualityStatistics quality = progress.statistics();
  fmt::format_to(std::back_inserter(csv_), "{},{},{},{},{},{},{},{},{},{}\n", progress.round, progress.vertices,
                 progress.simplices, progress.low_quality, progress.candidates, progress.passed_boundary,
                 progress.inserted, quality.min_ratio(), quality.average_ratio(), quality.max_ratio());
}

}  // namespace sinkmesh::program
