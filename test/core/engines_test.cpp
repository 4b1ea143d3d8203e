// SPDX-License-Identifier: MIT
//
// Two engines, one complex: facet for facet, on degenerate points of every kind, in any order; and the
// oracle's.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "core/triangulation.h"
#include "test/support/complexes.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class Dimension>
class Engines : public testing::Test {};
TYPED_TEST_SUITE(Engines, Dimensions, DimensionNames);

/// The complex of the points if they span the space.
template <int Dim>
std::optional<Triangulation<Dim>> triangulate(const std::vector<Point<Dim>>& points, Engine engine) {
  try {
    return Triangulation<Dim>(points, engine);
  } catch (const DegenerateInput&) {
    return std::nullopt;
  }
}

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

/// Larger sets, too many for the oracle.
enum class Shape {
  kGrid,            ///< all points of a grid
  kSphere,          ///< rounded onto a sphere
  kIntegerSphere,   ///< exactly cospherical
  kFlatPlusOne,     ///< on a hyperplane, and one point beside it
  kLinePlusFew,     ///< collinear, and three points beside the line
  kCylinder,        ///< rings of exactly cocircular points; in the plane two columns
  kTwoHyperplanes,  ///< grids on two parallel ones
  kClusters,        ///< around a few centres, at very different scales
  kFineSpacing,     ///< a grid of spacing 1e-9 far from the origin
  kUniform,
};
constexpr std::array kShapes{Shape::kGrid,        Shape::kSphere,   Shape::kIntegerSphere,  Shape::kFlatPlusOne,
                             Shape::kLinePlusFew, Shape::kCylinder, Shape::kTwoHyperplanes, Shape::kClusters,
                             Shape::kFineSpacing, Shape::kUniform};

template <int Dim>
std::vector<Point<Dim>> make_shape(Shape shape, Random& random) {
  std::vector<Point<Dim>> points;
  const auto add = [&](auto coordinate) {
    Point<Dim>& p = points.emplace_back();
    for (std::size_t k = 0; k < Dim; ++k) p[k] = coordinate(k);
  };
  switch (shape) {
    case Shape::kGrid:
      points = full_grid<Dim>(Dim == 2 ? 90 : 20);
      break;
    case Shape::kSphere:
      for (int i = 0; i < 1000; ++i) {
        add([&](std::size_t) { return uniform(random, -1, 1); });
        double norm = 0;
        for (const double x : points.back()) norm += x * x;
        for (double& x : points.back()) x /= std::sqrt(norm);
      }
      break;
    case Shape::kIntegerSphere:  // 325 = 1+18^2 = 6^2+17^2 = 10^2+15^2, 3D many more ways
      for (const auto& p : full_grid<Dim>(37)) {
        double norm = 0;
        for (const double x : p) norm += (x - 18) * (x - 18);
        if (norm == 325) points.push_back(p);
      }
      break;
    case Shape::kFlatPlusOne:
      for (int i = 0; i < 300; ++i) {
        add([&](std::size_t) { return static_cast<double>(uniform_int(random, -20, 20)); });
        points.back()[0] = 3 * points.back()[1] + (Dim == 3 ? points.back()[Dim - 1] : 0);
      }
      add([](std::size_t k) { return k == 0 ? 1.0 : 0.0; });
      break;
    case Shape::kLinePlusFew:
      for (int i = 0; i < 300; ++i) {
        const int x = uniform_int(random, -200, 200);
        add([&](std::size_t k) { return static_cast<double>(x * static_cast<int>(k + 1)); });
      }
      for (int i = 0; i < 3; ++i)
        add([&](std::size_t) { return static_cast<double>(uniform_int(random, -9, 9)); });
      break;
    case Shape::kCylinder:
      for (int z = 0; z < 30; ++z) {
        for (const Point2 q : {Point2{5, 0},
                               {4, 3},
                               {3, 4},
                               {0, 5},
                               {-3, 4},
                               {-4, 3},
                               {-5, 0},
                               {-4, -3},
                               {-3, -4},
                               {0, -5},
                               {3, -4},
                               {4, -3}}) {
          add([&](std::size_t k) { return k == Dim - 1 ? 3.0 * z : q[k]; });
        }
      }
      break;
    case Shape::kTwoHyperplanes:
      for (const auto& p : full_grid<Dim>(Dim == 2 ? 150 : 13)) {
        if (p[0] <= 1) points.push_back(p);
      }
      break;
    case Shape::kClusters:
      for (int i = 0; i < 1200; ++i) {
        const double centre = static_cast<double>(i % 4);
        const double scale = std::ldexp(1.0, -15 * (i % 4));
        add([&](std::size_t k) { return centre * (k == 0 ? 1 : 0.5) + scale * uniform(random, -1, 1); });
      }
      break;
    case Shape::kFineSpacing:
      for (auto p : full_grid<Dim>(Dim == 2 ? 25 : 9)) {
        for (double& x : p) x = 1 + 1e-9 * x;
        points.push_back(p);
      }
      break;
    case Shape::kUniform:
      for (int i = 0; i < 2000; ++i) add([&](std::size_t) { return uniform(random, -1, 1); });
      break;
  }
  return points;
}

TYPED_TEST(Engines, AgreeOnEveryShapeInAnyOrder) {
  constexpr int Dim = TypeParam::value;
  Random random(4);
  for (const Shape shape : kShapes) {
    SCOPED_TRACE(testing::Message() << "shape " << static_cast<int>(shape));
    const auto points = make_shape<Dim>(shape, random);
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
