// SPDX-License-Identifier: MIT
//
// The frame of the stress tests: cases come back from their files, failures of every kind are seen, shrinking
// keeps them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "test/stress/case.h"
#include "test/stress/child.h"
#include "test/stress/shrink.h"
#include "test/stress/text.h"

namespace sinkmesh::stress {
namespace {

Case sample() {
  Case c;
  c.suite = "sample";
  c.seed = 7;
  c.number = 12;
  c.set("name", "two words");
  c.set("number", std::uint64_t{18446744073709551615U});
  c.rows = {{0.1, -0.0, 5e-324}, {}, {std::numeric_limits<double>::max(), HUGE_VAL}};
  return c;
}

TEST(StressCase, ComesBackFromItsText) {
  const Case c = parse_case(to_text(sample()), "sample.case");
  EXPECT_EQ(c, sample());
  EXPECT_TRUE(std::signbit(c.rows[0][1]));
  EXPECT_EQ(c.number_setting("number"), 18446744073709551615U);
  EXPECT_EQ(c.setting("name"), "two words");
}

TEST(StressCase, ErrorsNameTheLine) {
  for (const char* text : {"suite a\nrow 1 x\n", "suite a\nseed -1\n", "suite a\nwhat 1\n", "suite a\nset\n"}) {
    try {
      parse_case(text, "f");
      ADD_FAILURE() << text;
    } catch (const CaseError& error) {
      EXPECT_EQ(std::string(error.what()).substr(0, 4), "f:2:") << error.what();
    }
  }
  EXPECT_THROW(parse_case("row 1\n", "f"), CaseError);
}

TEST(StressCase, IsRecordedForTheParent) {
  SharedState state;
  state.record(sample());
  EXPECT_EQ(state.recorded(), sample());
}

/// Fails in as many ways as there are rows.
class Failing : public Suite {
 public:
  std::string name() const override { return "failing"; }
  void generate(Random&, Case&) override {}
  bool accepts(const Case&) const override { return true; }
  unsigned seconds_per_case() const override { return 1; }
  std::string check(const Case& c, Counters&) override {
    switch (c.rows.size()) {
      case 0:
        return "";
      case 1:
        return "wrong: found 1, expected 2";
      case 2:
        expect_equal("thrown", 1, 2);
        return "";
      case 3:
        throw std::runtime_error("surprise");
      case 4:
        std::abort();
      case 5:
        _exit(3);
      default:
        for (volatile bool on = true; on;) {
        }
        return "";
    }
  }
};

TEST(StressChild, TellsHowACheckFailed) {
  Failing suite;
  Case c;
  const auto failure = [&](std::size_t rows) {
    c.rows.resize(rows);
    return check_in_child(suite, c, true);
  };
  EXPECT_EQ(failure(0), "");
  EXPECT_EQ(failure(1), "wrong: found 1, expected 2");
  EXPECT_EQ(failure(2), "thrown: found 1, expected 2");
  EXPECT_EQ(failure(3), "exception: surprise");
  EXPECT_EQ(failure(4).substr(0, 9), "signal 6:");
  EXPECT_EQ(failure(5).substr(0, 14), "exit status 3:");
  EXPECT_EQ(failure(6), "signal 14: the check does not end");
}

TEST(StressShrink, KeepsTheRowsAndBitsThatMatter) {
  Case c;
  for (int i = 0; i < 40; ++i) c.rows.push_back({0.3 * i, 1.7 * i + 0.1});
  // Two rows with numbers above 5 in the same place.
  const auto fails = [](const Case& candidate) {
    return std::count_if(candidate.rows.begin(), candidate.rows.end(),
                         [](const auto& r) { return r[0] > 5; }) >= 2;
  };
  ASSERT_TRUE(fails(c));
  const Case smallest = shrink(c, 10, fails);
  ASSERT_EQ(smallest.rows.size(), 2U);
  for (const auto& row : smallest.rows) {
    EXPECT_EQ(row[0], std::nearbyint(row[0]));
    EXPECT_EQ(row[1], 0);
  }
}

}  // namespace
}  // namespace sinkmesh::stress
