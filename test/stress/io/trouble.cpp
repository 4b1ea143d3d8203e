// SPDX-License-Identifier: MIT
#include "test/stress/io/trouble.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>

namespace sinkmesh::stress {
namespace {

constexpr std::array<std::string_view, kTroubles.size()> kNames{"none", "limit", "full", "pipe", "folder"};
constexpr uid_t kNobody = 65534;

void set_limit(rlim_t bytes) {
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  limit.rlim_cur = std::min(bytes, limit.rlim_max);
  setrlimit(RLIMIT_FSIZE, &limit);
}

}  // namespace

std::string_view name_of(Trouble trouble) { return kNames[static_cast<std::size_t>(trouble)]; }

std::optional<Trouble> trouble_named(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Trouble>(found - kNames.begin());
}

Troubled::Troubled(Trouble trouble, const test::TemporaryFolder& folder, std::uint64_t bytes)
    : trouble_(trouble), folder_(folder.path("")), user_(geteuid()) {
  if (trouble == Trouble::limit) set_limit(bytes);
  if (trouble == Trouble::full) device_ = "/dev/full";
  if (trouble == Trouble::pipe) {
    int ends[2];
    if (pipe2(ends, 0) != 0) throw std::runtime_error("no pipe");
    close(ends[0]);
    pipe_ = ends[1];
    device_ = "/dev/fd/" + std::to_string(pipe_);
  }
  if (trouble == Trouble::folder) {
    chmod(folder_.c_str(), 0555);
    // The superuser may write everywhere.
    if (user_ == 0 && seteuid(kNobody) != 0) throw std::runtime_error("cannot be somebody else");
  }
}

Troubled::~Troubled() {
  if (trouble_ == Trouble::limit) set_limit(RLIM_INFINITY);
  if (pipe_ >= 0) close(pipe_);
  if (trouble_ == Trouble::folder) {
    if (user_ == 0 && seteuid(user_) != 0) std::abort();
    chmod(folder_.c_str(), 0755);
  }
}

}  // namespace sinkmesh::stress
