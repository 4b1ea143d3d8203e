// SPDX-License-Identifier: MIT
//
// Checks run in a process of their own, so that a crash, an assertion, a report of a sanitizer or an endless
// loop is a failure like any other: the parent still knows the case, and goes on.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "test/stress/case.h"
#include "test/stress/suite.h"

namespace sinkmesh::stress {

/// The case at hand and the counters, in memory that parent and child share. Copying a case there costs less
/// than checking it, and leaves nothing to do for a process that is about to die.
class SharedState {
 public:
  /// @throws std::bad_alloc
  SharedState();
  ~SharedState();
  SharedState(const SharedState&) = delete;
  SharedState& operator=(const SharedState&) = delete;

  Counters& counters();
  /// @throws std::length_error for more than about 10^8 numbers.
  void record(const Case& c);
  Case recorded() const;
  /// Cut to what there is room for.
  void set_failure(const std::string& text);
  std::string failure() const;

 private:
  struct Layout;
  Layout* layout_;
};

/// Calls work(), which reports what it found in `state`, in a child process.
/// @param quiet  what it prints is lost.
/// @return what is wrong: state.failure(), or `signal N: ...` or `exit status N: ...`; empty if all is well.
std::string run_in_child(SharedState& state, bool quiet, const std::function<void()>& work);

/// One check in a child process.
std::string check_in_child(Suite& suite, const Case& c, bool quiet);

/// The check, with what it throws as a failure.
std::string check_here(Suite& suite, const Case& c, Counters& counters);

}  // namespace sinkmesh::stress
