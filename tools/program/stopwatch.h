// SPDX-License-Identifier: MIT
//
// Seconds, by phase.
#pragma once

#include <chrono>

namespace sinkmesh::program {

/// Starts when it is made.
class Stopwatch {
 public:
  /// Since the start.
  double total() const { return seconds(start_); }
  /// Since the last call, or the start.
  double lap() {
    const double result = seconds(lap_);
    lap_ = Clock::now();
    return result;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds(Clock::time_point since) {
    return std::chrono::duration<double>(Clock::now() - since).count();
  }
  Clock::time_point start_ = Clock::now();
  Clock::time_point lap_ = start_;
};

}  // namespace sinkmesh::program
