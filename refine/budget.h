// SPDX-License-Identifier: MIT
//
// When a run is to end before its work is done.
#pragma once

#include <cstddef>

#include "refine/options.h"

namespace sinkmesh {

/// Watches the budgets and the cancel flag of the options, which must outlive it.
class Budget {
 public:
  explicit Budget(const RefineOptions& options) : options_(&options) {}

  /// Asked before each step; polls the flag about every hundred times. Once it has said no, it stays at that.
  bool may_continue(std::size_t vertices, std::size_t bytes) {
    constexpr std::size_t kPollEvery = 128;
    if (stop_ != Stop::no_candidate) return false;
    if (vertices >= options_->max_vertices) {
      stop_ = Stop::budget;
    } else if (until_poll_-- == 0) {
      until_poll_ = kPollEvery;
      const Continue answer = options_->should_continue ? options_->should_continue() : Continue::yes;
      if (bytes >= options_->max_bytes || answer == Continue::budget_spent) {
        stop_ = Stop::budget;
      } else if (answer == Continue::cancelled) {
        stop_ = Stop::cancelled;
      }
    }
    return stop_ == Stop::no_candidate;
  }

  Stop stop() const { return stop_; }

 private:
  const RefineOptions* options_;
  Stop stop_ = Stop::no_candidate;
  std::size_t until_poll_ = 0;
};

}  // namespace sinkmesh
