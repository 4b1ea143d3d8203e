// SPDX-License-Identifier: MIT
//
// stress_predicates: every exact sign against an oracle that shares no code with it.
#include "test/stress/predicates/center_suite.h"
#include "test/stress/predicates/gate_suite.h"
#include "test/stress/predicates/sign_suite.h"
#include "test/stress/run.h"

int main(int argc, char** argv) {
  using namespace sinkmesh::stress;
  Suites suites = make_sign_suites();
  suites.push_back(make_center_suite<2>());
  suites.push_back(make_center_suite<3>());
  suites.push_back(make_gate_suite<2>());
  suites.push_back(make_gate_suite<3>());
  return run_stress(argc, argv, "stress_predicates", "The predicates against exact integers, case after case.",
                    std::move(suites));
}
