// SPDX-License-Identifier: MIT
#include "test/stress/child.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>

#include "test/stress/text.h"

namespace sinkmesh::stress {
namespace {

// Only pages that are written to take memory.
constexpr std::size_t kCaseBytes = std::size_t{1} << 30;
constexpr std::size_t kFailureBytes = std::size_t{1} << 16;

/// Appends to a buffer that is large enough, or throws.
class Packer {
 public:
  explicit Packer(char* buffer) : at_(buffer), end_(buffer + kCaseBytes) {}

  void add(std::uint64_t value) { add_bytes(&value, sizeof value); }
  void add(const std::string& text) {
    add(text.size());
    add_bytes(text.data(), text.size());
  }
  void add(const std::vector<double>& row) {
    add(row.size());
    add_bytes(row.data(), row.size() * sizeof(double));
  }

 private:
  void add_bytes(const void* bytes, std::size_t n) {
    if (n > static_cast<std::size_t>(end_ - at_)) throw std::length_error("a case too large to be recorded");
    if (n != 0) std::memcpy(at_, bytes, n);
    at_ += n;
  }

  char* at_;
  char* end_;
};

class Unpacker {
 public:
  explicit Unpacker(const char* buffer) : at_(buffer) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    read(&value, sizeof value);
    return value;
  }
  std::string text() {
    std::string result(number(), '\0');
    read(result.data(), result.size());
    return result;
  }
  std::vector<double> row() {
    std::vector<double> result(number());
    read(result.data(), result.size() * sizeof(double));
    return result;
  }

 private:
  void read(void* bytes, std::size_t n) {
    if (n != 0) std::memcpy(bytes, at_, n);
    at_ += n;
  }

  const char* at_;
};

std::string what_ended(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    const std::string name = "signal " + std::to_string(signal) + ": ";
    if (signal == SIGALRM) return name + "the check does not end";
    return name + strsignal(signal);
  }
  return "exit status " + std::to_string(WEXITSTATUS(status)) + ": the check ended its process";
}

void lose_output() {
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

}  // namespace

struct SharedState::Layout {
  Counters counters;
  std::array<char, kFailureBytes> failure;  // ends with a zero
  std::array<char, kCaseBytes> packed;
};

SharedState::SharedState() {
  void* const memory =
      mmap(nullptr, sizeof(Layout), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  layout_ = static_cast<Layout*>(memory);  // of zeros, which is what an empty state consists of
}

SharedState::~SharedState() { munmap(layout_, sizeof(Layout)); }

Counters& SharedState::counters() { return layout_->counters; }

void SharedState::record(const Case& c) {
  Packer packer(layout_->packed.data());
  packer.add(c.suite);
  packer.add(c.seed);
  packer.add(c.number);
  packer.add(c.settings.size());
  for (const auto& [key, value] : c.settings) {
    packer.add(key);
    packer.add(value);
  }
  packer.add(c.rows.size());
  for (const auto& row : c.rows) packer.add(row);
}

Case SharedState::recorded() const {
  Unpacker unpacker(layout_->packed.data());
  Case c;
  c.suite = unpacker.text();
  c.seed = unpacker.number();
  c.number = unpacker.number();
  c.settings.resize(unpacker.number());
  for (auto& [key, value] : c.settings) {
    key = unpacker.text();
    value = unpacker.text();
  }
  c.rows.resize(unpacker.number());
  for (auto& row : c.rows) row = unpacker.row();
  return c;
}

void SharedState::set_failure(const std::string& text) {
  const std::size_t n = std::min(text.size(), kFailureBytes - 1);
  std::copy_n(text.begin(), n, layout_->failure.begin());
  layout_->failure[n] = '\0';
}

std::string SharedState::failure() const { return layout_->failure.data(); }

std::string run_in_child(SharedState& state, bool quiet, const std::function<void()>& work) {
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    if (quiet) lose_output();
    [&]() noexcept { work(); }();  // what escapes must not unwind into the parent's code
    _exit(0);                      // what the parent has yet to print is not printed twice
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
  }
  const bool ended_well = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return ended_well ? state.failure() : what_ended(status);
}

std::string check_here(Suite& suite, const Case& c, Counters& counters) {
  try {
    return suite.check(c, counters);
  } catch (const CheckFailed& failed) {
    return failed.what();
  } catch (const std::exception& error) {
    return std::string("exception: ") + error.what();
  }
}

std::string check_in_child(Suite& suite, const Case& c, bool quiet) {
  SharedState state;
  return run_in_child(state, quiet, [&] {
    alarm(suite.seconds_per_case());
    state.set_failure(check_here(suite, c, state.counters()));
  });
}

}  // namespace sinkmesh::stress
