// SPDX-License-Identifier: MIT
#include "core/detail/pages.h"

#include <cstring>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace sinkmesh::detail {
namespace {

constexpr std::align_val_t kAlignment{64};

// From this size on a block is mapped; the page is 4096 bytes, so rounding up costs little.
constexpr std::size_t kMapped = std::size_t{1} << 18;

bool is_mapped(std::size_t bytes) {
#ifdef __linux__
  return bytes >= kMapped;
#else
  (void)bytes;
  return false;
#endif
}

void* allocate(std::size_t bytes) {
#ifdef __linux__
  if (is_mapped(bytes)) {
    void* block = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (block == MAP_FAILED) throw std::bad_alloc();
    return block;
  }
#endif
  return ::operator new(bytes, kAlignment);
}

}  // namespace

void release_pages(void* block, std::size_t bytes) noexcept {
  if (block == nullptr) return;
#ifdef __linux__
  if (is_mapped(bytes)) {
    munmap(block, bytes);
    return;
  }
#endif
  ::operator delete(block, kAlignment);
}

void* resize_pages(void* block, std::size_t from, std::size_t to, std::size_t used) {
#ifdef __linux__
  if (block != nullptr && is_mapped(from) && is_mapped(to)) {
    void* moved = mremap(block, from, to, MREMAP_MAYMOVE);
    if (moved == MAP_FAILED) throw std::bad_alloc();
    return moved;
  }
#endif
  void* fresh = allocate(to);
  if (used != 0) std::memcpy(fresh, block, used);
  release_pages(block, from);
  return fresh;
}

}  // namespace sinkmesh::detail
