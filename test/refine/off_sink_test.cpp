// SPDX-License-Identifier: MIT
//
// Off-sinks [OS, 0]: where a chain is left, against exact chains and all vertices.
#include "refine/off_sink.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <tuple>

#include "core/triangulation.h"
#include "core/vector.h"
#include "predicates/circumcenter.h"
#include "refine/quality.h"
#include "test/support/chain_oracle.h"
#include "test/support/dimensions.h"
#include "test/support/point_sets.h"

namespace sinkmesh {
namespace {

using namespace test;

// Crowds around a few places, each smaller than the one before: short edges beside long ones.
template <int Dim>
std::vector<Point<Dim>> clustered_points(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point<Dim>> points = uniform_points<Dim>(n, seed);
  for (std::size_t i = 0; i < n; ++i) {
    const double size = std::ldexp(1.0, -static_cast<int>(i % 7));
    for (std::size_t k = 0; k < Dim; ++k) {
      points[i][k] = std::sin(static_cast<double>((i % 7 + 1) * (k + 2))) + size * (points[i][k] - 0.5);
    }
  }
  return points;
}

// Every other point is a few hundred steps of the grid of the gate away from a coordinate plane: what is
// constructed from two of them need not be on the grid by itself.
template <int Dim>
std::vector<Point<Dim>> points_near_a_plane(std::size_t n, std::uint64_t seed) {
  std::vector<Point<Dim>> points = uniform_points<Dim>(n, seed);
  for (std::size_t i = 0; i < n; i += 2) points[i][0] *= 0x1p-113;
  return points;
}

// So near the origin that coordinates have more bits than the grid.
template <int Dim>
std::vector<Point<Dim>> crowd_at_the_origin(std::size_t n, std::uint64_t seed) {
  std::vector<Point<Dim>> points = uniform_points<Dim>(n, seed);
  for (std::size_t i = 0; i < n; ++i) {
    for (double& x : points[i]) x = (x - 0.5) * (i % 3 == 0 ? 1 : 0x1p-80);
  }
  return points;
}

template <int Dim>
std::vector<PointSet<Dim>> sets() {
  return {{"uniform", uniform_points<Dim>(Dim == 2 ? 200 : 90, 1)},
          {"grid", grid_points<Dim>(Dim == 2 ? 9 : 4)},
          {"sphere", sphere_points<Dim>()},
          {"clustered", clustered_points<Dim>(Dim == 2 ? 210 : 105, 2)},
          {"tenth", grid_points<Dim>(Dim == 2 ? 8 : 4, 0.1)},
          {"near a plane", points_near_a_plane<Dim>(60, 3)},
          {"crowd at the origin", crowd_at_the_origin<Dim>(Dim == 2 ? 90 : 45, 4)}};
}

template <int Dim>
double nearest2(const Complex<Dim>& complex, const Point<Dim>& x) {
  double result = HUGE_VAL;
  for (std::uint32_t v = 0; v < complex.num_vertices(); ++v) {
    result = std::min(result, squared_distance(x, complex.point(Vertex(v))));
  }
  return result;
}

constexpr double kBeyondAll2 = 0x1p1000;

// Shorter and longer than all that happens on the chain of s; the last leads to its sink.
template <int Dim>
std::vector<double> reaches2(const Complex<Dim>& complex, Simplex s) {
  const Shape shape = sinkmesh::shape<Dim>(complex.corners(s));
  std::vector<double> result;
  for (const double of_edge : {0.51, 1.0, 1.5, 2.6}) result.push_back(of_edge * of_edge * shape.shortest2);
  for (const double of_radius : {0.99, 1.0, 1.02, 1.3, 2.0}) {
    const double reach2 = of_radius * of_radius * shape.radius2;
    if (reach2 > shape.shortest2 * 0.26) result.push_back(reach2);
  }
  result.push_back(std::nextafter(shape.radius2, HUGE_VAL));
  result.push_back(kBeyondAll2);
  return result;
}

template <class T>
class OffSinkTest : public testing::Test {};
TYPED_TEST_SUITE(OffSinkTest, PlaneAndSpace, DimensionName);

// The end of the exact chain that has been found; null if there is none. Only sinks are nearer than the reach.
template <int Dim>
const typename ChainOracle<Dim>::End* matching(const std::vector<typename ChainOracle<Dim>::End>& ends,
                                               const std::optional<OffSink<Dim>>& found, double reach2) {
  const typename ChainOracle<Dim>::End* best = nullptr;
  for (const auto& end : ends) {
    if (end.simplex != (found ? found->simplex : Simplex())) continue;
    if (found && (end.part == ChainOracle<Dim>::Part::sink) != (found->distance2 < reach2)) continue;
    if (best == nullptr ||
        (found && squared_distance(end.point, found->point) < squared_distance(best->point, found->point))) {
      best = &end;
    }
  }
  return best;
}

TYPED_TEST(OffSinkTest, IsWhereTheExactChainIsAtTheReach) {
  constexpr int kDim = TypeParam::value;
  using Part = typename ChainOracle<kDim>::Part;
  std::map<Part, std::size_t> parts;
  std::size_t seen = 0;
  std::size_t all = 0;
  for (const PointSet<kDim>& set : sets<kDim>()) {
    SCOPED_TRACE(set.name);
    // Facets of points that are collinear but for rounding have rounded centers.
    const double tolerance = set.name == "tenth" ? 1e-7 : 1e-9;
    const Triangulation<kDim> triangulation(set.points);
    const Complex<kDim>& complex = triangulation.complex();
    Flow<kDim> flow(triangulation);
    ChainOracle<kDim> oracle(triangulation);
    OffSinkWalk<kDim> walk;
    // Thinner ones are never worked on: rounding decides how large they are.
    const auto is_seen = [&](Simplex t) {
      return t.is_null() || std::abs(shape<kDim>(complex.corners(t)).radius2 / oracle.radius2(t) - 1) < 1e-6;
    };
    for (const Simplex s : solid_simplices(complex)) {
      if (!is_seen(s)) continue;
      for (const double reach2 : reaches2<kDim>(complex, s)) {
        if (set.name == "crowd at the origin" && reach2 > 0x1p-140) continue;  // out of the crowd
        SCOPED_TRACE(testing::Message() << s << ", reach^2 " << reach2);
        ++all;
        const std::optional<OffSink<kDim>> found = walk(flow, s, reach2);
        const auto ends = oracle.ends(s, reach2);
        if (found && !is_seen(found->simplex)) continue;
        if (std::any_of(ends.begin(), ends.end(), [&](const auto& e) { return !is_seen(e.simplex); })) continue;
        ++seen;
        const auto* end = matching<kDim>(ends, found, reach2);
        ASSERT_NE(end, nullptr) << (found ? "another end than that of the chain" : "no point");
        ++parts[end->part];
        if (!found) continue;

        const auto sphere = oracle.sphere(found->simplex);
        ASSERT_LT(sphere.power(rational<kDim>(found->point)), 0);
        for (const double x : found->point) {
          ASSERT_EQ(x * 0x1p121, std::nearbyint(x * 0x1p121)) << "not on the grid of the gate";
          ASSERT_FALSE(x == 0 && std::signbit(x));
        }
        const double distance = std::sqrt(found->distance2);
        ASSERT_LE(std::sqrt(squared_distance(end->point, found->point)), tolerance * distance);
        ASSERT_NEAR(found->distance2 / end->distance2, 1, 1e-9);
        if (end->part != Part::sink) {
          ASSERT_EQ(found->distance2, reach2);
        } else {
          ASSERT_EQ(found->distance2, shape<kDim>(complex.corners(found->simplex)).radius2);
          Point<kDim> center;
          ASSERT_TRUE(circumcenter(complex.corners(found->simplex), center));
          ASSERT_EQ(found->point, center);
        }
        if (end->part == Part::off_center) {
          // In the plane that halves the edge, on the side of the center, and not beyond it.
          Rational height2 = squared_distance(rational<kDim>(found->point), rational<kDim>(end->middle));
          ASSERT_LE(height2.get_d(),
                    squared_distance(sphere.center, rational<kDim>(end->middle)).get_d() * (1 + 1e-9));
        } else {
          ASSERT_NEAR(std::sqrt(nearest2<kDim>(complex, found->point)) / distance, 1, tolerance);
        }
      }
    }
  }
  EXPECT_GT(seen, all - all / 20);
  EXPECT_GT(parts[Part::off_center], 1000U);
  EXPECT_GT(parts[Part::voronoi], 300U);
  EXPECT_GT(parts[Part::sink], 1000U);
  EXPECT_GT(parts[Part::outside], 200U);
}

// As nearly as coordinates can be rounded: the middle is on the grid before the way from there is looked for.
TYPED_TEST(OffSinkTest, OffCenterIsAtTheReachFromBothEndsOfAShortestEdge) {
  constexpr int kDim = TypeParam::value;
  for (const PointSet<kDim>& set : sets<kDim>()) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    const Complex<kDim>& complex = triangulation.complex();
    Flow<kDim> flow(triangulation);
    OffSinkWalk<kDim> walk;
    for (const Simplex s : solid_simplices(complex)) {
      const Shape shape = sinkmesh::shape<kDim>(complex.corners(s));
      const double reach2 = 0.6 * 0.6 * shape.shortest2;
      if (shape.radius2 < reach2) continue;
      const std::optional<OffSink<kDim>> found = walk(flow, s, reach2);
      ASSERT_TRUE(found);
      ASSERT_EQ(found->simplex, s);
      int at_reach = 0;
      for (int i = 0; i <= kDim; ++i) {
        const Point<kDim>& p = complex.point(complex.corner(s, i));
        const double error = std::sqrt(squared_distance(p, found->point)) - std::sqrt(reach2);
        at_reach += std::abs(error) < 0x1p-50 ? 1 : 0;  // coordinates are below 2
      }
      ASSERT_GE(at_reach, 2) << s;
    }
  }
}

// By sorted corners, which do not depend on numbers: what is found for each simplex, bit for bit.
template <int Dim>
auto all_off_sinks(const Triangulation<Dim>& triangulation, double reach) {
  using Key = std::array<Point<Dim>, Dim + 1>;
  const Complex<Dim>& complex = triangulation.complex();
  const auto key_of = [&](Simplex s) {
    Key key;
    for (int i = 0; i <= Dim; ++i) key[static_cast<std::size_t>(i)] = complex.point(complex.corner(s, i));
    std::sort(key.begin(), key.end());
    return key;
  };
  Flow<Dim> flow(triangulation);
  OffSinkWalk<Dim> walk;
  std::map<Key, std::optional<std::tuple<Key, Point<Dim>, double>>> result;
  for (const Simplex s : solid_simplices(complex)) {
    const double length2 = shape<Dim>(complex.corners(s)).shortest2;
    auto& entry = result[key_of(s)];
    if (const auto found = walk(flow, s, reach * reach * length2)) {
      entry.emplace(key_of(found->simplex), found->point, found->distance2);
    }
  }
  return result;
}

// The engines give the corners of simplices in different orders.
TYPED_TEST(OffSinkTest, DoesNotDependOnTheOrderOfPointsAndCorners) {
  constexpr int kDim = TypeParam::value;
  for (const PointSet<kDim>& set : sets<kDim>()) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    std::vector<Triangulation<kDim>> others;
    std::vector<Point<kDim>> points = set.points;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      Random random(seed);
      std::shuffle(points.begin(), points.end(), random);
      others.emplace_back(points);
      others.emplace_back(points, Engine::flips);
      // Half of them one by one. The gate is that of the largest.
      const auto largest = [](const Point<kDim>& p) {
        return std::abs(*std::max_element(p.begin(), p.end(),
                                          [](double x, double y) { return std::abs(x) < std::abs(y); }));
      };
      std::iter_swap(points.begin(),
                     std::max_element(points.begin(), points.end(),
                                      [&](const auto& p, const auto& q) { return largest(p) < largest(q); }));
      const std::size_t half = points.size() / 2;
      others.emplace_back(std::span(points).first(half));
      for (const Point<kDim>& p : std::span(points).subspan(half)) others.back().insert(p);
    }
    for (const double reach : {0.6, 0.8, 1.2, 1.5, 3.0, 1e6}) {
      SCOPED_TRACE(testing::Message() << "reach " << reach);
      const auto expected = all_off_sinks<kDim>(triangulation, reach);
      for (const Triangulation<kDim>& other : others) ASSERT_EQ(all_off_sinks<kDim>(other, reach), expected);
    }
  }
}

