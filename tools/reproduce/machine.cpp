// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <sys/utsname.h>

#include <fstream>
#include <string>
#include <thread>

#include "tools/reproduce/reproduce.h"

namespace sinkmesh::reproduce {
namespace {

// Where Linux tells it.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name") && line.find(':') != std::string::npos) {
      return line.substr(line.find(':') + 2);
    }
  }
  return "unknown processor";
}

}  // namespace

std::string describe_machine() {
  utsname system{};
  const bool known = uname(&system) == 0;
  return fmt::format("{}, {} hardware threads, {} {}, compiler {}", processor(),
                     std::thread::hardware_concurrency(), known ? system.sysname : "unknown system",
                     known ? system.machine : "", __VERSION__);
}

}  // namespace sinkmesh::reproduce
