// SPDX-License-Identifier: MIT
#include "tools/program/text.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "tools/io/file_error.h"

namespace sinkmesh::program {

void print(std::string_view text, bool to_standard_error) {
  std::FILE* const stream = to_standard_error ? stderr : stdout;
  errno = 0;
  const bool written =
      std::fwrite(text.data(), 1, text.size(), stream) == text.size() && std::fflush(stream) == 0;
  if (!written && !to_standard_error) {
    throw FileError("standard output", fmt::format("cannot write it: {}", std::strerror(errno)));
  }
}

}  // namespace sinkmesh::program
