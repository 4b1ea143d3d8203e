// SPDX-License-Identifier: MIT
//
// Ctrl-C as a request: finish what can be finished.
#pragma once

namespace sinkmesh::program {

/// From now on the first SIGINT or SIGTERM only sets a flag. The next one ends the program, as usual.
void catch_stop_signals();

/// Whether there has been one.
bool stop_requested();

}  // namespace sinkmesh::program