// A simplex so flat that doubles see no height: where its far center is, is told by exact numbers.
TYPED_TEST(OffSinkTest, FollowsTheDirectionHoweverFarTheCenterIs) {
  constexpr int kDim = TypeParam::value;
  std::vector<Point<kDim>> points;
  if constexpr (kDim == 2) {
    points = {{-1, 0}, {0, 0x1p-121}, {1, 0}, {0, 1}};
  } else {
    points = {{1, 0, 0}, {-0.5, 0.75, 0}, {-0.5, -0.75, 0}, {0, 0, 0x1p-121}, {0, 0, 1}};
  }
  const Triangulation<kDim> triangulation(points);
  Flow<kDim> flow(triangulation);
  OffSinkWalk<kDim> walk;
  std::size_t flat = 0;
  for (const Simplex s : solid_simplices(triangulation.complex())) {
    const auto shape = sinkmesh::shape<kDim>(triangulation.complex().corners(s));
    if (shape.radius2 < 100) continue;
    ++flat;
    const auto found = walk(flow, s, 4 * shape.shortest2);
    ASSERT_TRUE(found);
    const double height = std::sqrt((4 - 0.25) * shape.shortest2);
    EXPECT_NEAR(found->point[kDim - 1], -height, 1e-12);
  }
  EXPECT_EQ(flat, 1U);
}

}  // namespace
}  // namespace sinkmesh
