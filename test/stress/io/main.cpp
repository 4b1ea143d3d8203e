// SPDX-License-Identifier: MIT
//
// stress_io: damaged files, memory that runs out, outputs that cannot be written.
#include <utility>

#include "test/stress/io/suites.h"
#include "test/stress/run.h"

int main(int argc, char** argv) {
  using namespace sinkmesh::stress;
  Suites suites;
  suites.push_back(make_damage_suite());
  suites.push_back(make_memory_suite());
  suites.push_back(make_output_suite());
#ifdef SINKMESH_SHORT_PROGRAM
  suites.push_back(make_program_suite(SINKMESH_SHORT_PROGRAM));
#endif
  return run_stress(argc, argv, "stress_io",
                    "Damaged files, memory that runs out, and outputs that cannot be written.",
                    std::move(suites));
}
