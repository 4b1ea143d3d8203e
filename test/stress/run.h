// SPDX-License-Identifier: MIT
//
// The main function of the stress executables: command line, loop, report.
#pragma once

#include <string>

#include "test/stress/suite.h"

namespace sinkmesh::stress {

/// Runs the suites one after the other, each for the same share of the time; prints one line for each and one
/// for all. A suite stops at its first failure, which is shrunk and written to a file that --replay takes.
///
/// Case number n of a suite depends on the seed, on the suite and on n alone.
/// @return the exit status: 0 nothing found, 1 a failure, 2 wrong usage.
int run_stress(int argc, char** argv, const std::string& name, const std::string& description, Suites suites);

}  // namespace sinkmesh::stress
