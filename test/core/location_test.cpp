// SPDX-License-Identifier: MIT
//
// Point location against all simplices, in integers.
#include "core/location.h"

#include <gtest/gtest.h>

#include <map>

#include "core/conflict.h"
#include "core/triangulation.h"
#include "test/support/complexes.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class Dimension>
class LocationOf : public testing::Test {};
TYPED_TEST_SUITE(LocationOf, Dimensions, DimensionNames);

/// A cloud whose gate takes coordinates up to 7.
template <int Dim>
std::vector<Point<Dim>> cloud_in_gate(Random& random) {
  auto points = grid_cloud<Dim>(10, 1, 5, random);
  Point<Dim> corner;
  corner.fill(5);
  if (std::find(points.begin(), points.end(), corner) == points.end()) points.push_back(corner);
  return points;
}

/// Signs of the barycentric coordinates of p, from volumes in integers. In a ghost: of p in the place of
/// infinity.
template <int Dim>
std::array<int, Dim + 1> signs_in(const Triangulation<Dim>& triangulation, Simplex s, const PointArg<Dim>& p) {
  const auto& complex = triangulation.complex();
  std::array<Point<Dim>, Dim + 1> corners;
  for (int i = 0; i <= Dim; ++i) {
    const Vertex v = complex.corner(s, i);
    corners[static_cast<std::size_t>(i)] = v.is_infinite() ? p : triangulation.point(v);
  }
  std::array<int, Dim + 1> signs;
  for (std::size_t i = 0; i <= Dim; ++i) {
    auto seen = corners;
    seen[i] = p;
    signs[i] = sign_of(integer_volume<Dim>(seen));
  }
  return signs;
}

/// Whether the location is right, by the oracle; `holders` counts the solid simplices whose closures hold p.
template <int Dim>
void expect_right(const Triangulation<Dim>& triangulation, const Location<Dim>& at, const PointArg<Dim>& p,
                  std::size_t holders) {
  const auto& complex = triangulation.complex();
  ASSERT_TRUE(complex.is_alive(at.simplex));
  const auto expected = signs_in(triangulation, at.simplex, p);
  if (holders == 0) {
    ASSERT_TRUE(complex.is_ghost(at.simplex));
    ASSERT_EQ(expected[Dim], 1) << "strictly beyond the hull facet";
    ASSERT_EQ(at.support(), 0);
    return;
  }
  ASSERT_FALSE(complex.is_ghost(at.simplex));
  for (std::size_t i = 0; i <= Dim; ++i) ASSERT_EQ(at.sign[i], expected[i]) << "corner " << i;
  ASSERT_EQ(at.is_at_corner(), std::count(expected.begin(), expected.end(), 1) == 1);
}

/// Points that lie on faces of every dimension: centres of gravity of all subsets of corners. Coordinates of
/// the vertices must be multiples of 12.
template <int Dim>
std::vector<Point<Dim>> centres_of_faces(const Triangulation<Dim>& triangulation) {
  std::vector<Point<Dim>> centres;
  for (const Simplex s : triangulation.complex().simplices()) {
    if (triangulation.complex().is_ghost(s)) continue;
    for (unsigned subset = 1; subset < 1U << (Dim + 1); ++subset) {
      Point<Dim> sum{};
      double count = 0;
      for (int i = 0; i <= Dim; ++i) {
        if ((subset >> i & 1U) == 0) continue;
        ++count;
        for (std::size_t k = 0; k < Dim; ++k)
          sum[k] += triangulation.point(triangulation.complex().corner(s, i))[k];
      }
      for (double& x : sum) x /= count;
      centres.push_back(sum);
    }
  }
  std::sort(centres.begin(), centres.end());
  centres.erase(std::unique(centres.begin(), centres.end()), centres.end());
  return centres;
}

TYPED_TEST(LocationOf, APointOnAFaceOfAnyDimensionIsRightFromEveryStart) {
  constexpr int Dim = TypeParam::value;
  Random random(1);
  std::map<int, int> seen;  // by support
  for (int trial = 0; trial < 40; ++trial) {
    auto points = cloud_in_gate<Dim>(random);
    if (!spans_space<Dim>(points)) continue;
    for (auto& p : points) {
      for (double& x : p) x *= 12;
    }
    Triangulation<Dim> triangulation(points);
    auto queries = centres_of_faces(triangulation);
    for (int i = 0; i < 40; ++i) {
      for (double& x : queries.emplace_back()) x = uniform_int(random, 0, 63);
    }
    for (const Point<Dim>& p : queries) {
      const Point<Dim> x = triangulation.gate().in(p);
      triangulation.announce(x);
      std::size_t holders = 0;
      for (const Simplex s : triangulation.complex().simplices()) {
        if (triangulation.complex().is_ghost(s)) continue;
        const auto signs = signs_in(triangulation, s, p);
        holders += *std::min_element(signs.begin(), signs.end()) >= 0 ? 1 : 0;
      }
      for (const Simplex start : triangulation.complex().simplices()) {
        const Location<Dim> at = triangulation.locate(x, start);
        expect_right(triangulation, at, p, holders);
        if (this->HasFatalFailure()) return;
        ++seen[at.support()];
      }
    }
  }
  for (int support = 0; support <= Dim + 1; ++support) EXPECT_GT(seen[support], 1000) << support;
}

