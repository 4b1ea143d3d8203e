// SPDX-License-Identifier: MIT
//
// How the program ends.
#pragma once

#include <stdexcept>

namespace sinkmesh::program {

enum class ExitStatus {
  done = 0,
  unusable_input = 1,  ///< or an output that cannot be written; one line on standard error
  wrong_usage = 2,     ///< one line on standard error, with the command whose --help tells more
  stopped_early = 3,   ///< budget or signal: the output is valid, or absent, with one line that says why
  internal_error = 4,
};

/// Options that cannot be used together, or do not fit the files.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace sinkmesh::program
