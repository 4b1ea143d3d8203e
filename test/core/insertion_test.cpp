// SPDX-License-Identifier: MIT
//
// Points inserted one at a time, inside and outside the hull, by either engine or by both in turn.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/triangulation.h"
#include "test/support/complexes.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class Dimension>
class Insertion : public testing::Test {};
TYPED_TEST_SUITE(Insertion, Dimensions, DimensionNames);

enum class Turns { star, flips, mixed };

Engine engine_for(Turns turns, std::size_t i) {
  if (turns == Turns::mixed) return kEngines[i % 2];
  return turns == Turns::star ? Engine::star : Engine::flips;
}

// Coordinates are 16 to 20, so that all points pass the gate of the first ones.
TYPED_TEST(Insertion, KeepsTheOraclesComplexAfterEachPoint) {
  constexpr int Dim = TypeParam::value;
  Random random(1);
  int outside = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const auto points = grid_cloud<Dim>(12, 16, 5, random);
    if (!spans_space<Dim>(points)) continue;
    const auto sequence = with_basis_first<Dim>(points);
    for (const Turns turns : {Turns::star, Turns::flips, Turns::mixed}) {
      Triangulation<Dim> triangulation(std::span<const Point<Dim>>(sequence).first(Dim + 1));
      for (std::size_t i = Dim + 1; i < sequence.size(); ++i) {
        SCOPED_TRACE(testing::Message() << "cloud " << trial << ", point " << i);
        const Location<Dim> at = triangulation.locate(triangulation.gate().in(sequence[i]));
        outside += at.support() == 0 ? 1 : 0;
        const auto [vertex, is_new] = triangulation.insert(sequence[i], engine_for(turns, i));
        ASSERT_TRUE(is_new);
        ASSERT_EQ(vertex, Vertex(static_cast<std::uint32_t>(i)));
        ASSERT_TRUE(triangulation.validate().ok()) << triangulation.validate();
        ASSERT_TRUE(triangulation.is_delaunay());
        const auto prefix =
            std::vector(sequence.begin(), sequence.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        ASSERT_EQ(simplex_sets(triangulation.complex()), with_ghosts(brute_force_delaunay<Dim>(prefix)));
      }
    }
  }
  EXPECT_GT(outside, 1000);
}

TYPED_TEST(Insertion, OfManyPointsEqualsBulkLoading) {
  constexpr int Dim = TypeParam::value;
  Random random(2);
  for (const bool on_grid : {false, true}) {
    auto points = on_grid ? full_grid<Dim>(Dim == 2 ? 20 : 7) : std::vector<Point<Dim>>(500);
    if (!on_grid) {
      for (auto& p : points) {
        for (double& x : p) x = uniform(random, -1, 1);
      }
    }
    std::shuffle(points.begin(), points.end(), random);
    Point<Dim> corner;  // sets the scale of the gate
    corner.fill(on_grid ? 25.0 : 1.5);
    points.insert(points.begin(), corner);
    const std::size_t first = 60;
    const Triangulation<Dim> bulk(points);
    for (const Turns turns : {Turns::star, Turns::flips, Turns::mixed}) {
      Triangulation<Dim> triangulation(std::span<const Point<Dim>>(points).first(first));
      Simplex hint;
      for (std::size_t i = first; i < points.size(); ++i) {
        const Vertex v = triangulation.insert(points[i], engine_for(turns, i), hint).vertex;
        if (i % 3 == 0) hint = triangulation.complex().incident_simplex(v);
        if (i % 3 == 2) hint = Simplex();
      }
      EXPECT_EQ(triangulation.hash(), bulk.hash());
      EXPECT_TRUE(simplex_sets(triangulation.complex()) == simplex_sets(bulk.complex()));
      EXPECT_TRUE(triangulation.validate().ok()) << triangulation.validate();
    }
  }
}

