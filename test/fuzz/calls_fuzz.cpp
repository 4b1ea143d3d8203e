// SPDX-License-Identifier: MIT
//
// Calls of Triangulation in any order: the checks of stress_delaunay on calls that come from bytes.
#include "test/fuzz/bytes.h"
#include "test/fuzz/check.h"
#include "test/stress/delaunay/suites.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sinkmesh;
  static const auto plane = stress::make_calls_suite<2>();
  static const auto space = stress::make_calls_suite<3>();
  constexpr std::size_t kMostRows = 60;
  fuzz::Bytes bytes(data, size);
  const unsigned kind = bytes.take<std::uint8_t>();
  const std::size_t dim = kind % 2 == 0 ? 2 : 3;
  stress::Case c;
  c.set("first", std::uint64_t{bytes.take<std::uint8_t>()} % 16 + dim);
  while (!bytes.empty() && c.rows.size() < kMostRows) {
    const unsigned call = bytes.take<std::uint8_t>();
    std::vector<double>& row = c.rows.emplace_back();
    for (std::size_t k = 0; k < dim; ++k) row.push_back(bytes.coordinate(kind / 2));
    row.push_back(call % 8);
  }
  fuzz::check(dim == 2 ? *plane : *space, c);
  return 0;
}
