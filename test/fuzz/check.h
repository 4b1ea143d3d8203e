// SPDX-License-Identifier: MIT
//
// What a fuzz target does: the check of a stress suite, on a case that comes from bytes.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "test/stress/case.h"
#include "test/stress/suite.h"

namespace sinkmesh::fuzz {

[[noreturn]] inline void fail(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  std::abort();
}

/// Cases that the suite does not accept are passed over.
inline void check(stress::Suite& suite, stress::Case c) {
  c.suite = suite.name();
  if (!suite.accepts(c)) return;
  stress::Counters counters;
  std::string failure;
  try {
    failure = suite.check(c, counters);
  } catch (const std::exception& error) {
    failure = error.what();
  }
  if (!failure.empty()) fail(failure + "\n" + to_text(c));
}

}  // namespace sinkmesh::fuzz
