// SPDX-License-Identifier: MIT
//
// The suites of stress_io.
#pragma once

#include <memory>

#include "test/stress/suite.h"

namespace sinkmesh::stress {

/// Files with bytes, lines and numbers changed: read and used, or refused with one line.
std::unique_ptr<Suite> make_damage_suite();

/// Memory that is not there, at every allocation of every step from file to file.
std::unique_ptr<Suite> make_memory_suite();

/// Outputs that cannot be written, by the library.
std::unique_ptr<Suite> make_output_suite();

/// The same two for the program; `path` is one that is linked with shortage/shortage.cpp.
std::unique_ptr<Suite> make_program_suite(const char* path);

}  // namespace sinkmesh::stress
