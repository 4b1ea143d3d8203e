// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "test/stress/io/suites.h"
#include "test/stress/io/trouble.h"
#include "test/stress/text.h"
#include "test/support/sample_files.h"
#include "test/support/temporary_folder.h"

namespace sinkmesh::stress {
namespace {

/// Words of a command line; OUT stands for what is written. The files of a command are in its folder.
struct Command {
  const char* name;
  std::vector<std::string> words;
  std::vector<std::string> outputs;  ///< that do not depend on the time
};

const std::vector<Command>& commands() {
  static const std::vector<Command> all = {
      {"refine", {"refine", "in.off", "-q", "-o", "OUT", "--format", "vtu", "--report", "r.json"}, {"out"}},
      {"refine-tetgen", {"refine", "in.off", "-q", "-o", "a.node"}, {"a.node", "a.ele", "a.face"}},
      {"refine-history",
       {"refine", "in.off", "-o", "OUT", "--format", "mesh", "--history", "h.csv"},
       {"out", "h.csv"}},
      {"refine-stdout", {"refine", "in.off", "-q", "-o", "-", "--format", "vtk"}, {}},
      {"delaunay", {"delaunay", "in.off", "-q", "-o", "OUT", "--format", "msh"}, {"out"}},
      {"inspect", {"inspect", "in.off", "--report", "OUT"}, {"out"}},
      {"generate", {"generate", "usa", "--triangles", "60", "-o", "OUT", "--format", "poly"}, {"out"}},
      {"help", {"refine", "--help"}, {}},
  };
  return all;
}

constexpr int kNotRun = 127;

struct Ended {
  int status = 0;
  std::string message;  ///< standard error
};

/// A case has no rows: the command, what goes wrong, and when.
class ProgramSuite : public Suite {
 public:
  explicit ProgramSuite(const char* program) : program_(program) {}

  std::string name() const override { return "program"; }

  void generate(Random& random, Case& c) override {
    c.set("command", commands()[random() % commands().size()].name);
    constexpr std::array kShortages{"none", "once", "lasting"};
    c.set("shortage", kShortages[random() % 3]);
    // As often among the first ten as among the last ten thousand.
    c.set("allocation", 1 + random() % (std::uint64_t{10} << random() % 11));
    const bool is_short = c.setting("shortage") != "none";
    c.set("trouble", name_of(is_short ? Trouble::none : kTroubles[random() % kTroubles.size()]));
    c.set("bytes", random() % 4096);
    c.set("before", random() % 2);
  }

  bool accepts(const Case& c) const override {
    return command_of(c) != nullptr && trouble_named(c.setting("trouble")).has_value();
  }

  std::string check(const Case& c, Counters& counters) override {
    const Command& command = *command_of(c);
    const test::TemporaryFolder folder;
    folder.write("in.off", io_detail::encode_off(test::sample_surface()));
    const Trouble trouble = *trouble_named(c.setting("trouble"));
    if (run(command, folder, "out", "").status != 0) return "command: fails without trouble";
    const auto expected = folder.contents();
    auto before = expected;
    for (auto& [file, bytes] : before) {
      if (file != "in.off") bytes = "before";
    }
    if (c.number_setting("before") == 0) before = {{"in.off", expected.at("in.off")}};
    folder.set_contents(before);

    std::string shortage;
    if (c.setting("shortage") != "none")
      shortage = std::string(c.setting("allocation")) + ' ' + std::string(c.setting("shortage"));
    Ended ended;
    {
      const Troubled troubled(trouble, folder, c.number_setting("bytes"));
      ended = run(command, folder, troubled.device().empty() ? "out" : troubled.device(), shortage);
    }
    ++counters.comparisons;
    ++counters.named[ended.status == 0 ? 0 : 1];
    check_files(command, folder, before, expected);
    if (ended.status == 0) return "";
    if (ended.status != 1) return differ("exit status", ended.status, "0 or 1") + ", saying " + ended.message;
    const bool is_line = !ended.message.empty() && ended.message.find('\n') == ended.message.size() - 1;
    return is_line ? "" : "message: is no line: " + ended.message;
  }

  std::vector<NamedCounter> counters() const override { return {{"done", 0.1}, {"failed", 0.3}}; }

 private:
  static const Command* command_of(const Case& c) {
    const auto found = std::find_if(commands().begin(), commands().end(), [&](const Command& command) {
      return command.name == c.setting("command");
    });
    return found == commands().end() ? nullptr : &*found;
  }

  /// Each file as before or as it should be; none beside them.
  static void check_files(const Command& command, const test::TemporaryFolder& folder,
                          const test::TemporaryFolder::Contents& before,
                          const test::TemporaryFolder::Contents& expected) {
    for (const auto& [file, bytes] : folder.contents()) {
      if (!expected.contains(file)) throw CheckFailed("files: there is " + file);
      const bool is_old = before.contains(file) && before.at(file) == bytes;
      const auto& outputs = command.outputs;
      const bool is_fixed = std::find(outputs.begin(), outputs.end(), file) != outputs.end();
      const bool is_new = is_fixed ? bytes == expected.at(file) : bytes.ends_with("}\n");
      if (!is_old && !is_new) throw CheckFailed("files: " + file + " is neither old nor new");
    }
  }

  Ended run(const Command& command, const test::TemporaryFolder& folder, const std::string& out,
            const std::string& shortage) const {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
      // Nothing here may fail for another reason than the one that is wanted.
      std::vector<char*> words{const_cast<char*>(program_)};
      for (const std::string& word : command.words)
        words.push_back(const_cast<char*>((word == "OUT" ? out : word).c_str()));
      words.push_back(nullptr);
      const int nowhere = open(out == "/dev/full" ? "/dev/full" : "/dev/null", O_RDWR);
      dup2(nowhere, STDIN_FILENO);
      dup2(out.starts_with("/dev/fd/") ? std::stoi(out.substr(8)) : nowhere, STDOUT_FILENO);
      dup2(ends[1], STDERR_FILENO);
      // Somebody else for good (Trouble::folder): the sanitizers do not work for one who is so only for now.
      if (setresuid(geteuid(), geteuid(), geteuid()) != 0) _exit(kNotRun);
      if (!shortage.empty()) setenv("SINKMESH_FAIL_AT", shortage.c_str(), 1);
      if (chdir(folder.path("").c_str()) == 0) execv(program_, words.data());
      _exit(kNotRun);
    }
    close(ends[1]);
    Ended ended;
    char buffer[256];
    for (ssize_t n = 0; (n = ::read(ends[0], buffer, sizeof buffer)) > 0;)
      ended.message.append(buffer, static_cast<std::size_t>(n));
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
    }
    ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    return ended;
  }

  const char* program_;
};

}  // namespace

std::unique_ptr<Suite> make_program_suite(const char* path) { return std::make_unique<ProgramSuite>(path); }

}  // namespace sinkmesh::stress
