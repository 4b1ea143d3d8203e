// SPDX-License-Identifier: MIT
//
// The course of a refinement as CSV, one line for each round.
#pragma once

#include <string>

#include "refine/options.h"

namespace sinkmesh::program {

class History {
 public:
  /// Line 0: before anything is inserted.
  History(std::size_t vertices, const QualityStatistics& initial);

  void add(const Progress& progress);

  /// The whole file.
  const std::string& csv() const { return csv_; }

 private:
  std::string csv_;
};

}  // namespace sinkmesh::program
