// SPDX-License-Identifier: MIT
#include "tools/program/progress.h"

#include <fmt/format.h>

#include <cstdio>

#include "tools/program/text.h"

#ifndef _WIN32
#include <sys/ioctl.h>
#include <unistd.h>
#endif

namespace sinkmesh::program {
namespace {

constexpr double kRedraw = 0.1;      // seconds between two drawings
constexpr double kRateInterval = 1;  // seconds over which the rate is taken

bool is_terminal() {
#ifdef _WIN32
  return false;
#else
  return isatty(STDERR_FILENO) == 1;
#endif
}

// A line that wraps could not be erased.
std::size_t terminal_width() {
#ifndef _WIN32
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1) return size.ws_col - 1U;
#endif
  return 79;
}

}  // namespace

ProgressLine::ProgressLine(bool enabled) : enabled_(enabled && is_terminal()) {}

void ProgressLine::phase(std::string_view text) {
  watch_ = Stopwatch();
  last_draw_ = rate_ = rate_time_ = 0;
  rate_vertices_ = 0;
  draw(std::string(text));
}

void ProgressLine::update(const Progress& progress) {
  if (!enabled_) return;
  const double now = watch_.total();
  if (now < last_draw_ + kRedraw) return;
  last_draw_ = now;
  if (rate_vertices_ == 0) {
    rate_vertices_ = progress.vertices;
    rate_time_ = now;
  } else if (now >= rate_time_ + kRateInterval || rate_ == 0) {
    rate_ = static_cast<double>(progress.vertices - rate_vertices_) / (now - rate_time_);
    if (now >= rate_time_ + kRateInterval) {
      rate_vertices_ = progress.vertices;
      rate_time_ = now;
    }
  }
  const std::string rate = rate_ > 0 ? fmt::format(" (+{}/s)", grouped(static_cast<std::uint64_t>(rate_))) : "";
  draw(fmt::format("refining: {} vertices{}, low quality {} of {}, {:.0f} s", grouped(progress.vertices), rate,
                   grouped(progress.low_quality), grouped(progress.simplices), now));
}

void ProgressLine::draw(std::string text) {
  if (!enabled_) return;
  text.resize(std::min(text.size(), terminal_width()));
  fmt::print(stderr, "\r{}\x1b[K", text);
  std::fflush(stderr);
  drawn_ = true;
}

void ProgressLine::erase() {
  if (!drawn_) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace sinkmesh::program
