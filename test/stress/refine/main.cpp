// SPDX-License-Identifier: MIT
//
// stress_refine: random surfaces, all options, stopped at random moments; every mesh looked at from outside.
#include "test/stress/refine/suites.h"

#include <utility>

#include "test/stress/run.h"

int main(int argc, char** argv) {
  using namespace sinkmesh::stress;
  Suites suites;
  suites.push_back(make_mesh_suite<2>());
  suites.push_back(make_mesh_suite<3>());
  suites.push_back(make_stop_suite<2>());
  suites.push_back(make_stop_suite<3>());
  suites.push_back(make_numbering_suite<2>());
  suites.push_back(make_numbering_suite<3>());
  return run_stress(argc, argv, "stress_refine",
                    "Random surfaces refined with all options and stopped at random moments.",
                    std::move(suites));
}
