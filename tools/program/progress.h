// SPDX-License-Identifier: MIT
//
// One line on the terminal that says how far a long run is.
#pragma once

#include <string>
#include <string_view>

#include "refine/options.h"
#include "tools/program/stopwatch.h"

namespace sinkmesh::program {

/// Draws on standard error if that is a terminal; erases its line at the end.
class ProgressLine {
 public:
  explicit ProgressLine(bool enabled);
  ~ProgressLine() { erase(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// What is being done now; at once.
  void phase(std::string_view text);
  /// At most ten times a second.
  void update(const Progress& progress);
  void erase();

 private:
  void draw(std::string text);

  bool enabled_;
  bool drawn_ = false;
  Stopwatch watch_;       // since the phase began
  double last_draw_ = 0;  // on that watch
  // The rate is that of the last seconds, not of the whole run.
  double rate_ = 0;
  double rate_time_ = 0;
  std::size_t rate_vertices_ = 0;
};

}  // namespace sinkmesh::program
