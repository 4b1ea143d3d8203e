// SPDX-License-Identifier: MIT
//
// User time and memory of this process, and medians of such numbers.
#pragma once

#include <sys/resource.h>

#include <algorithm>
#include <vector>

namespace sinkmesh::bench {

/// User time used so far.
inline double user_seconds() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

/// The largest amount of memory that was resident at any time.
inline double peak_resident_bytes() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// The upper one of an even number of values.
inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace sinkmesh::bench
