// SPDX-License-Identifier: MIT
//
// Every sign against exact integers: the checks of stress_predicates on points that come from bytes.
#include "test/fuzz/bytes.h"
#include "test/fuzz/check.h"
#include "test/stress/predicates/regimes.h"
#include "test/stress/predicates/sign_suite.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sinkmesh;
  static const stress::Suites suites = stress::make_sign_suites();
  fuzz::Bytes bytes(data, size);
  stress::Suite& suite = *suites[bytes.take<std::uint8_t>() % suites.size()];
  const unsigned kind = bytes.take<std::uint8_t>();
  stress::Case c;
  c.set("choice", bytes.take<std::uint64_t>());
  // Each polynomial has points of its own number and dimension: as many as it accepts.
  constexpr std::size_t kMostPoints = 8;
  for (const std::string_view regime : {stress::kGated, stress::kRaw, stress::kBeyond}) {
    c.set("regime", regime);
    for (const std::size_t dim : {2U, 3U}) {
      for (std::size_t n = 3; n <= kMostPoints; ++n) {
        fuzz::Bytes coordinates = bytes;
        c.rows.assign(n, std::vector<double>(dim));
        for (auto& row : c.rows) {
          for (double& x : row) x = coordinates.coordinate(kind);
        }
        if (!suite.accepts(c)) continue;
        fuzz::check(suite, c);
        return 0;
      }
    }
  }
  return 0;
}
