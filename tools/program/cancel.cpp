// SPDX-License-Identifier: MIT
#include "tools/program/cancel.h"

#include <csignal>

namespace sinkmesh::program {
namespace {

volatile std::sig_atomic_t requested = 0;

extern "C" void request_stop(int) {
  requested = 1;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace

void catch_stop_signals() {
  std::signal(SIGTERM, request_stop);
  // A program that a shell runs in the background ignores Ctrl-C, which is meant for another one.
  if (std::signal(SIGINT, request_stop) == SIG_IGN) std::signal(SIGINT, SIG_IGN);
}

bool stop_requested() { return requested != 0; }

}  // namespace sinkmesh::program
