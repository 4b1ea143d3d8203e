// SPDX-License-Identifier: MIT
//
// stress_delaunay: two engines, one complex, and that of the definition.
#include <utility>

#include "test/stress/delaunay/suites.h"
#include "test/stress/run.h"

int main(int argc, char** argv) {
  using namespace sinkmesh::stress;
  Suites suites = make_large_suites();
  suites.push_back(make_oracle_suite<2>());
  suites.push_back(make_oracle_suite<3>());
  suites.push_back(make_insertion_suite<2>());
  suites.push_back(make_insertion_suite<3>());
  suites.push_back(make_calls_suite<2>());
  suites.push_back(make_calls_suite<3>());
  suites.push_back(make_hull_suite<2>());
  suites.push_back(make_hull_suite<3>());
  suites.push_back(make_order_suite<2>());
  suites.push_back(make_order_suite<3>());
  return run_stress(argc, argv, "stress_delaunay",
                    "Triangulations of degenerate clouds by both engines, in any order, against exact oracles.",
                    std::move(suites));
}
