// SPDX-License-Identifier: MIT
#include "test/support/heap.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace sinkmesh::test::heap {
namespace {

std::atomic<std::size_t> largest_block{0};
std::atomic<std::size_t> blocks{0};
std::uint64_t until_failure = 0;  // 0: none
bool is_lasting = false;
bool has_failed = false;

bool is_refused() {
  if (until_failure == 0 || (until_failure > 1 && --until_failure > 0)) return false;
  has_failed = true;
  if (!is_lasting) until_failure = 0;
  return true;
}

void* allocate(std::size_t size, std::size_t alignment) {
  if (size > largest_block) largest_block = size;
  if (is_refused()) return nullptr;
  const std::size_t whole = size == 0 ? alignment : (size + alignment - 1) / alignment * alignment;
  void* const block =
      alignment <= alignof(std::max_align_t) ? std::malloc(whole) : std::aligned_alloc(alignment, whole);
  if (block != nullptr) ++blocks;
  return block;
}

void* allocate_or_throw(std::size_t size, std::size_t alignment) {
  void* const block = allocate(size, alignment);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

void release(void* block) {
  if (block == nullptr) return;
  --blocks;
  std::free(block);
}

}  // namespace

std::size_t largest() { return largest_block; }
void forget_largest() { largest_block = 0; }
std::size_t live_blocks() { return blocks; }

void fail_at(std::uint64_t n, Shortage shortage) {
  until_failure = n;
  is_lasting = shortage == Shortage::lasting;
  has_failed = false;
}

bool stop_failing() {
  until_failure = 0;
  return has_failed;
}

}  // namespace sinkmesh::test::heap

// Exact sizes, so that the sanitizers see any step beyond the end, wherever the alignment is the usual one. Not
// inlined: the compiler would take the two halves for a mismatch.
namespace heap = sinkmesh::test::heap;
[[gnu::noinline]] void* operator new(std::size_t size) { return heap::allocate_or_throw(size, 1); }
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return heap::allocate(size, 1);
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  return heap::allocate_or_throw(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void operator delete(void* block) noexcept { heap::release(block); }
[[gnu::noinline]] void operator delete(void* block, std::size_t) noexcept { heap::release(block); }
[[gnu::noinline]] void operator delete(void* block, std::align_val_t) noexcept { heap::release(block); }
[[gnu::noinline]] void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
  heap::release(block);
}