// From a small simplex in a corner, along the axes and diagonals: many hull facets are visible at once, or
// coplanar.
TYPED_TEST(Insertion, GrowsTheHullFromTheInsideOut) {
  constexpr int Dim = TypeParam::value;
  Random random(3);
  for (const Turns turns : {Turns::star, Turns::flips, Turns::mixed}) {
    std::vector<Point<Dim>> points(Dim + 1);  // a simplex that fixes the scale and lies in a corner
    for (std::size_t i = 0; i <= Dim; ++i) points[i].fill(1.0);
    for (std::size_t i = 0; i < Dim; ++i) points[i + 1][i] = 1 + 0x1p-6;
    Triangulation<Dim> triangulation(points);
    for (int i = 0; i < 200; ++i) {
      Point<Dim> p;
      const double reach = std::ldexp(1.0, -uniform_int(random, 0, 5));
      for (double& x : p) x = reach * uniform_int(random, -1, 1) * 1.5;
      const auto [vertex, is_new] = triangulation.insert(p, engine_for(turns, static_cast<std::size_t>(i)));
      if (!is_new) continue;
      points.push_back(p);
      ASSERT_TRUE(triangulation.validate().ok()) << triangulation.validate();
    }
    EXPECT_EQ(triangulation.hash(), Triangulation<Dim>(points).hash());
  }
}

/// Points on a circle or sphere up to rounding, so that the prestar of the centre is all of it; the first 2 Dim
/// on the axes, so that the centre is inside.
template <int Dim>
std::vector<Point<Dim>> round_cloud(std::size_t n, Random& random) {
  std::vector<Point<Dim>> points(n);
  for (std::size_t i = 0; i < 2 * Dim; ++i) points[i][i / 2] = i % 2 == 0 ? 1 : -1;
  for (std::size_t i = 2 * Dim; i < n; ++i) {
    double norm = 0;
    do {
      for (double& x : points[i]) x = uniform(random, -1, 1);
      norm = 0;
      for (const double x : points[i]) norm += x * x;
    } while (norm > 1 || norm < 0.01);
    for (double& x : points[i]) x /= std::sqrt(norm);
  }
  return points;
}

// Stars are linked through a small table, a larger one, or by sorting, depending on their size.
TYPED_TEST(Insertion, LinksStarsOfEverySize) {
  constexpr int Dim = TypeParam::value;
  Random random(4);
  for (const std::size_t n : {6U, 30U, 31U, 32U, 33U, 34U, 100U, 254U, 255U, 256U, 257U, 258U, 700U}) {
    SCOPED_TRACE(n);
    auto points = round_cloud<Dim>(n, random);
    Triangulation<Dim> triangulation(points);
    points.push_back(Point<Dim>{});
    const Vertex centre = triangulation.insert(points.back(), Engine::star).vertex;
    std::size_t star = 0;
    for (const Simplex s : triangulation.complex().simplices()) {
      star += triangulation.complex().index_of(s, centre) >= 0 ? 1 : 0;
    }
    EXPECT_EQ(star, Dim == 2 ? n : 2 * n - 4);
    ASSERT_TRUE(triangulation.validate().ok()) << triangulation.validate();
    EXPECT_EQ(triangulation.hash(), Triangulation<Dim>(points, Engine::flips).hash());
  }
}

// The same with infinity in the link: a point that sees the whole hull but for one facet.
TYPED_TEST(Insertion, LinksStarsWithInfinityOfEverySize) {
  constexpr int Dim = TypeParam::value;
  Random random(5);
  for (const std::size_t n : {6U, 31U, 32U, 33U, 254U, 255U, 256U, 257U, 700U}) {
    SCOPED_TRACE(n);
    // On a parabola or paraboloid, seen from far below.
    std::vector<Point<Dim>> points(n);
    for (auto& p : points) {
      p[Dim - 1] = 0;
      for (std::size_t k = 0; k + 1 < Dim; ++k) {
        p[k] = uniform(random, -0.5, 0.5);
        p[Dim - 1] += p[k] * p[k];
      }
    }
    points.push_back({});
    points.back()[0] = -1.25;  // the scale of the gate
    points.back()[Dim - 1] = 1.9;
    Triangulation<Dim> triangulation(points);
    Point<Dim> eye{};
    eye[Dim - 1] = -1.9;
    points.push_back(eye);
    triangulation.insert(eye, Engine::star);
    ASSERT_TRUE(triangulation.validate().ok()) << triangulation.validate();
    EXPECT_EQ(triangulation.hash(), Triangulation<Dim>(points, Engine::flips).hash());
  }
}

