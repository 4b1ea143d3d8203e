// SPDX-License-Identifier: MIT
//
// What keeps a file from being written.
#pragma once

#include <sys/types.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "test/support/temporary_folder.h"

namespace sinkmesh::stress {

enum class Trouble : std::uint8_t {
  none,
  limit,   ///< no file may grow beyond some bytes, as on a full disk
  full,    ///< a device that is full
  pipe,    ///< nobody reads the other end
  folder,  ///< without permission
};
inline constexpr std::array kTroubles{Trouble::none, Trouble::limit, Trouble::full, Trouble::pipe,
                                      Trouble::folder};

std::string_view name_of(Trouble trouble);
std::optional<Trouble> trouble_named(std::string_view name);

/// In trouble as long as this lives.
class Troubled {
 public:
  /// @param bytes  for `limit`.
  Troubled(Trouble trouble, const test::TemporaryFolder& folder, std::uint64_t bytes);
  ~Troubled();
  Troubled(const Troubled&) = delete;
  Troubled& operator=(const Troubled&) = delete;

  /// What to write to; empty: to a file in the folder.
  const std::string& device() const { return device_; }

 private:
  Trouble trouble_;
  std::string folder_;
  std::string device_;
  int pipe_ = -1;
  uid_t user_ = 0;
};

}  // namespace sinkmesh::stress
