// SPDX-License-Identifier: MIT
//
// The self-test must pass here, and notice what it is for.
#include "predicates/self_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cfenv>
#include <string>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace sinkmesh {
namespace {

using ::testing::HasSubstr;

TEST(SelfTest, PassesInThisBuild) { EXPECT_EQ(predicates_self_test(), ""); }

TEST(SelfTest, NoticesEveryOtherRoundingMode) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    const std::string message = predicates_self_test();
    std::fesetround(FE_TONEAREST);
    EXPECT_THAT(message, HasSubstr("rounding mode"));
  }
}

#if defined(__x86_64__)
TEST(SelfTest, NoticesFlushToZero) {
  const unsigned saved = _mm_getcsr();
  for (const unsigned mode : {0x8000u, 0x0040u}) {  // results; operands
    _mm_setcsr(saved | mode);
    const std::string message = predicates_self_test();
    _mm_setcsr(saved);
    EXPECT_THAT(message, HasSubstr("subnormal"));
  }
}
#endif

}  // namespace
}  // namespace sinkmesh
