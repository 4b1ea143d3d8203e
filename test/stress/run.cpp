// SPDX-License-Identifier: MIT
#include "test/stress/run.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "predicates/self_test.h"
#include "test/stress/child.h"
#include "test/stress/shrink.h"

namespace sinkmesh::stress {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kShrinkSeconds = 30;
constexpr int kFound = 1;
constexpr int kWrongUsage = 2;

volatile std::sig_atomic_t interrupted = 0;
void interrupt(int) { interrupted = 1; }

struct Options {
  double seconds = 60;
  double hours = 0;
  std::uint64_t seed = 1;
  std::vector<std::string> only;
  std::string replay;
  std::string out = ".";
  bool list = false;
  bool large = false;
};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Different sequences for different suites; FNV-1a, so that they are the same with every library.
Random engine_for(std::uint64_t seed, const std::string& suite) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : suite) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return Random(hash ^ (seed * 0x9e3779b97f4a7c15U));
}

/// `insphere: signs differ: ...` is of the kind "signs differ".
std::string kind_of(const std::string& failure) { return failure.substr(0, failure.find(':')); }

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

class Runner {
 public:
  Runner(std::string name, Options options) : name_(std::move(name)), options_(std::move(options)) {}

  int run(const std::vector<Suite*>& suites) {
    const auto start = Clock::now();
    for (std::size_t i = 0; i < suites.size() && interrupted == 0; ++i) {
      const double left = options_.seconds - seconds_since(start);
      run_suite(*suites[i], std::max(0.0, left) / static_cast<double>(suites.size() - i));
    }
    std::printf("total: cases %llu, comparisons %llu, ties %llu, failures %d, %.0f s, seed %llu\n",
                as_printed(total_.cases), as_printed(total_.comparisons), as_printed(total_.ties), failures_,
                seconds_since(start), as_printed(options_.seed));
    return failures_ == 0 ? 0 : kFound;
  }

  static int replay(Suite& suite, const Case& c) {
    const std::string failure = check_in_child(suite, c, false);
    std::printf("%s: %s\n", suite.name().c_str(), failure.empty() ? "passes" : one_line(failure).c_str());
    return failure.empty() ? 0 : kFound;
  }

 private:
  static unsigned long long as_printed(std::uint64_t n) { return n; }

  void run_suite(Suite& suite, double seconds) {
    SharedState state;
    const auto start = Clock::now();
    const std::string failure = run_in_child(state, false, [&] { loop(suite, seconds, state); });
    const double elapsed = seconds_since(start);
    const Counters& counters = state.counters();
    total_.cases += counters.cases;
    total_.comparisons += counters.comparisons;
    total_.ties += counters.ties;
    print_line(suite, counters, elapsed);
    if (!failure.empty()) {
      ++failures_;
      report(suite, state.recorded(), failure);
    } else if (interrupted == 0) {
      check_floors(suite, counters);
    }
    std::fflush(stdout);
  }

  void loop(Suite& suite, double seconds, SharedState& state) const {
    Random random = engine_for(options_.seed, suite.name());
    Case c;
    c.suite = suite.name();
    c.seed = options_.seed;
    const auto start = Clock::now();
    double alarm_set = -1;
    for (;;) {
      const double now = seconds_since(start);
      const bool has_more = suite.num_cases() == 0 || c.number < suite.num_cases();
      // One case at least: a suite without time would pass for one without failures.
      if (interrupted != 0 || !has_more || (now >= seconds && c.number > 0)) break;
      if (now - alarm_set >= 1) {  // seldom, since it is a system call
        alarm(suite.seconds_per_case() + 1);
        alarm_set = now;
      }
      ++c.number;
      suite.generate(random, c);
      state.record(c);
      const std::string failure = check_here(suite, c, state.counters());
      ++state.counters().cases;
      if (failure.empty()) continue;
      state.set_failure(failure);
      break;
    }
  }

  void print_line(const Suite& suite, const Counters& counters, double seconds) const {
    std::string line = suite.name() + ": cases " + std::to_string(counters.cases) + ", comparisons " +
                       std::to_string(counters.comparisons) + ", " +
                       std::to_string(static_cast<std::uint64_t>(static_cast<double>(counters.comparisons) /
                                                                 std::max(seconds, 1e-3))) +
                       " per second, ties " + std::to_string(counters.ties);
    const auto named = suite.counters();
    for (std::size_t i = 0; i < named.size(); ++i) {
      if (counters.named.at(i) == 0 && named[i].least_share == 0) continue;
      line += ", " + named[i].name + " " + std::to_string(counters.named.at(i));
    }
    std::printf("%s, %.1f s, seed %llu\n", line.c_str(), seconds, as_printed(options_.seed));
  }

