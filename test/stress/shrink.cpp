// SPDX-License-Identifier: MIT
#include "test/stress/shrink.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <utility>

namespace sinkmesh::stress {
namespace {

class Shrinker {
 public:
  using Clock = std::chrono::steady_clock;

  Shrinker(Case c, double seconds, const std::function<bool(const Case&)>& fails)
      : best_(std::move(c)), fails_(fails), start_(Clock::now()), seconds_(seconds) {}

  Case run() {
    for (bool smaller = true; smaller && in_time();) {
      smaller = drop_rows();
      smaller |= simplify_all();
      smaller |= simplify_numbers();
    }
    return best_;
  }

 private:
  bool in_time() const { return std::chrono::duration<double>(Clock::now() - start_).count() < seconds_; }

  bool take(Case candidate) {
    if (!in_time() || candidate == best_ || !fails_(candidate)) return false;
    best_ = std::move(candidate);
    return true;
  }

  /// Chunks of rows, from halves to single ones.
  bool drop_rows() {
    bool dropped = false;
    for (std::size_t chunk = best_.rows.size() / 2; chunk > 0; chunk /= 2) {
      for (std::size_t first = 0; first < best_.rows.size() && in_time();) {
        Case candidate = best_;
        const auto begin = candidate.rows.begin() + static_cast<std::ptrdiff_t>(first);
        const std::size_t n = std::min(chunk, candidate.rows.size() - first);
        candidate.rows.erase(begin, begin + static_cast<std::ptrdiff_t>(n));
        if (take(std::move(candidate))) {
          dropped = true;
        } else {
          first += chunk;
        }
      }
    }
    return dropped;
  }

  template <class Change>
  bool change_all(Change change) {
    Case candidate = best_;
    for (auto& row : candidate.rows) {
      for (std::size_t k = 0; k < row.size(); ++k) row[k] = change(row[k], k);
    }
    return take(std::move(candidate));
  }

  /// What keeps most properties of point sets: the first point to the origin, another unit, fewer bits.
  bool simplify_all() {
    bool simpler = false;
    if (!best_.rows.empty()) {
      const std::vector<double> origin = best_.rows.front();
      simpler |= change_all([&](double x, std::size_t k) { return k < origin.size() ? x - origin[k] : x; });
    }
    double largest = 0;
    for (const auto& row : best_.rows) {
      for (const double x : row) largest = std::max(largest, std::abs(x));
    }
    if (largest > 0 && std::isfinite(largest)) {
      const int e = std::ilogb(largest);
      if (e != 0) simpler |= change_all([&](double x, std::size_t) { return std::ldexp(x, -e); });
    }
    for (const int bits : {4, 8, 16, 32}) {
      if (change_all([&](double x, std::size_t) { return with_bits(x, bits); })) return true;
    }
    return simpler;
  }

  bool simplify_numbers() {
    bool simpler = false;
    for (std::size_t i = 0; i < best_.rows.size(); ++i) {
      for (std::size_t k = 0; k < best_.rows[i].size() && in_time(); ++k) simpler |= simplify(i, k);
    }
    return simpler;
  }

  /// Candidates from the simplest on; none that is not simpler than what is there, so that this ends.
  bool simplify(std::size_t i, std::size_t k) {
    const double x = best_.rows[i][k];
    if (x == 0) return false;
    const auto replace = [&](double y) {
      if (y == x || !std::isfinite(y)) return false;
      Case candidate = best_;
      candidate.rows[i][k] = y;
      return take(std::move(candidate));
    };
    if (replace(0)) return true;
    if (x != 1 && x != -1 && (replace(std::copysign(1, x)))) return true;
    if (std::abs(x) < 1e6 && x != std::nearbyint(x) && replace(std::nearbyint(x))) return true;
    for (const int bits : {1, 2, 4, 8, 16, 24, 32, 40, 48, 50, 51, 52}) {
      if (replace(with_bits(x, bits))) return true;
    }
    return false;
  }

  /// Towards zero.
  static double with_bits(double x, int bits) {
    if (x == 0 || !std::isfinite(x)) return x;
    const int shift = bits - 1 - std::ilogb(x);
    return std::ldexp(std::trunc(std::ldexp(x, shift)), -shift);
  }

  Case best_;
  const std::function<bool(const Case&)>& fails_;
  Clock::time_point start_;
  double seconds_;
};

}  // namespace

Case shrink(Case c, double seconds, const std::function<bool(const Case&)>& fails) {
  return Shrinker(std::move(c), seconds, fails).run();
}

}  // namespace sinkmesh::stress
