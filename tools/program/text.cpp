// SPDX-License-Identifier: MIT
#include "tools/program/text.h"

#include <cstdio>

#include "tools/io/detail/file.h"

namespace sinkmesh::program {

void print(std::string_view text, bool to_standard_error) {
  if (to_standard_error) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
  } else {
    io_detail::write_file("-", text);
  }
}

}  // namespace sinkmesh::program
