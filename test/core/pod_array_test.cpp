// SPDX-License-Identifier: MIT
#include "core/detail/pod_array.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace sinkmesh {
namespace {

using detail::PodArray;

// From this size on blocks are mapped (pages.cpp).
constexpr std::size_t kMapped = std::size_t{1} << 18;

struct Record {
  std::uint32_t word[8];
};

Record record_of(std::size_t i) {
  Record r;
  for (std::uint32_t k = 0; k < 8; ++k) r.word[k] = static_cast<std::uint32_t>(i) * 2654435761U + k;
  return r;
}

/// The first value that is not as it was written.
std::size_t first_wrong(const PodArray<Record>& array, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::uint32_t k = 0; k < 8; ++k) {
      if (array[i].word[k] != record_of(i).word[k]) return i;
    }
  }
  return count;
}

bool is_aligned(const PodArray<Record>& array) {
  return reinterpret_cast<std::uintptr_t>(array.data()) % 64 == 0;
}

TEST(PodArray, KeepsValuesWhileItGrowsOneByOne) {
  constexpr std::size_t kCount = 8 * kMapped / sizeof(Record);
  PodArray<Record> array;
  EXPECT_TRUE(array.empty());
  bool was_small = false;
  std::size_t moves = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const std::size_t before = array.capacity();
    array.push_back(record_of(i));
    if (array.capacity() == before) continue;
    ++moves;
    was_small = was_small || array.bytes() < kMapped;
    ASSERT_TRUE(is_aligned(array));
    ASSERT_EQ(first_wrong(array, i + 1), i + 1);
  }
  EXPECT_TRUE(was_small);
  EXPECT_GE(array.bytes(), 8 * kMapped);
  EXPECT_LT(moves, 40U) << "grows by a constant factor";
  EXPECT_EQ(array.size(), kCount);
  EXPECT_EQ(first_wrong(array, kCount), kCount);
}

// From heap to heap, heap to pages, at the border itself, pages to pages.
TEST(PodArray, KeepsValuesAcrossEverySizeOfBlock) {
  const std::size_t border = kMapped / sizeof(Record);
  for (const std::size_t from : {std::size_t{1}, border - 1, border, border + 1, 3 * border}) {
    for (const std::size_t to : {from + 1, border - 1, border, border + 1, 4 * border, 40 * border}) {
      PodArray<Record> array;
      array.reserve(from);
      array.resize(from);
      for (std::size_t i = 0; i < from; ++i) array[i] = record_of(i);
      array.reserve(to);
      EXPECT_GE(array.capacity(), std::max(from, to));
      EXPECT_EQ(array.size(), from);
      ASSERT_EQ(first_wrong(array, from), from) << from << " to " << to;
      EXPECT_TRUE(is_aligned(array));
    }
  }
}

TEST(PodArray, CopiesAreIndependent) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{10}, kMapped / sizeof(Record) + 10}) {
    PodArray<Record> array;
    for (std::size_t i = 0; i < count; ++i) array.push_back(record_of(i));
    PodArray<Record> copy = array;
    ASSERT_EQ(copy.size(), count);
    EXPECT_EQ(first_wrong(copy, count), count);
    for (Record& r : array) r.word[0] ^= 1;
    EXPECT_EQ(first_wrong(copy, count), count);
    array = copy;
    EXPECT_EQ(first_wrong(array, count), count);
    const auto& same = array;
    array = same;
    EXPECT_EQ(array.size(), count);
    EXPECT_EQ(first_wrong(array, count), count);
  }
}

TEST(PodArray, MovesTakeTheBlockAndLeaveNothing) {
  PodArray<Record> array;
  for (std::size_t i = 0; i < 100; ++i) array.push_back(record_of(i));
  const Record* const block = array.data();
  PodArray<Record> taker = std::move(array);
  EXPECT_EQ(taker.data(), block);
  EXPECT_EQ(first_wrong(taker, 100), 100U);
  PodArray<Record> other;
  other.push_back(record_of(7));
  other = std::move(taker);
  EXPECT_EQ(other.data(), block);
  EXPECT_EQ(other.size(), 100U);
  PodArray<Record> third;
  third.swap(other);
  EXPECT_EQ(third.data(), block);
  EXPECT_TRUE(other.empty());
}

TEST(PodArray, TakesItsOwnElementWhileItGrows) {
  PodArray<std::uint64_t> array;
  array.push_back(42);
  while (array.bytes() < 2 * kMapped) array.push_back(array[0]);
  for (const std::uint64_t x : array) ASSERT_EQ(x, 42U);
}

TEST(PodArray, ResizesWithAndWithoutAValue) {
  PodArray<std::uint32_t> array;
  array.resize(5, 7);
  array.resize(3);
  array.resize(8, 9);
  EXPECT_EQ(std::vector(array.begin(), array.end()), (std::vector<std::uint32_t>{7, 7, 7, 9, 9, 9, 9, 9}));
  EXPECT_EQ(array.back(), 9U);
  array.pop_back();
  EXPECT_EQ(array.size(), 7U);
  const std::size_t capacity = array.capacity();
  array.clear();
  EXPECT_TRUE(array.empty());
  EXPECT_EQ(array.capacity(), capacity);
  EXPECT_EQ(array.bytes(), capacity * sizeof(std::uint32_t));
}

}  // namespace
}  // namespace sinkmesh
