// SPDX-License-Identifier: MIT
//
// Two engines, one complex: facet for facet, on degenerate points of every kind, in any order; and the
// oracle's.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "core/triangulation.h"
#include "test/support/complexes.h"
#include "test/support/shapes.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class Dimension>
class Engines : public testing::Test {};
TYPED_TEST_SUITE(Engines, Dimensions, DimensionNames);

// Points with few coordinates are mostly collinear, coplanar or cospherical: the tie rules decide everything
// here.
TYPED_TEST(Engines, BuildTheOraclesComplexOfTenThousandGridClouds) {
  constexpr int Dim = TypeParam::value;
  Random random(2);
  int degenerate = 0;
  for (int trial = 0; trial < 10000; ++trial) {
    SCOPED_TRACE(testing::Message() << "cloud " << trial);
    const auto most = static_cast<std::size_t>(uniform_int(random, Dim + 1, 12));
    const auto points = grid_cloud<Dim>(most, uniform_int(random, -3, 1), uniform_int(random, 2, 6), random);
    const auto expected = brute_force_delaunay<Dim>(points);
    for (const Engine engine : kEngines) {
      const auto built = triangulate<Dim>(points, engine);
      ASSERT_EQ(built.has_value(), !expected.empty());
      if (!built) continue;
      ASSERT_EQ(simplex_sets(built->complex()), with_ghosts(expected));
      ASSERT_TRUE(built->validate().ok()) << built->validate();
    }
    degenerate += expected.empty() ? 1 : 0;
  }
  EXPECT_GT(degenerate, 10);
  EXPECT_LT(degenerate, 5000);
}

// Doubles of every kind: exact ties, near ties, two scales.
TYPED_TEST(Engines, BuildTheOraclesComplexOfCloudsOfEveryKind) {
  constexpr int Dim = TypeParam::value;
  Random random(3);
  for (const Cloud kind : kAllClouds) {
    for (int trial = 0; trial < 12; ++trial) {
      SCOPED_TRACE(testing::Message() << "cloud of kind " << static_cast<int>(kind) << ", " << trial);
      const auto points = make_cloud<Dim>(kind, 8, random);
      const auto expected = brute_force_delaunay_by_weights<Dim>(points);
      for (const Engine engine : kEngines) {
        const auto built = triangulate<Dim>(points, engine);
        ASSERT_EQ(built.has_value(), !expected.empty());
        if (built) {
          ASSERT_EQ(simplex_sets(built->complex()), with_ghosts(expected));
        }
      }
    }
  }
}

TYPED_TEST(Engines, AgreeOnEveryShapeInAnyOrder) {
  constexpr int Dim = TypeParam::value;
  Random random(4);
  for (const Shape shape : kShapes) {
    SCOPED_TRACE(testing::Message() << "shape " << static_cast<int>(shape));
    const auto points = make_shape<Dim>(shape, 1500, random);
    const Triangulation<Dim> star(points, Engine::star);
    EXPECT_TRUE(star.validate().ok()) << star.validate();
    const Triangulation<Dim> flips(points, Engine::flips);
    EXPECT_EQ(flips.hash(), star.hash());
    EXPECT_TRUE(simplex_sets(flips.complex()) == simplex_sets(star.complex()));
    EXPECT_TRUE(flips.validate().ok()) << flips.validate();

    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), random);
    std::vector<Point<Dim>> shuffled;
    for (const std::uint32_t i : order) shuffled.push_back(points[i]);
    const Triangulation<Dim> again(shuffled, shape == Shape::kUniform ? Engine::flips : Engine::star);
    EXPECT_EQ(again.hash(), star.hash());
    EXPECT_EQ(again.num_solid(), star.num_solid());
  }
}

// The order of the input must not show even where all is decided by ties; with the ids mapped back, because
// equal hashes alone would not show a hash that looks away.
TYPED_TEST(Engines, IgnoreTheOrderOfTheInput) {
  constexpr int Dim = TypeParam::value;
  Random random(5);
  const auto points = full_grid<Dim>(Dim == 2 ? 12 : 5);
  const auto expected = simplex_sets(Triangulation<Dim>(points).complex());
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), random);
    std::vector<Point<Dim>> shuffled;
    for (const std::uint32_t i : order) shuffled.push_back(points[i]);
    auto sets = simplex_sets(Triangulation<Dim>(shuffled, kEngines[trial % 2]).complex());
    for (auto& set : sets) {
      for (std::uint32_t& id : set) {
        if (id < order.size()) id = order[id];
      }
      std::sort(set.begin(), set.end());
    }
    std::sort(sets.begin(), sets.end());
    EXPECT_TRUE(sets == expected) << "order " << trial;
  }
}

}  // namespace
}  // namespace sinkmesh
