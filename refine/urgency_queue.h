// SPDX-License-Identifier: MIT
//
// The queue of the incremental schedule: simplices of low quality, the most urgent first.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/handles.h"

namespace sinkmesh {

/// A simplex that waits.
struct UrgencyEntry {
  double priority;  ///< at least 1, may be infinite
  Simplex simplex;
  std::uint32_t birth;    ///< tells the simplex from others in the same slot
  std::uint64_t tie = 0;  ///< orders entries of equal priority; the queue asks for it
};

/// Entries for simplices that have died in the meantime stay until they are met. There are many of them, so a
/// single heap would spend most of its time on the dead; instead entries wait unsorted in buckets by exponent
/// and two bits of the mantissa of the priority, and only the highest bucket becomes a heap, from what is then
/// alive [SN, 4].
///
/// @tparam TieOf  called with an entry whose simplex lives: a function of the geometry. Only asked for what
///                comes into a heap, since most entries die before.
template <class TieOf>
class UrgencyQueue {
 public:
  using Entry = UrgencyEntry;

  explicit UrgencyQueue(TieOf tie_of) : tie_of_(std::move(tie_of)) {}

  /// An entry whose simplex lives.
  void push(const Entry& entry) {
    const std::size_t b = bucket_of(entry.priority);
    Bucket& bucket = buckets_[b];
    bucket.entries.push_back(entry);
    if (bucket.is_heap) {
      bucket.entries.back().tie = tie_of_(entry);
      std::push_heap(bucket.entries.begin(), bucket.entries.end(), is_less);
    }
    top_ = std::max(top_, b);
  }

  /// Takes out the first entry for which is_current(entry) holds; entries for which it does not are dropped.
  /// @return false if there is none.
  template <class IsCurrent>
  bool pop(Entry& entry, IsCurrent&& is_current) {
    for (;;) {
      Bucket& bucket = buckets_[top_];
      if (!bucket.is_heap) {
        std::erase_if(bucket.entries, [&](const Entry& e) { return !is_current(e); });
        for (Entry& e : bucket.entries) e.tie = tie_of_(e);
        std::make_heap(bucket.entries.begin(), bucket.entries.end(), is_less);
        bucket.is_heap = true;
      }
      while (!bucket.entries.empty()) {
        std::pop_heap(bucket.entries.begin(), bucket.entries.end(), is_less);
        entry = bucket.entries.back();
        bucket.entries.pop_back();
        if (is_current(entry)) return true;
      }
      bucket.is_heap = false;
      if (top_ == 0) return false;
      --top_;
    }
  }

 private:
  struct Bucket {
    std::vector<Entry> entries;
    bool is_heap = false;
  };

  static bool is_less(const Entry& a, const Entry& b) {
    return a.priority != b.priority ? a.priority < b.priority : a.tie < b.tie;
  }
  // Doubles of one sign order as their bits do; 2^50 steps are a quarter of a binade.
  static std::size_t bucket_of(double priority) {
    constexpr std::uint64_t kOne = std::bit_cast<std::uint64_t>(1.0) >> 50;
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(priority) >> 50;
    return bits < kOne ? 0 : static_cast<std::size_t>(bits - kOne);
  }

  TieOf tie_of_;
  std::array<Bucket, 4 * 1024 + 1> buckets_;
  std::size_t top_ = 0;
};

}  // namespace sinkmesh
