// SPDX-License-Identifier: MIT
//
// The numbers that [EG01, 5] prints: the only ones on the page that are not computed.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "refine/options.h"

namespace sinkmesh::reproduce {

/// A row of the tables in Figures 7 to 11.
struct PaperRow {
  Insert insert;
  Schedule schedule;
  std::size_t simplices;
  std::optional<std::size_t> low_quality;
  double ratio_min;
  double ratio_avg;
  double ratio_max;
  std::optional<int> minutes;  ///< on a Pentium II, 450 MHz
};

/// The initial mesh in the same tables.
struct PaperInitial {
  std::size_t simplices;
  std::optional<std::size_t> low_quality;
  double ratio_min;
  double ratio_avg;
  double ratio_max;
};

/// The input surface, from the text of the section.
struct PaperSurface {
  std::size_t facets;
  double ratio_min;
  double ratio_avg;
  double ratio_max;
};

struct PaperModel {
  std::string_view model;
  int figure;
  std::optional<PaperSurface> surface;
  PaperInitial initial;
  std::span<const PaperRow> rows;
};

/// @throws InputError for a name that is none of the five.
const PaperModel& paper_model(std::string_view model);

}  // namespace sinkmesh::reproduce
