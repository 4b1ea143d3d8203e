// SPDX-License-Identifier: MIT
//
// Words for failures.
#pragma once

#include <cstddef>
#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <string>

#include "predicates/point.h"

namespace sinkmesh::stress {

/// Bit for bit, as hexadecimal numbers.
template <std::size_t N>
std::string text(const std::array<double, N>& p) {
  std::string result = "(";
  for (std::size_t k = 0; k < N; ++k) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%s%a", k == 0 ? "" : " ", p[k]);
    result += buffer;
  }
  return result + ")";
}

/// A failure with both answers.
template <class Found, class Expected>
std::string differ(const std::string& kind, const Found& found, const Expected& expected) {
  std::ostringstream out;
  out << kind << ": found " << found << ", expected " << expected;
  return out.str();
}

/// For checks that are too deep to return a failure.
class CheckFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// @throws CheckFailed
template <class Found, class Expected>
void expect_equal(const std::string& kind, const Found& found, const Expected& expected) {
  if (!(found == expected)) throw CheckFailed(differ(kind, found, expected));
}

}  // namespace sinkmesh::stress
