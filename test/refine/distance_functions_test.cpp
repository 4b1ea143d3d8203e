// SPDX-License-Identifier: MIT
//
// pi and phi [EG01, 3.1, 3.2], against all points and all spheres in rationals.
#include "refine/distance_functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "test/support/dimensions.h"
#include "test/support/distance_oracle.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class T>
class DistanceFunctionsTest : public testing::Test {};
TYPED_TEST_SUITE(DistanceFunctionsTest, PlaneAndSpace, DimensionName);

double relative_error(double value, const Rational& exact) {
  if (exact == 0) return value == 0 ? 0 : HUGE_VAL;
  const Rational error = (Rational(value) - exact) / exact;
  return std::abs(error.get_d());
}

TYPED_TEST(DistanceFunctionsTest, PiIsTheSquareDistanceToTheNearestPoint) {
  constexpr int kDim = TypeParam::value;
  for (const PointSet<kDim>& set : distance_test_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    Triangulation<kDim> triangulation(set.points);
    const Oracle<kDim> oracle(set.points, triangulation);
    DistanceFunctions<kDim> functions(triangulation);
    for (const Point<kDim>& x : samples<kDim>(set.points, 150, 1)) {
      const auto pi = functions.pi(x);
      const auto r = rational<kDim>(x);
      ASSERT_LT(relative_error(pi.value, oracle.pi(r)), 0x1p-50);
      const Rational to_nearest = squared_distance(r, rational<kDim>(set.points[pi.nearest.index()]));
      ASSERT_LT(relative_error(pi.value, to_nearest), 0x1p-50);
      ASSERT_GE(pi.value, 0);
    }
    EXPECT_TRUE(triangulation.validate().ok());
  }
}