TYPED_TEST(Insertion, OfAVertexAgainChangesNothing) {
  constexpr int Dim = TypeParam::value;
  const auto points = full_grid<Dim>(3);
  Triangulation<Dim> triangulation(points);
  const auto before = simplex_sets(triangulation.complex());
  for (const Engine engine : kEngines) {
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const auto [vertex, is_new] = triangulation.insert(points[i], engine);
      EXPECT_FALSE(is_new);
      EXPECT_EQ(vertex, Vertex(i));
    }
  }
  EXPECT_EQ(simplex_sets(triangulation.complex()), before);
  EXPECT_EQ(triangulation.complex().num_vertices(), points.size());
  EXPECT_TRUE(triangulation.validate().ok());
}

// All points so far are integers, and so is every zero that the filters prove; the new ones are not.
TYPED_TEST(Insertion, OfAPointNextToAVertexIsNotTakenForTheVertex) {
  constexpr int Dim = TypeParam::value;
  for (const Engine engine : kEngines) {
    auto points = full_grid<Dim>(3);
    Triangulation<Dim> triangulation(points);
    for (const Point<Dim>& q : full_grid<Dim>(3)) {
      Point<Dim> p = q;
      for (std::size_t k = 0; k < Dim; ++k) p[k] += std::ldexp(k % 2 == 0 ? 1.0 : -1.0, -50);
      const auto [vertex, is_new] = triangulation.insert(p, engine);
      ASSERT_TRUE(is_new);
      points.push_back(p);
      ASSERT_TRUE(triangulation.validate().ok()) << triangulation.validate();
    }
    EXPECT_EQ(triangulation.hash(), Triangulation<Dim>(points).hash());
  }
}

TYPED_TEST(Insertion, RefusesWhatTheGateCannotHold) {
  constexpr int Dim = TypeParam::value;
  Triangulation<Dim> triangulation(full_grid<Dim>(3));
  const auto before = simplex_sets(triangulation.complex());
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity(), 1e300, 4.0, -4.0}) {
    for (const Engine engine : kEngines) {
      Point<Dim> p{};
      p[Dim - 1] = bad;
      EXPECT_THROW(triangulation.insert(p, engine), InputError) << bad;
    }
  }
  EXPECT_EQ(simplex_sets(triangulation.complex()), before);
  EXPECT_EQ(triangulation.complex().num_vertices(), full_grid<Dim>(3).size());
  Point<Dim> p{};
  p[Dim - 1] = -3.875;
  EXPECT_TRUE(triangulation.insert(p).is_new);
  EXPECT_TRUE(triangulation.validate().ok());
}

TYPED_TEST(Insertion, IntoACopyLeavesTheOriginalAlone) {
  constexpr int Dim = TypeParam::value;
  const Triangulation<Dim> original(full_grid<Dim>(3));
  const auto before = simplex_sets(original.complex());
  for (const Engine engine : kEngines) {
    Triangulation<Dim> copy = original;
    Point<Dim> p;
    p.fill(0.5);
    copy.insert(p, engine);
    EXPECT_TRUE(copy.validate().ok()) << copy.validate();
    EXPECT_NE(simplex_sets(copy.complex()), before);
    Triangulation<Dim> moved = std::move(copy);
    p[0] = 1.25;
    moved.insert(p, engine);
    EXPECT_TRUE(moved.validate().ok()) << moved.validate();
  }
  EXPECT_EQ(simplex_sets(original.complex()), before);
  EXPECT_TRUE(original.validate().ok());
}

}  // namespace
}  // namespace sinkmesh
