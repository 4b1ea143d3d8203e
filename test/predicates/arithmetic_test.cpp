// SPDX-License-Identifier: MIT
//
// The exact numbers under the predicates: rounding errors, expansions, fixed-width integers, scaled
// differences.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "predicates/detail/expansion.h"
#include "predicates/detail/fixed_int.h"
#include "predicates/detail/grid.h"
#include "predicates/detail/scaled_integers.h"
#include "test/support/clouds.h"

namespace sinkmesh {
namespace {

using namespace detail;
using namespace test;

double random_double(Random& random, int low, int high) {
  const double m = random() % 2 != 0 ? uniform(random, 1, 2) : 1 + 0.25 * uniform_int(random, 0, 3);
  return std::ldexp(random() % 2 != 0 ? m : -m, uniform_int(random, low, high));
}

mpq_class exact(const TwoTerms& x) { return mpq_class(x.head) + mpq_class(x.tail); }
mpq_class exact(const Expansion& x) {
  mpq_class sum = 0;
  for (const double term : x.terms()) sum += mpq_class(term);
  return sum;
}

TEST(TwoTerms, HoldSumsDifferencesAndProductsExactly) {
  Random random(10);
  for (int i = 0; i < 20000; ++i) {
    const double a = random_double(random, -60, 60);
    const double b = random_double(random, -60, 60);
    ASSERT_EQ(exact(two_sum(a, b)), mpq_class(a) + mpq_class(b));
    ASSERT_EQ(exact(two_diff(a, b)), mpq_class(a) - mpq_class(b));
    ASSERT_EQ(exact(two_product(a, b)), mpq_class(a) * mpq_class(b));
    ASSERT_EQ(two_sum(a, b).head, a + b);
    if (std::abs(a) >= std::abs(b)) {
      ASSERT_EQ(exact(fast_two_sum(a, b)), mpq_class(a) + mpq_class(b));
    }
  }
}

void expect_invariant(const Expansion& x) {
  for (std::size_t i = 0; i < x.terms().size(); ++i) {
    ASSERT_NE(x.terms()[i], 0);
    if (i == 0) continue;
    // Nonoverlapping: the larger term is a multiple of a power of two above the smaller.
    const double small = x.terms()[i - 1];
    const double large = x.terms()[i];
    ASSERT_EQ(std::remainder(large, std::ldexp(1.0, std::ilogb(small) + 1)), 0);
  }
}

TEST(Expansion, IsARing) {
  Random random(11);
  for (int i = 0; i < 3000; ++i) {
    Expansion x;
    mpq_class q = 0;
    for (int step = 0; step < 8; ++step) {
      const double a = random_double(random, -30, 30);
      const Expansion y = Expansion(a) + Expansion(random_double(random, -80, 10));
      const std::uint64_t operation = random() % 3;
      const bool is_product = operation == 2;
      switch (operation) {
        case 0:
          q += exact(y);
          x = x + y;
          break;
        case 1:
          q -= exact(y);
          x = x - y;
          break;
        default:
          q *= exact(y);
          x = x * y;
      }
      ASSERT_EQ(exact(x), q);
      ASSERT_EQ(x.sign(), sgn(q));
      expect_invariant(x);
      if (is_product) {
        // Compressed: every term but the last two holds at least 52 bits.
        ASSERT_LE(x.terms().size(), mpz_sizeinbase(q.get_num_mpz_t(), 2) / 52 + 2);
      }
      // Every y is a multiple of 2^-132: after more steps the square would have bits below 2^-1074.
      if (step == 3) {
        const mpq_class square = q * q;
        ASSERT_EQ(exact(x * x), square);
      }
    }
    ASSERT_EQ((x - x).sign(), 0);
    ASSERT_TRUE((x - x).terms().empty());
    ASSERT_EQ((x * Expansion()).sign(), 0);
  }
}

template <int Bits>
mpz_class exact(const FixedInt<Bits>& x) {
  mpz_class value = 0;
  for (std::size_t i = FixedInt<Bits>::kLimbs; i-- > 0;) {
    value <<= 32;
    value += static_cast<unsigned long>(x.limbs[i] >> 32);
    value <<= 32;
    value += static_cast<unsigned long>(x.limbs[i] & 0xffffffff);
  }
  if (x.is_negative()) value -= mpz_class(1) << (64 * FixedInt<Bits>::kLimbs);
  return value;
}

/// Random, or one of the extremes: 0, +-1, +-2^k, +-(2^k - 1).
template <int Bits>
FixedInt<Bits> random_integer(Random& random) {
  static_assert(Bits <= 126);
  Int128 x = static_cast<Int128>(random()) << 64 | static_cast<Int128>(random());
  const int k = uniform_int(random, 0, Bits);
  switch (random() % 3) {
    case 0:
      x = static_cast<Int128>(1) << k;
      break;
    case 1:
      x = (static_cast<Int128>(1) << k) - 1;
      break;
    default:
      x = x >> (127 - k);
  }
  return FixedInt<Bits>(random() % 2 != 0 ? x : -x);
}

template <int A, int B>
void expect_ring_operations(Random& random) {
  const auto a = random_integer<A>(random);
  const auto b = random_integer<B>(random);
  ASSERT_EQ(exact(a + b), exact(a) + exact(b));
  ASSERT_EQ(exact(a - b), exact(a) - exact(b));
  ASSERT_EQ(exact(a * b), exact(a) * exact(b));
  ASSERT_EQ(a.sign(), sgn(exact(a)));
  const auto longer = a * b - b;
  ASSERT_EQ(exact(longer * a), exact(longer) * exact(a));
  ASSERT_EQ(exact(a + longer), exact(longer) + exact(a));
  ASSERT_EQ(exact(a - longer), exact(a) - exact(longer));
  const auto square = longer * longer;
  ASSERT_EQ(exact(square), exact(longer) * exact(longer));
  ASSERT_EQ(exact(square * longer), exact(square) * exact(longer));
  ASSERT_EQ(square.sign(), sgn(exact(longer)) * sgn(exact(longer)));
}

TEST(FixedInt, IsARing) {
  Random random(12);
  for (int i = 0; i < 3000; ++i) {
    expect_ring_operations<62, 62>(random);
    expect_ring_operations<123, 123>(random);
    expect_ring_operations<62, 123>(random);
    expect_ring_operations<126, 62>(random);
    expect_ring_operations<63, 64>(random);
  }
}

TEST(FixedInt, HasRoomForItsBound) {
  EXPECT_EQ(FixedInt<62>::kLimbs, 1u);  // +2^62 and -2^62
  EXPECT_EQ(FixedInt<63>::kLimbs, 2u);
  EXPECT_EQ(FixedInt<126>::kLimbs, 2u);
  EXPECT_EQ(FixedInt<127>::kLimbs, 3u);
}

TEST(FixedInt, ExtendsTheSignIntoEveryLimb) {
  const Int128 low = -(static_cast<Int128>(1) << 126);
  for (const Int128 x : {Int128{-1}, low, Int128{1}, -low}) {
    EXPECT_EQ(exact(FixedInt<250>(x)), exact(FixedInt<126>(x)));
    EXPECT_EQ(FixedInt<250>(x).sign(), x < 0 ? -1 : 1);
  }
}

// The widths of the derivation: in-sphere 5 and 10 limbs, diametral 6 and 12, orthogonality 8 and 16.
template <class P, int Bits>
constexpr std::size_t kLimbs = decltype(P::value(Vectors<P, FixedInt<Bits>>{}))::kLimbs;
TEST(FixedInt, HasTheDerivedWidths) {
  EXPECT_EQ((kLimbs<InSphere<3>, kBits64>), 5u);
  EXPECT_EQ((kLimbs<InSphere<3>, kBits128>), 10u);
  EXPECT_EQ((kLimbs<Diametral<3>, kBits64>), 6u);
  EXPECT_EQ((kLimbs<Diametral<3>, kBits128>), 12u);
  EXPECT_EQ((kLimbs<Orthogonality<3>, kBits64>), 8u);
  EXPECT_EQ((kLimbs<Orthogonality<3>, kBits128>), 16u);
}

TEST(ToInteger, AcceptsExactlyTheIntegers) {
  Random random(13);
  for (int i = 0; i < 20000; ++i) {
    const double x = random_double(random, -60, 122);
    const bool integral = std::trunc(x) == x;
    Int128 wide = 0;
    ASSERT_EQ(to_integer(x, wide), integral) << x;
    if (integral) {
      ASSERT_EQ(exact(FixedInt<123>(wide)), mpz_class(x));
    }
    if (std::abs(x) >= 0x1p62) continue;
    std::int64_t narrow = 0;
    ASSERT_EQ(to_integer(x, narrow), integral) << x;
    if (integral) {
      ASSERT_EQ(static_cast<double>(narrow), x);
    }
  }
}

// The scale fills the width: a set that needs all 62 (123) bits passes, one more bit fails.
TEST(ScaledIntegers, UseTheWholeWidth) {
  using P = Orientation<2>;
  const auto differences = [](int bits) {
    static std::vector<Point2> points;
    points = {{1, 0}, {std::ldexp(1.0, -bits), 0}, {0, 0}};
    return Points<P>{&points[0], &points[1], &points[2]};
  };
  Vectors<P, FixedInt<kBits64>> narrow;
  EXPECT_EQ((scaled_integers<P, kBits64>(differences(61), narrow)), 0x1p61);
  EXPECT_EQ(exact(narrow[0][0]), mpz_class(1) << 61);
  EXPECT_EQ(exact(narrow[1][0]), 1);
  EXPECT_EQ((scaled_integers<P, kBits64>(differences(62), narrow)), 0);
  Vectors<P, FixedInt<kBits128>> wide;
  EXPECT_EQ((scaled_integers<P, kBits128>(differences(122), wide)), 0x1p122);
  EXPECT_EQ(exact(wide[0][0]), mpz_class(1) << 122);
  EXPECT_EQ(exact(wide[1][0]), 1);
  EXPECT_EQ((scaled_integers<P, kBits128>(differences(123), wide)), 0);
}

// 1 - 2^-60 needs a tail.
TEST(ScaledIntegers, AddTheTails) {
  using P = Orientation<2>;
  const std::vector<Point2> points{{1, 0}, {0, 0}, {0x1p-60, 0}};
  Vectors<P, FixedInt<kBits64>> v;
  EXPECT_EQ((scaled_integers<P, kBits64>({&points[0], &points[1], &points[2]}, v)), 0x1p61);
  EXPECT_EQ(exact(v[0][0]), (mpz_class(1) << 61) - 2);
}

TEST(FractionBits, AreThoseOfTheLowestSetBit) {
  EXPECT_EQ(fraction_bits(0), 0);
  EXPECT_EQ(fraction_bits(3), 0);
  EXPECT_EQ(fraction_bits(0x1p60), 0);
  EXPECT_EQ(fraction_bits(-0.5), 1);
  EXPECT_EQ(fraction_bits(1.25), 2);
  EXPECT_EQ(fraction_bits(0.1), 55);
  EXPECT_EQ(fraction_bits(0x1p-121), 121);
  EXPECT_EQ(fraction_bits(std::numeric_limits<double>::denorm_min()), 1074);
  EXPECT_EQ(fraction_bits(-3 * std::numeric_limits<double>::denorm_min()), 1074);
  EXPECT_EQ(fraction_bits(2 * std::numeric_limits<double>::denorm_min()), 1073);
}

}  // namespace
}  // namespace sinkmesh
