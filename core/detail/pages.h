// SPDX-License-Identifier: MIT
//
// Memory for PodArray: small blocks from the heap, large ones mapped, so that growing one moves no byte.
#pragma once

#include <cstddef>

namespace sinkmesh::detail {

/// Makes a block of `from` bytes one of `to` bytes, aligned to 64; the first `used` bytes keep their values.
/// @throws std::bad_alloc, and the old block is then as it was.
void* resize_pages(void* block, std::size_t from, std::size_t to, std::size_t used);
void release_pages(void* block, std::size_t bytes) noexcept;

}  // namespace sinkmesh::detail
