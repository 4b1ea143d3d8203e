// SPDX-License-Identifier: MIT
//
// The text that a command prints when it is done.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "refine/options.h"

namespace sinkmesh::program {

/// Lines with a heading each, their texts in one column.
class Summary {
 public:
  /// An empty heading continues the one before.
  void line(std::string_view heading, std::string_view text);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Quality as a table: one column, or more, as of "before" and "after". Small angles are counted where a census
/// is given, in all columns or none.
struct QualityColumn {
  std::string_view heading;
  std::size_t vertices;
  const QualityStatistics* quality;
  const AngleCensus* angles = nullptr;
};
void add_quality(Summary& summary, const std::vector<QualityColumn>& columns, int dim, double max_ratio);

/// How many simplices fall into which range of r/l.
void add_histogram(Summary& summary, const QualityStatistics& quality);

/// Why simplices of low quality remain; nothing if none do.
void add_remaining(Summary& summary, const Remaining& remaining, double max_ratio);

/// Seconds by phase, their sum and the memory.
using Phases = std::vector<std::pair<const char*, double>>;
void add_times(Summary& summary, const Phases& phases, double total);

}  // namespace sinkmesh::program
