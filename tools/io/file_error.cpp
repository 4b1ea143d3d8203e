// SPDX-License-Identifier: MIT
//
// One line per error, whatever bytes the file and its name are made of.
#include "tools/io/file_error.h"

#include "tools/io/detail/concat.h"

namespace sinkmesh {
namespace {

using io_detail::concat;

// Longer than any path the system opens.
constexpr std::size_t kPathLimit = 4096;

std::string printable_path(std::string_view file) { return printable(file, kPathLimit); }

// Words of the file should have been made printable, and cut, where they were put into the message; here it is
// made sure.
std::string printable_line(std::string_view message) { return printable(message, kPathLimit); }

}  // namespace

FileError::FileError(std::string_view file, std::string_view message)
    : InputError(concat(printable_path(file), ": ", printable_line(message))), file_(file) {}

FileError::FileError(std::string_view file, std::size_t line, std::string_view message)
    : InputError(concat(printable_path(file), ":", line, ": ", printable_line(message))),
      file_(file),
      line_(line) {}

FileError FileError::at_byte(std::string_view file, std::size_t offset, std::string_view message) {
  return {file, concat("at byte ", offset, ": ", message)};
}

std::string printable(std::string_view text, std::size_t limit) {
  static constexpr char kHex[] = "0123456789abcdef";
  std::string out;
  for (const char c : text.substr(0, limit)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      out += c;
    } else {
      out += {'\\', 'x', kHex[byte >> 4], kHex[byte & 15]};
    }
  }
  if (text.size() > limit) out += "...";
  return out;
}

}  // namespace sinkmesh
