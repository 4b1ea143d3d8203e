// SPDX-License-Identifier: MIT
//
// The oracle itself: two versions that share only the lifting, and worked examples.
#include "test/support/brute_force.h"

#include "test/support/brute_force_doubles.h"
#include "test/support/complexes.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class Dimension>
class BruteForce : public testing::Test {};
TYPED_TEST_SUITE(BruteForce, Dimensions, DimensionNames);

TYPED_TEST(BruteForce, SymbolicWeightsAgreeWithExplicitOnes) {
  constexpr int Dim = TypeParam::value;
  Random random(1);
  std::size_t simplices = 0;
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    const auto points = grid_cloud<Dim>(8, -2, 4, random);
    const auto expected = brute_force_delaunay_by_weights<Dim>(points);
    ASSERT_EQ(brute_force_delaunay<Dim>(points), expected);
    simplices += expected.size();
  }
  EXPECT_GT(simplices, 1000U);
}

TYPED_TEST(BruteForce, IsTheSameForDoublesByIntegers) {
  constexpr int Dim = TypeParam::value;
  Random random(2);
  for (const Cloud kind : kAllClouds) {
    for (int trial = 0; trial < 8; ++trial) {
      SCOPED_TRACE(testing::Message() << "kind " << static_cast<int>(kind) << ", " << trial);
      const auto points = make_cloud<Dim>(kind, 7, random);
      ASSERT_EQ(brute_force_delaunay_of_doubles<Dim>(points), brute_force_delaunay_by_weights<Dim>(points));
    }
  }
}

TYPED_TEST(BruteForce, FillsTheHullOfAGrid) {
  constexpr int Dim = TypeParam::value;
  const auto points = full_grid<Dim>(Dim == 2 ? 4 : 3);
  std::int64_t volume = 0;
  for (const auto& ids : brute_force_delaunay<Dim>(points)) {
    std::array<Point<Dim>, Dim + 1> p;
    for (std::size_t i = 0; i <= Dim; ++i) p[i] = points[ids[i]];
    volume += std::abs(integer_volume<Dim>(p));
  }
  EXPECT_EQ(volume, Dim == 2 ? 2 * 9 : 6 * 8);
}

// [PS, 12]: the unit cube, ids 4x+2y+z, in the order of ranks.
TEST(BruteForceOfTheCube, IsTheWorkedExample) {
  const std::vector<IdSet<4>> expected{{0, 1, 2, 4}, {1, 2, 3, 4}, {1, 3, 4, 5},
                                       {2, 3, 4, 6}, {3, 4, 5, 6}, {3, 5, 6, 7}};
  EXPECT_EQ(brute_force_delaunay<3>(full_grid<3>(2)), expected);
}

}  // namespace
}  // namespace sinkmesh
