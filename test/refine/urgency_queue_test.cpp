// SPDX-License-Identifier: MIT
#include "refine/urgency_queue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <tuple>

namespace sinkmesh {
namespace {

using Entry = UrgencyEntry;

// A multiset is the oracle: pushes and pops in random order, with entries that die while they wait.
TEST(UrgencyQueue, PopsLivingEntriesByPriorityThenTie) {
  std::mt19937_64 random(3);
  std::vector<std::uint64_t> ties;
  std::vector<bool> is_dead;
  UrgencyQueue queue([&](const Entry& e) {
    EXPECT_FALSE(is_dead[e.simplex.index()]);
    return ties[e.simplex.index()];
  });
  using Key = std::tuple<double, std::uint64_t, std::uint32_t>;
  std::set<Key> alive;
  const auto is_current = [&](const Entry& e) { return !is_dead[e.simplex.index()]; };
  const auto pop_and_compare = [&] {
    Entry entry;
    const bool found = queue.pop(entry, is_current);
    ASSERT_EQ(found, !alive.empty());
    if (!found) return;
    ASSERT_EQ(entry.priority, std::get<0>(*alive.rbegin()));
    ASSERT_EQ(entry.tie, std::get<1>(*alive.rbegin()));
    alive.erase({entry.priority, entry.tie, entry.simplex.index()});
  };
  for (int step = 0; step < 20000; ++step) {
    if (random() % 5 < 3) {
      // Few distinct values, so that ties and infinities occur.
      const std::uint64_t pick = random() % 40;
      const double priority =
          pick == 0 ? std::numeric_limits<double>::infinity()
                    : std::ldexp(1 + static_cast<double>(pick % 8) / 8, static_cast<int>(pick / 8));
      const Entry entry{priority, Simplex(static_cast<std::uint32_t>(is_dead.size())), 0};
      is_dead.push_back(false);
      ties.push_back(random());
      alive.insert({entry.priority, ties.back(), entry.simplex.index()});
      queue.push(entry);
    } else if (random() % 2 == 0 && !alive.empty()) {
      auto victim = alive.begin();
      std::advance(victim, static_cast<std::ptrdiff_t>(random() % alive.size()));
      is_dead[std::get<2>(*victim)] = true;
      alive.erase(victim);
    } else {
      pop_and_compare();
    }
  }
  while (!alive.empty()) pop_and_compare();
  Entry entry;
  EXPECT_FALSE(queue.pop(entry, is_current));
}

}  // namespace
}  // namespace sinkmesh
