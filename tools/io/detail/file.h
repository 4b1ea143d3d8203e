// SPDX-License-Identifier: MIT
//
// Whole files in and out. The only place that talks to the file system.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include "tools/io/file_error.h"

namespace sinkmesh::io_detail {

/// "-" stands for standard input or output.
inline bool is_standard_stream(std::string_view path) { return path == "-"; }

/// Everything in the file, or on standard input.
/// @throws FileError
std::string read_file(const std::string& path);
bool file_exists(const std::string& path);

/// One file in the making: finish() completes it under a temporary name in its folder, publish() gives it its
/// own name. Destroyed before that, it leaves nothing behind. Standard output, devices and pipes are written in
/// place.
class OutputFile {
 public:
  /// @throws FileError if it cannot be created.
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Writes everything and closes. @throws FileError
  void finish(std::string_view bytes);
  /// Requires finish(). @throws FileError
  void publish();

 private:
  [[noreturn]] void fail(const char* action, int error) const;

  std::string name_;       // for messages
  std::string target_;     // symbolic links resolved
  std::string temporary_;  // empty: written in place, or published
  std::FILE* stream_ = nullptr;
};

/// Both steps for one file.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace sinkmesh::io_detail
