// SPDX-License-Identifier: MIT
//
// Equal points, one id: for formats that repeat the coordinates at every corner.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "predicates/point.h"

namespace sinkmesh::io_detail {

/// Gives equal points the id of their first occurrence. Equal as numbers, with no tolerance; -0 equals 0.
class PointMerger {
 public:
  /// @param expected  number of points to come, duplicates included.
  explicit PointMerger(std::size_t expected)
      : slots_(std::bit_ceil(2 * (expected / 4) + 16), kEmpty), mask_(slots_.size() - 1) {}

  std::uint32_t id_of(const Point3& p) {
    if (2 * points_.size() >= slots_.size()) grow();
    std::uint32_t& slot = find(p);
    if (slot == kEmpty) {
      slot = static_cast<std::uint32_t>(points_.size());
      points_.push_back(p);
    }
    return slot;
  }

  std::vector<Point3> take() { return std::move(points_); }

 private:
  static constexpr std::uint32_t kEmpty = ~std::uint32_t{0};

  static std::uint64_t hash(const Point3& p) {
    std::uint64_t h = 0;
    for (const double x : p) {
      // -0.0 + 0.0 is +0.0. The constant is 2^64 over the golden ratio.
      h = (h ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9e3779b97f4a7c15U;
      h ^= h >> 29;
    }
    return h;
  }
  // The slot of p, or the free one where it belongs. At least half of the slots are free.
  std::uint32_t& find(const Point3& p) {
    std::size_t i = hash(p) & mask_;
    while (slots_[i] != kEmpty && points_[slots_[i]] != p) i = (i + 1) & mask_;
    return slots_[i];
  }
  void grow() {
    slots_.assign(2 * slots_.size(), kEmpty);
    mask_ = slots_.size() - 1;
    for (std::uint32_t id = 0; id < points_.size(); ++id) find(points_[id]) = id;
  }

  std::vector<Point3> points_;
  std::vector<std::uint32_t> slots_;
  std::size_t mask_;
};

}  // namespace sinkmesh::io_detail
