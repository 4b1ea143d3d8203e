// SPDX-License-Identifier: MIT
//
// Linked with the program, after its own objects, so that this runs last before main: the allocation that
// SINKMESH_FAIL_AT says, as "N once" or "N lasting", is not to be had.
#include <cstdlib>
#include <string_view>

#include "test/support/heap.h"

namespace {

[[gnu::constructor]] void prepare_shortage() {
  const char* const wanted = std::getenv("SINKMESH_FAIL_AT");
  if (wanted == nullptr) return;
  char* end = nullptr;
  const auto n = std::strtoull(wanted, &end, 10);
  using sinkmesh::test::heap::Shortage;
  sinkmesh::test::heap::fail_at(n, std::string_view(end) == " once" ? Shortage::once : Shortage::lasting);
}

}  // namespace
