// SPDX-License-Identifier: MIT
#include "tools/program/summary.h"

#include <fmt/format.h>

#include <iterator>

#include "tools/program/report.h"
#include "tools/program/text.h"

namespace sinkmesh::program {
namespace {

std::string_view phrase(LeftoverReason reason) {
  switch (reason) {
    case LeftoverReason::boundary_facet:
      return "on a boundary facet whose own r/l is above the bound";
    case LeftoverReason::boundary:
      return "whose points would encroach upon the boundary";
    case LeftoverReason::crossing:
      return "whose points would reach through the boundary";
    case LeftoverReason::separation:
      return "whose points would be too near to other vertices";
    case LeftoverReason::omega:
      return "that flow to the outside only";
    case LeftoverReason::small_angle:
      return "at a small angle of the surface";
    case LeftoverReason::untried:
      return "not tried: the run ended before, or points were moved";
  }
  return "";
}

}  // namespace

void Summary::line(std::string_view heading, std::string_view text) {
  fmt::format_to(std::back_inserter(text_), "{:<12}{}\n", heading, text);
}

void add_quality(Summary& summary, const std::vector<QualityColumn>& columns, int dim, double max_ratio) {
  const auto row = [&](std::string_view heading, std::string_view what, auto&& value) {
    std::string text = fmt::format("{:<16}", what);
    for (const QualityColumn& column : columns) text += fmt::format("{:>14}", value(column));
    summary.line(heading, text);
  };
  if (columns.size() > 1) {
    row("quality", "", [](const QualityColumn& column) { return std::string(column.heading); });
  }
  row(columns.size() > 1 ? "" : "quality", "vertices",
      [](const QualityColumn& column) { return grouped(column.vertices); });
  row("", dim == 2 ? "triangles" : "tetrahedra",
      [](const QualityColumn& column) { return grouped(column.quality->simplices()); });
  row("", fmt::format("r/l above {:g}", max_ratio),
      [](const QualityColumn& column) { return grouped(column.quality->low_quality()); });
  row("", "r/l least", [](const QualityColumn& column) { return measure(column.quality->min_ratio()); });
  row("", "r/l average", [](const QualityColumn& column) { return measure(column.quality->average_ratio()); });
  row("", "r/l largest", [](const QualityColumn& column) { return measure(column.quality->max_ratio()); });
  const std::string_view angle = dim == 2 ? "angle" : "dihedral";
  row("", fmt::format("{} least", angle),
      [](const QualityColumn& column) { return fmt::format("{:.2f}", column.quality->min_angle()); });
  row("", fmt::format("{} largest", angle),
      [](const QualityColumn& column) { return fmt::format("{:.2f}", column.quality->max_angle()); });
  if (columns.front().angles == nullptr) return;
  for (std::size_t i = 0; i < AngleCensus::kSmall.size(); ++i) {
    row("", fmt::format("{} below {:g}", angle, AngleCensus::kSmall[i]),
        [&](const QualityColumn& column) { return grouped(column.angles->below(i)); });
    row("", "  inner vertex",
        [&](const QualityColumn& column) { return grouped(column.angles->inner_below(i)); });
  }
}

void add_histogram(Summary& summary, const QualityStatistics& quality) {
  double low = 0;
  std::string_view heading = "r/l";
  for (std::size_t i = 0; i < QualityStatistics::kBins.size(); ++i) {
    const double high = QualityStatistics::kBins[i];
    const std::uint64_t number = quality.histogram()[i];
    if (number != 0) {
      const bool open = i + 1 == QualityStatistics::kBins.size();
      const std::string range = open ? fmt::format("above {:g}", low) : fmt::format("{:g} to {:g}", low, high);
      summary.line(heading, fmt::format("{:<16}{:>14}", range, grouped(number)));
      heading = "";
    }
    low = high;
  }
}

void add_remaining(Summary& summary, const Remaining& remaining, double max_ratio) {
  if (remaining.total() == 0) return;
  summary.line("remaining", fmt::format("{} above {:g}:", grouped(remaining.total()), max_ratio));
  for (const LeftoverReason reason : kLeftoverReasons) {
    const std::size_t number = remaining.count(reason);
    if (number != 0) summary.line("", fmt::format("{:>9} {}", grouped(number), phrase(reason)));
  }
}

void add_times(Summary& summary, const Phases& phases, double total) {
  std::string text;
  for (const auto& [name, seconds] : phases) text += fmt::format("{} {}, ", name, duration(seconds));
  summary.line("time",
               fmt::format("{}total {}; memory {}", text, duration(total), megabytes(peak_memory_bytes())));
}

}  // namespace sinkmesh::program