TYPED_TEST(DistanceFunctionsTest, PhiIsTheSmallestPowerOfAllDelaunaySpheres) {
  constexpr int kDim = TypeParam::value;
  std::size_t outside = 0;
  std::size_t shared = 0;
  for (const PointSet<kDim>& set : distance_test_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    Triangulation<kDim> triangulation(set.points);
    const Oracle<kDim> oracle(set.points, triangulation);
    DistanceFunctions<kDim> functions(triangulation);
    for (const Point<kDim>& y : samples<kDim>(set.points, 40, 2)) {
      const auto phi = functions.phi(y);
      const auto r = rational<kDim>(y);
      const Rational exact = oracle.phi(r);
      ASSERT_LT(relative_error(phi.value, exact), 0x1p-51);
      ASSERT_EQ(phi.is_inside_hull, oracle.is_in_hull(r));
      if (!phi.is_inside_hull) {
        ++outside;
        continue;
      }
      ASSERT_LE(phi.value, 0);
      // The simplex holds y, and no simplex that does has a noticeably larger sphere, to any of which the value
      // is the same: phi is continuous across facets.
      ASSERT_TRUE(oracle.holds(phi.simplex, r));
      std::size_t holders = 0;
      for (const auto& [s, sphere] : oracle.spheres()) {
        if (!oracle.holds(s, r)) continue;
        ++holders;
        ASSERT_EQ(sphere.power(r), exact);
        // The choice compares rounded radii, which are poor for slivers.
        const Rational ratio = sphere.radius2 / oracle.sphere(phi.simplex).radius2;
        if (set.name == "uniform" || set.name.ends_with("grid")) {
          ASSERT_LT(ratio.get_d(), 1 + 1e-6);
        }
      }
      shared += holders > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(outside, 20U);
  EXPECT_GT(shared, 80U);
}

TYPED_TEST(DistanceFunctionsTest, BothVanishAtVerticesExactly) {
  constexpr int kDim = TypeParam::value;
  for (const PointSet<kDim>& set : distance_test_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    Triangulation<kDim> triangulation(set.points);
    DistanceFunctions<kDim> functions(triangulation);
    for (std::uint32_t v = 0; v < set.points.size(); ++v) {
      ASSERT_EQ(functions.pi(set.points[v]).value, 0);
      ASSERT_EQ(functions.pi(set.points[v]).nearest, Vertex(v));
      ASSERT_EQ(functions.phi(set.points[v]).value, 0);
      ASSERT_TRUE(functions.phi(set.points[v]).is_inside_hull);
    }
  }
}

// 2 (y - z) of the simplex that is named, and downhill along its negative unless y is the center itself.
TYPED_TEST(DistanceFunctionsTest, GradientIsThatOfTheSimplexAndLeadsDown) {
  constexpr int kDim = TypeParam::value;
  std::size_t steps = 0;
  for (const PointSet<kDim>& set : distance_test_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    Triangulation<kDim> triangulation(set.points);
    const Oracle<kDim> oracle(set.points, triangulation);
    DistanceFunctions<kDim> functions(triangulation);
    for (const Point<kDim>& y : samples<kDim>(set.points, 40, 3)) {
      const auto phi = functions.phi(y);
      const auto r = rational<kDim>(y);
      const RationalSphere<kDim>& sphere = oracle.sphere(phi.simplex);
      const double radius = std::sqrt(sphere.radius2.get_d());
      RationalPoint<kDim> step = r;
      Rational length2 = 0;
      for (std::size_t k = 0; k < kDim; ++k) {
        const Rational exact = 2 * (r[k] - sphere.center[k]);
        const Rational error = Rational(phi.gradient[k]) - exact;
        ASSERT_LE(std::abs(error.get_d()), 0x1p-51 * std::abs(exact.get_d()) + 0x1p-97 * radius);
        length2 += exact * exact;
        step[k] -= exact / (1 << 20);
      }
      if (length2 == 0) continue;
      // By all spheres: phi after a step t along -g falls by t |g|^2 at least, less t^2 |g|^2.
      ++steps;
      ASSERT_LE(oracle.phi(step), oracle.phi(r) - length2 / (1 << 21));
    }
  }
  EXPECT_GT(steps, 300U);
}

TYPED_TEST(DistanceFunctionsTest, NoDirectionIsSteeperThanTheGradient) {
  constexpr int kDim = TypeParam::value;
  Random random(5);
  const std::vector<Point<kDim>> points = grid_points<kDim>(kDim == 2 ? 5 : 3);
  std::vector<Point<kDim>> moved = points;
  for (auto& p : moved) {
    for (double& x : p) x += std::ldexp(uniform_int(random, 0, 255), -10);
  }
  Triangulation<kDim> triangulation(moved);
  const Oracle<kDim> oracle(moved, triangulation);
  DistanceFunctions<kDim> functions(triangulation);
  // Middles of edges, exactly.
  for (const Simplex s : solid_simplices(triangulation.complex())) {
    Point<kDim> y;
    for (std::size_t k = 0; k < kDim; ++k) {
      y[k] = Rational((oracle.corners(s)[0][k] + oracle.corners(s)[1][k]) / 2).get_d();
    }
    const auto phi = functions.phi(y);
    double steepest2 = 0;
    for (const double g : phi.gradient) steepest2 += g * g;
    for (const auto& [t, sphere] : oracle.spheres()) {
      if (!oracle.holds(t, rational<kDim>(y))) continue;
      const Rational gradient2 = 4 * squared_distance(rational<kDim>(y), sphere.center);
      ASSERT_LE(gradient2.get_d(), steepest2 * (1 + 1e-9));
    }
  }
}

TEST(DistanceFunctions, RefusesPointsOutOfRange) {
  Triangulation2 triangulation(std::vector<Point2>{{0, 0}, {1, 0}, {0, 1}});
  DistanceFunctions<2> functions(triangulation);
  for (const Point2& bad : {Point2{2, 0}, Point2{0, HUGE_VAL}, Point2{std::nan(""), 0}}) {
    EXPECT_THROW((void)functions.pi(bad), InputError);
    EXPECT_THROW((void)functions.phi(bad), InputError);
  }
  EXPECT_EQ(functions.pi({1.5, 0}).value, 0.25);
  EXPECT_EQ(functions.phi({1.5, 0}).value, 0.75);
  EXPECT_FALSE(functions.phi({1.5, 0}).is_inside_hull);
}

// The caller may insert points between the calls.
TEST(DistanceFunctions, FollowsChangesOfTheTriangulation) {
  Triangulation3 triangulation(uniform_points<3>(50, 1));
  DistanceFunctions<3> functions(triangulation);
  for (const Point3& p : uniform_points<3>(200, 2)) {
    const double before = functions.pi(p).value;
    EXPECT_GT(before, 0);
    EXPECT_LE(functions.phi(p).value, functions.phi(p).is_inside_hull ? 0 : HUGE_VAL);
    triangulation.insert(p);
    EXPECT_EQ(functions.pi(p).value, 0);
    EXPECT_EQ(functions.phi(p).value, 0);
  }
  EXPECT_TRUE(triangulation.validate().ok());
}

}  // namespace
}  // namespace sinkmesh