  void report(Suite& suite, const Case& found, const std::string& failure) const {
    const std::string kind = kind_of(failure);
    const Case smallest = shrink(found, kShrinkSeconds, [&](const Case& candidate) {
      return suite.accepts(candidate) && kind_of(check_in_child(suite, candidate, true)) == kind;
    });
    const auto file = std::filesystem::path(options_.out) /
                      (name_ + "-" + suite.name() + "-" + std::to_string(found.seed) + ".case");
    write_case(file, smallest);
    std::string why = check_in_child(suite, smallest, true);
    if (kind_of(why) != kind) why = failure + " (not reproduced: while making the next case, or after others)";
    std::printf("FAILURE %s: %s; in %s; %s --replay %s\n", suite.name().c_str(), one_line(why).c_str(),
                file.c_str(), name_.c_str(), file.c_str());
  }

  void check_floors(const Suite& suite, const Counters& counters) {
    const auto named = suite.counters();
    for (std::size_t i = 0; i < named.size(); ++i) {
      const double least = named[i].least_share * static_cast<double>(counters.cases);
      if (least < 100 || static_cast<double>(counters.named.at(i)) >= least) continue;
      ++failures_;
      std::printf("FAILURE %s: reached %s only %llu times in %llu cases; at least %.0f are expected\n",
                  suite.name().c_str(), named[i].name.c_str(), as_printed(counters.named.at(i)),
                  as_printed(counters.cases), least);
    }
  }

  std::string name_;
  Options options_;
  Counters total_;
  int failures_ = 0;
};

int wrong_usage(const std::string& name, const std::string& message) {
  std::fprintf(stderr, "%s: %s; see %s --help\n", name.c_str(), message.c_str(), name.c_str());
  return kWrongUsage;
}

Suite* find(const Suites& suites, const std::string& name) {
  const auto found =
      std::find_if(suites.begin(), suites.end(), [&](const auto& suite) { return suite->name() == name; });
  return found == suites.end() ? nullptr : found->get();
}

int replay_file(const std::string& name, const std::string& file, const Suites& suites) {
  const Case c = read_case(file);
  Suite* const suite = find(suites, c.suite);
  if (suite == nullptr) return wrong_usage(name, file + ": there is no suite " + c.suite);
  if (!suite->accepts(c)) return wrong_usage(name, file + ": is no case of the suite " + c.suite);
  return Runner::replay(*suite, c);
}

int run_chosen(const std::string& name, const Options& options, const Suites& suites) {
  std::vector<Suite*> chosen;
  for (const std::string& wanted : options.only) {
    Suite* const suite = find(suites, wanted);
    if (suite == nullptr) return wrong_usage(name, "there is no suite " + wanted + "; --list names them");
    chosen.push_back(suite);
  }
  if (options.only.empty()) {
    for (const auto& suite : suites) {
      if (suite->is_large() == options.large) chosen.push_back(suite.get());
    }
  }
  std::filesystem::create_directories(options.out);
  std::signal(SIGINT, interrupt);
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  return Runner(name, options).run(chosen);
}

}  // namespace

int run_stress(int argc, char** argv, const std::string& name, const std::string& description, Suites suites) {
  Options options;
  CLI::App program(description, name);
  program.footer("Exit status: 0 nothing found, 1 a failure, 2 wrong usage. Ctrl-C ends a run early.");
  auto* const seconds = program.add_option("--seconds", options.seconds, "time for all suites together")
                            ->check(CLI::PositiveNumber)
                            ->capture_default_str();
  program.add_option("--hours", options.hours, "the same in hours")
      ->check(CLI::PositiveNumber)
      ->excludes(seconds);
  program.add_option("--seed", options.seed, "same seed, same cases")->capture_default_str();
  program.add_option("--only", options.only, "suites to run; may be given several times");
  program.add_option("--replay", options.replay, "check the case in this file");
  program.add_option("--out", options.out, "folder for the files of failures")->capture_default_str();
  program.add_flag("--list", options.list, "name the suites");
  const bool has_large = std::any_of(suites.begin(), suites.end(), [](const auto& s) { return s->is_large(); });
  if (has_large) program.add_flag("--large", options.large, "run the large sets, each once, instead");
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    return wrong_usage(name, error.what());
  }
  if (options.hours > 0) options.seconds = 3600 * options.hours;
  try {
    if (options.list) {
      for (const auto& suite : suites) std::printf("%s\n", suite->name().c_str());
      return 0;
    }
    const std::string broken = predicates_self_test();
    if (!broken.empty()) {
      std::printf("FAILURE self-test: %s\n", broken.c_str());
      return kFound;
    }
    return options.replay.empty() ? run_chosen(name, options, suites)
                                  : replay_file(name, options.replay, suites);
  } catch (const CaseError& error) {
    return wrong_usage(name, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    return wrong_usage(name, error.what());
  }
}

}  // namespace sinkmesh::stress
