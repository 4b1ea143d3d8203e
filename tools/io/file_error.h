// SPDX-License-Identifier: MIT
//
// What reading or writing a file throws.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "predicates/error.h"

namespace sinkmesh {

/// A file cannot be used. what() is one printable line: `file:line: what is wrong, and what to do about it`;
/// without the line where there is none, and `file: at byte N: ...` in binary data. "-" reads as standard input
/// or output.
class FileError : public InputError {
 public:
  FileError(std::string_view file, std::string_view message);
  FileError(std::string_view file, std::size_t line, std::string_view message);

  static FileError at_byte(std::string_view file, std::size_t offset, std::string_view message);

  const std::string& file() const { return file_; }
  /// Counted from 1; 0 if the error has no line.
  std::size_t line() const { return line_; }

 private:
  std::string file_;
  std::size_t line_ = 0;
};

/// Text from a file, fit for a message: anything that is not printable ASCII escaped as \xNN, at most `limit`
/// characters of the text and then "...".
std::string printable(std::string_view text, std::size_t limit = 40);

}  // namespace sinkmesh
