// SPDX-License-Identifier: MIT
//
// The heap of a test program, watched and made to run out: operator new of whatever links this is replaced.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sinkmesh::test::heap {

/// The largest block asked for since forget_largest(), in bytes.
std::size_t largest();
void forget_largest();

/// Blocks that are not given back yet.
std::size_t live_blocks();

/// Whether memory is short for a moment, or from then on.
enum class Shortage : std::uint8_t { once, lasting };

/// The n-th block from now on, counted from 1, is not to be had.
void fail_at(std::uint64_t n, Shortage shortage);
/// Ends it. @return whether it came to a failure.
bool stop_failing();

}  // namespace sinkmesh::test::heap