// The walk for a prestar may stop earlier, but must stop at a simplex in conflict: one that goes when p comes.
TYPED_TEST(LocationOf, ASimplexInConflictIsFoundFromEveryStart) {
  constexpr int Dim = TypeParam::value;
  Random random(2);
  for (int trial = 0; trial < 60; ++trial) {
    const auto points = cloud_in_gate<Dim>(random);
    if (!spans_space<Dim>(points)) continue;
    Triangulation<Dim> triangulation(points);
    for (int i = 0; i < 12; ++i) {
      Point<Dim> p;
      for (double& x : p) x = uniform_int(random, 0, 6);
      if (std::find(points.begin(), points.end(), p) != points.end()) continue;
      triangulation.announce(triangulation.gate().in(p));
      auto more = points;
      more.push_back(p);
      const auto after = with_ghosts(brute_force_delaunay<Dim>(more));
      for (const Simplex start : triangulation.complex().simplices()) {
        const Location<Dim> at = walk_to_conflict<Dim>(triangulation.complex(), triangulation.predicates(),
                                                       triangulation.gate().in(p), start);
        ASSERT_FALSE(
            std::binary_search(after.begin(), after.end(), ids_of(triangulation.complex(), at.simplex)));
      }
    }
  }
}

// Grids are where visibility walks would cycle if they could: every facet has points in its plane.
TYPED_TEST(LocationOf, AnyPointOfALargeGridEndsFromAnyStart) {
  constexpr int Dim = TypeParam::value;
  Random random(3);
  const int side = Dim == 2 ? 40 : 10;
  Triangulation<Dim> triangulation(full_grid<Dim>(side));
  const auto slots = triangulation.complex().num_slots();
  int most_steps = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    Point<Dim> p;
    for (double& x : p) x = uniform_int(random, -1, side);
    triangulation.announce(triangulation.gate().in(p));
    const Simplex start(static_cast<std::uint32_t>(random() % slots));
    if (!triangulation.complex().is_alive(start)) continue;
    const Location<Dim> at = triangulation.locate(triangulation.gate().in(p), start);
    const auto [low, high] = std::minmax_element(p.begin(), p.end());
    expect_right(triangulation, at, p, *low < 0 || *high > side - 1 ? 0 : 1);
    if (this->HasFatalFailure()) return;
    most_steps = std::max(most_steps, at.steps);
  }
  // In a straight line there are at most about 2 (plane) or 6 (space) simplices for each cell that is crossed.
  EXPECT_LT(most_steps, 6 * Dim * side);
}

// From a facet that may not be crossed the walk does not go on, and from its simplex it came.
TYPED_TEST(LocationOf, AWalkStopsWhereItMayNotLeave) {
  constexpr int Dim = TypeParam::value;
  Random random(7);
  std::size_t stopped = 0;
  const auto points = full_grid<Dim>(Dim == 2 ? 12 : 5);
  const Triangulation<Dim> triangulation(points);
  const auto& complex = triangulation.complex();
  for (int trial = 0; trial < 200; ++trial) {
    const Point<Dim> p = points[random() % points.size()];
    const Simplex start(static_cast<std::uint32_t>(random() % complex.num_slots()));
    if (!complex.is_solid(start)) continue;
    const int allowed = static_cast<int>(random() % 4);
    int asked = 0;
    HalfFacet last;
    const Location<Dim> at = visibility_walk<Dim>(
        complex, triangulation.predicates(), triangulation.gate().in(p), start, [](Simplex) { return false; },
        [&](HalfFacet h) {
          last = h;
          return ++asked <= allowed;
        });
    ASSERT_LE(asked, allowed + 1);
    ASSERT_EQ(at.steps, std::min(asked, allowed) + 1);
    if (asked <= allowed) continue;
    ++stopped;
    ASSERT_EQ(at.simplex, Complex<Dim>::simplex_of(last));
    const auto signs = signs_in(triangulation, at.simplex, p);
    ASSERT_EQ(signs[static_cast<std::size_t>(Complex<Dim>::corner_of(last))], -1);
  }
  EXPECT_GE(stopped, 20U);
}

TYPED_TEST(LocationOf, APointNextToItsHintTakesOneStep) {
  constexpr int Dim = TypeParam::value;
  auto points = full_grid<Dim>(4);
  for (auto& p : points) {
    for (double& x : p) x *= 12;
  }
  const Triangulation<Dim> triangulation(points);
  for (const Simplex s : triangulation.complex().simplices()) {
    if (triangulation.complex().is_ghost(s)) continue;
    Point<Dim> centre{};
    for (int i = 0; i <= Dim; ++i) {
      for (std::size_t k = 0; k < Dim; ++k) {
        centre[k] += triangulation.point(triangulation.complex().corner(s, i))[k] / (Dim + 1);
      }
    }
    const Location<Dim> at = triangulation.locate(triangulation.gate().in(centre), s);
    EXPECT_EQ(at.simplex, s);
    EXPECT_EQ(at.steps, 1);
    EXPECT_EQ(at.support(), Dim + 1);
  }
}

}  // namespace
}  // namespace sinkmesh
