// SPDX-License-Identifier: MIT
#include "core/spatial_order.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

#include "core/hilbert.h"
#include "core/mix.h"

namespace sinkmesh {
namespace {

constexpr std::uint32_t kRounds = 16;
constexpr std::uint64_t kIndexMask = 0xffffffff;

// The last round is kRounds-1; each zero octal digit at the end of the hash puts a point one round earlier.
template <int Dim>
std::uint32_t round_of(const Point<Dim>& p) {
  const auto zeros = static_cast<std::uint32_t>(std::countr_zero(hash_point<Dim>(p)));
  return kRounds - 1 - std::min(zeros / 3, kRounds - 1);
}

// Maps points to places along the curve in the cube around a box. A place only orders points; rounding does no
// harm.
template <int Dim>
class Places {
 public:
  explicit Places(const Box<Dim>& box) : low_(box.low) {
    double extent = 0;
    for (std::size_t k = 0; k < Dim; ++k) extent = std::max(extent, box.high[k] - box.low[k]);
    scale_ = extent > 0 ? kCells / extent : 0;
    // Behind the input gate 1/extent is at most 2^121; without the gate an overflow would merge all cells.
  }
  std::uint64_t operator()(const Point<Dim>& p) const {
    std::array<std::uint32_t, Dim> cell;
    for (std::size_t k = 0; k < Dim; ++k) {
      cell[k] = static_cast<std::uint32_t>(std::min((p[k] - low_[k]) * scale_, kCells - 1));
    }
    return HilbertCurve<Dim>::index(cell);
  }

 private:
  static constexpr double kCells = std::uint32_t{1} << HilbertCurve<Dim>::kLevels;
  Point<Dim> low_;
  double scale_;
};

// Sorts keys (place << 32 | index) by place: three passes of ten bits each.
void sort_by_place(std::span<std::uint64_t> keys, std::vector<std::uint64_t>& buffer) {
  constexpr std::size_t kSmall = 2048;
  if (keys.size() < kSmall) {
    std::sort(keys.begin(), keys.end());
    return;
  }
  constexpr int kDigits = 10;
  buffer.resize(keys.size());
  std::span<std::uint64_t> from = keys;
  std::span<std::uint64_t> to = buffer;
  for (int shift = 32; shift < 62; shift += kDigits) {
    std::array<std::uint32_t, 1U << kDigits> start{};
    const auto digit = [shift](std::uint64_t key) { return key >> shift & ((1U << kDigits) - 1); };
    for (const std::uint64_t key : from) ++start[digit(key)];
    std::uint32_t sum = 0;
    for (std::uint32_t& count : start) sum += std::exchange(count, sum);
    for (const std::uint64_t key : from) to[start[digit(key)]++] = key;
    std::swap(from, to);
  }
  if (from.data() != keys.data()) std::copy(from.begin(), from.end(), keys.begin());
}

template <int Dim>
class Sorter {
 public:
  explicit Sorter(std::span<const Point<Dim>> points) : points_(points) {}

  /// Orders `indices` along the curve through `box`, recursively. The recursion ends: the two points that span
  /// the longest side of a box that is not a point are in different cells, so every run is shorter than its
  /// parent.
  void sort(std::span<std::uint32_t> indices, const Box<Dim>& box) {
    const Places<Dim> place(box);
    std::vector<std::uint64_t> keys(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) keys[i] = place(points_[indices[i]]) << 32 | indices[i];
    sort_by_place(keys, buffer_);
    for (std::size_t i = 0; i < indices.size(); ++i)
      indices[i] = static_cast<std::uint32_t>(keys[i] & kIndexMask);

    constexpr std::size_t kAhead = 16;
    for (std::size_t first = 0; first < keys.size();) {
      std::size_t last = first + 1;
      while (last < keys.size() && keys[last] >> 32 == keys[first] >> 32) {
        // The points of a run lie anywhere in memory; their coordinates will be compared.
        __builtin_prefetch(&points_[indices[std::min(last + kAhead, keys.size() - 1)]]);
        ++last;
      }
      if (last - first > 1) sort_run(indices.subspan(first, last - first));
      first = last;
    }
  }

 private:
  void sort_run(std::span<std::uint32_t> run) {
    constexpr std::size_t kShort = 32;
    if (run.size() > kShort) {
      Box<Dim> box;
      for (const std::uint32_t i : run) box.include(points_[i]);
      if (box.low != box.high) return sort(run, box);
    }
    std::sort(run.begin(), run.end(), [this](std::uint32_t a, std::uint32_t b) {
      return points_[a] != points_[b] ? points_[a] < points_[b] : a < b;
    });
  }

  std::span<const Point<Dim>> points_;
  std::vector<std::uint64_t> buffer_;
};

}  // namespace

template <int Dim>
InsertionOrder insertion_order(std::span<const Point<Dim>> points, const Box<Dim>& box) {
  std::array<std::uint32_t, kRounds + 1> start{};
  std::vector<std::uint8_t> round(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    round[i] = static_cast<std::uint8_t>(round_of<Dim>(points[i]));
    ++start[round[i] + 1U];
  }
  for (std::size_t r = 0; r < kRounds; ++r) start[r + 1] += start[r];

  std::vector<std::uint32_t> indices(points.size());
  auto next = start;
  for (std::uint32_t i = 0; i < points.size(); ++i) indices[next[round[i]]++] = i;
  Sorter<Dim> sorter(points);
  for (std::size_t r = 0; r < kRounds; ++r) {
    sorter.sort(std::span(indices).subspan(start[r], start[r + 1] - start[r]), box);
  }

  // Equal points have the same hash, hence the same round, and the same place: they are neighbours, first one
  // first.
  InsertionOrder result;
  std::size_t kept = 0;
  for (const std::uint32_t i : indices) {
    if (kept > 0 && points[indices[kept - 1]] == points[i]) {
      result.duplicates.push_back({i, indices[kept - 1]});
    } else {
      indices[kept++] = i;
    }
  }
  indices.resize(kept);
  std::sort(result.duplicates.begin(), result.duplicates.end(),
            [](const auto& a, const auto& b) { return a.copy < b.copy; });
  result.order = std::move(indices);
  return result;
}

template InsertionOrder insertion_order<2>(std::span<const Point2>, const Box<2>&);
template InsertionOrder insertion_order<3>(std::span<const Point3>, const Box<3>&);

}  // namespace sinkmesh
