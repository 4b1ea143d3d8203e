// SPDX-License-Identifier: MIT
//
// Plain stdio and <filesystem>; POSIX where a failing write would otherwise kill the process.
#include "tools/io/detail/file.h"

#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <system_error>
#include <utility>

#include "tools/io/detail/concat.h"

namespace sinkmesh::io_detail {
namespace {

namespace fs = std::filesystem;

// A closed pipe, or a file over the limit of its size, should be an error of the write, not the end of the
// process. The disposition of a signal is global state and none of our business; the mask is this thread's, and
// is restored.
class WriteSignalGuard {
 public:
  WriteSignalGuard() {
    sigset_t pending;
    sigemptyset(&pending);
    sigpending(&pending);
    sigset_t blocked;
    sigemptyset(&blocked);
    sigemptyset(&ours_);
    for (const int signal : {SIGPIPE, SIGXFSZ}) {
      sigaddset(&blocked, signal);
      if (sigismember(&pending, signal) != 1) sigaddset(&ours_, signal);
    }
    pthread_sigmask(SIG_BLOCK, &blocked, &before_);
  }
  ~WriteSignalGuard() {
    const timespec no_wait{};
    while (sigtimedwait(&ours_, nullptr, &no_wait) != -1 || errno == EINTR) {
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  WriteSignalGuard(const WriteSignalGuard&) = delete;
  WriteSignalGuard& operator=(const WriteSignalGuard&) = delete;

 private:
  sigset_t ours_;  // that were not pending before
  sigset_t before_;
};

std::string reason(int error) { return std::generic_category().message(error); }

// What the user can do about the usual errors.
const char* advice(int error) {
  switch (error) {
    case ENOENT:
      return "; check the path";
    case EACCES:
    case EPERM:
    case EROFS:
      return "; check the permissions, or choose another folder";
    case EISDIR:
      return "; name a file, not a folder";
    case ENOSPC:
    case EDQUOT:
      return "; free some space, or choose another folder";
    case EFBIG:
      return "; the limit of the size of a file is reached (ulimit -f)";
    case EPIPE:
      return "; the program that reads the output has ended";
    default:
      return "";
  }
}

std::string explain(const std::string& action, int error) {
  return concat(action, ": ", reason(error), advice(error));
}

// Reads to the end whatever its size turns out to be: a file may grow, and a pipe has none.
std::string read_all(std::FILE* stream, const std::string& name, std::size_t expected) {
  constexpr std::size_t kLeast = std::size_t{1} << 16;
  std::string bytes;
  std::size_t size = 0;
  for (bool more = true; more;) {
    // One byte beyond the expected size, so that the end is seen without growing once more.
    bytes.resize(size == 0 ? expected + kLeast : 2 * bytes.size());
    while (more && size < bytes.size()) {
      const std::size_t got = std::fread(bytes.data() + size, 1, bytes.size() - size, stream);
      if (got == 0 && std::ferror(stream) != 0) throw FileError(name, explain("cannot read it", errno));
      more = got != 0;
      size += got;
    }
  }
  bytes.resize(size);
  return bytes;
}

// Where symbolic links lead, also if nothing is there yet: canonical() stops before such a link.
fs::path followed(fs::path path) {
  constexpr int kMostLinks = 40;  // as the system has it; a circle then fails when it is opened
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(path, error); ++i) {
    const fs::path next = path.parent_path() / fs::read_symlink(path, error);
    // A descriptor of a pipe in /dev/fd is a link that can be opened, but leads to no name.
    if (fs::exists(path, error) && !fs::exists(next, error)) break;
    path = next;
  }
  return path;
}

std::string input_name(const std::string& path) { return is_standard_stream(path) ? "standard input" : path; }
std::string output_name(const std::string& path) { return is_standard_stream(path) ? "standard output" : path; }

}  // namespace

std::string read_file(const std::string& path) {
  const std::string name = input_name(path);
  if (is_standard_stream(path)) return read_all(stdin, name, 0);
  std::error_code error;
  if (fs::is_directory(path, error)) throw FileError(name, explain("cannot read it", EISDIR));
  std::FILE* const stream = std::fopen(path.c_str(), "rb");
  if (stream == nullptr) throw FileError(name, explain("cannot open it", errno));
  struct Closer {
    std::FILE* stream;
    ~Closer() { std::fclose(stream); }
  } const closer{stream};
  std::setvbuf(stream, nullptr, _IONBF, 0);
  const auto size = fs::is_regular_file(path, error) ? fs::file_size(path, error) : 0;
  return read_all(stream, name, error ? 0 : static_cast<std::size_t>(size));
}

bool file_exists(const std::string& path) {
  std::error_code error;
  return fs::exists(path, error);
}

OutputFile::OutputFile(const std::string& path) : name_(output_name(path)) {
  if (is_standard_stream(path)) {
    // A stream of our own: what stdout could not write it would try again at exit, outside any guard.
    if (std::fflush(stdout) != 0) fail("cannot write it", errno);
    const int descriptor = dup(STDOUT_FILENO);
    stream_ = descriptor < 0 ? nullptr : fdopen(descriptor, "wb");
    if (stream_ == nullptr) fail("cannot open it for writing", errno);
    return;
  }
  std::error_code error;
  const fs::path target = followed(path);
  target_ = target.string();
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) fail("cannot write it", EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    // A device or a pipe: renaming a file over it would replace it.
    stream_ = std::fopen(target_.c_str(), "wb");
    if (stream_ == nullptr) fail("cannot open it for writing", errno);
    return;
  }
  if (fs::exists(status) && access(target_.c_str(), W_OK) != 0) fail("cannot write over it", errno);
  // Short, so that it fits where the name itself does; the counter tells the threads of a process apart.
  static std::atomic<unsigned> counter{0};
  for (int attempt = 0; stream_ == nullptr; ++attempt) {
    const std::string file = concat(".sinkmesh-", getpid(), "-", counter++, ".tmp");
    std::string candidate = (target.parent_path() / file).string();
    stream_ = std::fopen(candidate.c_str(), "wbx");
    if (stream_ != nullptr) {
      temporary_ = std::move(candidate);  // from here on nothing may throw: there is no destructor yet
    } else if (errno != EEXIST || attempt == 1000) {
      fail("cannot create it", errno);
    }
  }
}

OutputFile::~OutputFile() {
  if (stream_ != nullptr) std::fclose(stream_);
  if (!temporary_.empty()) std::remove(temporary_.c_str());
}

void OutputFile::fail(const char* action, int error) const { throw FileError(name_, explain(action, error)); }

void OutputFile::finish(std::string_view bytes) {
  const WriteSignalGuard guard;
  std::FILE* const stream = std::exchange(stream_, nullptr);
  // The bytes are one buffer already.
  std::setvbuf(stream, nullptr, _IONBF, 0);
  errno = 0;
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), stream) == bytes.size();
  const int error = errno;
  // Some file systems report a full disk only here.
  const bool closed = std::fclose(stream) == 0;
  if (!written) fail("cannot write it", error);
  if (!closed) fail("cannot write it", errno);
}

// Takes no memory, so that of several files all are published, or none: those that are finished.
void OutputFile::publish() {
  if (temporary_.empty()) return;
  // A file that is replaced keeps its permissions.
  struct stat before {};
  constexpr mode_t kPermissions = 07777;
  if (stat(target_.c_str(), &before) == 0) chmod(temporary_.c_str(), before.st_mode & kPermissions);
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) {
    fail("cannot give the finished file its name", errno);
  }
  temporary_.clear();
}

void write_file(const std::string& path, std::string_view bytes) {
  OutputFile file(path);
  file.finish(bytes);
  file.publish();
}

}  // namespace sinkmesh::io_detail
