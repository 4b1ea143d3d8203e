// SPDX-License-Identifier: MIT
//
// A computation in a child process: its user time, and the memory it adds.
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <cstdio>

#include "bench/rivals/user_time.h"

namespace sinkmesh::bench {

struct ChildResult {
  bool succeeded = false;
  std::size_t value = 0;
  double user_seconds = 0;
  double peak_bytes = 0;  ///< above what the process began with
};

/// Runs compute() in a copy of this process, which ends without destructors. It returns a function that returns
/// the value; this one is not measured.
/// @return not succeeded if it crashed, threw, or used up its time.
template <class Compute>
ChildResult measure_in_child(Compute&& compute, unsigned seconds_allowed) {
  int ends[2];
  if (pipe(ends) != 0) return {};
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) return {};
  if (child == 0) {
    close(ends[0]);
    const rlimit limit{seconds_allowed, seconds_allowed};
    setrlimit(RLIMIT_CPU, &limit);
    ChildResult result;
    try {
      // A new process has a peak of its own: the size at the fork.
      const double bytes_before = peak_resident_bytes();
      const double start = user_seconds();
      const auto value = compute();
      result.user_seconds = user_seconds() - start;
      result.peak_bytes = peak_resident_bytes() - bytes_before;
      result.value = value();
      result.succeeded = true;
    } catch (...) {
    }
    const bool written = write(ends[1], &result, sizeof result) == static_cast<ssize_t>(sizeof result);
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  ChildResult result;
  if (read(ends[0], &result, sizeof result) != static_cast<ssize_t>(sizeof result)) result = {};
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return result;
}

}  // namespace sinkmesh::bench
