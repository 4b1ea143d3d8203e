// SPDX-License-Identifier: MIT
//
// What a stress suite is: an endless source of cases, and a check that each of them must pass.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "test/stress/case.h"
#include "test/support/clouds.h"

namespace sinkmesh::stress {

using test::Random;

/// What a run has done. Lives in memory that two processes share: no pointers.
struct Counters {
  static constexpr std::size_t kNamed = 24;

  std::uint64_t cases = 0;
  std::uint64_t comparisons = 0;              ///< answers of the library that were compared with another source
  std::uint64_t ties = 0;                     ///< cases that only the tie rule decides
  std::array<std::uint64_t, kNamed> named{};  ///< see Suite::counters()
};

/// A counter of one suite: how often a stage decided, say.
struct NamedCounter {
  std::string name;
  /// A run in which fewer than this share of the cases got there tests too little, and has failed. It is looked
  /// at once 100 would have to be there.
  double least_share = 0;
};

class Suite {
 public:
  Suite() = default;
  Suite(const Suite&) = delete;
  Suite& operator=(const Suite&) = delete;
  virtual ~Suite() = default;

  /// Unique in its executable; part of file names.
  virtual std::string name() const = 0;

  /// Fills in rows and settings, which still are those of the case before: overwrite all of them.
  virtual void generate(Random& random, Case& c) = 0;

  /// Whether c is an input of this suite, as generate() makes them. Shrinking and --replay ask.
  virtual bool accepts(const Case& c) const = 0;

  /// @return empty, or what is wrong: `kind: details`, with both answers. Shrinking keeps the kind.
  /// @throws CheckFailed (text.h) for the same; whatever else is thrown, a crash, and a check without end are
  ///         failures, too.
  virtual std::string check(const Case& c, Counters& counters) = 0;

  /// Names for Counters::named, from its start.
  virtual std::vector<NamedCounter> counters() const { return {}; }

  /// After how many cases there are no more; 0: never.
  virtual std::uint64_t num_cases() const { return 0; }

  /// Seconds that one case may take before it counts as one that never ends.
  virtual unsigned seconds_per_case() const { return 120; }

  /// Whether it runs only under --large, which runs no others.
  virtual bool is_large() const { return false; }
};

using Suites = std::vector<std::unique_ptr<Suite>>;

}  // namespace sinkmesh::stress
