// SPDX-License-Identifier: MIT
//
// The files of models and points that tests run on.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace sinkmesh::test {

/// The larger collection, which need not be there.
inline std::filesystem::path collection() {
  const char* const folder = std::getenv("SINKMESH_TEST_DATA");
  return folder != nullptr ? folder : SINKMESH_TEST_DATA;
}
inline bool has_collection() { return std::filesystem::is_directory(collection() / "real"); }

/// Point sets and surfaces in a folder, by name; none if there is no such folder.
inline std::vector<std::filesystem::path> data_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto suffix = entry.path().extension();
    if (suffix == ".off" || suffix == ".xyz") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace sinkmesh::test
