// SPDX-License-Identifier: MIT
//
// pi and phi [EG01, 3.1, 3.2], against all points and all spheres in rationals.
#include "refine/distance_functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/star.h"
#include "refine/flow.h"
#include "test/support/dimensions.h"
#include "test/support/point_sets.h"
#include "test/support/rational_geometry.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class T>
class DistanceFunctionsTest : public testing::Test {};
TYPED_TEST_SUITE(DistanceFunctionsTest, PlaneAndSpace, DimensionName);

template <int Dim>
std::vector<PointSet<Dim>> small_sets() {
  std::vector<PointSet<Dim>> sets = point_sets<Dim>(40, 7);
  sets.push_back({"grid", grid_points<Dim>(Dim == 2 ? 6 : 3)});
  // Gated by 2^-21: values must come back in the units of the input.
  sets.push_back({"large", uniform_points<Dim>(60, 3)});
  for (auto& p : sets.back().points) {
    for (double& x : p) x = 3e6 * x - 1e6;
  }
  return sets;
}

/// Everything from the definitions: the smallest square distance to a point, the smallest power of all spheres.
template <int Dim>
class Oracle {
 public:
  Oracle(const std::vector<Point<Dim>>& points, const Triangulation<Dim>& triangulation) {
    for (const Point<Dim>& p : points) points_.push_back(rational<Dim>(p));
    const Complex<Dim>& complex = triangulation.complex();
    for (const Simplex s : solid_simplices(complex)) {
      std::array<RationalPoint<Dim>, Dim + 1> corners;
      for (int i = 0; i <= Dim; ++i) {
        corners[static_cast<std::size_t>(i)] = rational<Dim>(points[complex.corner(s, i).index()]);
      }
      corners_[s] = corners;
      spheres_[s] = orthosphere<Dim>(corners);
    }
  }

  Rational pi(const RationalPoint<Dim>& x) const {
    Rational smallest = squared_distance(x, points_[0]);
    for (const auto& p : points_) smallest = std::min(smallest, squared_distance(x, p));
    return smallest;
  }
  Rational phi(const RationalPoint<Dim>& y) const {
    Rational smallest = spheres_.begin()->second.power(y);
    for (const auto& [s, sphere] : spheres_) smallest = std::min(smallest, sphere.power(y));
    return smallest;
  }
  bool holds(Simplex s, const RationalPoint<Dim>& y) const {
    const auto weights = barycentric<Dim>(corners_.at(s), y);
    return std::all_of(weights.begin(), weights.end(), [](const Rational& w) { return w >= 0; });
  }
  bool is_in_hull(const RationalPoint<Dim>& y) const {
    return std::any_of(corners_.begin(), corners_.end(), [&](const auto& e) { return holds(e.first, y); });
  }
  const RationalSphere<Dim>& sphere(Simplex s) const { return spheres_.at(s); }
  const std::map<Simplex, RationalSphere<Dim>>& spheres() const { return spheres_; }
  const std::array<RationalPoint<Dim>, Dim + 1>& corners(Simplex s) const { return corners_.at(s); }

 private:
  std::vector<RationalPoint<Dim>> points_;
  std::map<Simplex, std::array<RationalPoint<Dim>, Dim + 1>> corners_;
  std::map<Simplex, RationalSphere<Dim>> spheres_;
};

// Points at vertices, in the middle of edges and facets (exactly there for small integers), between vertices,
// around them, and outside the hull.
template <int Dim>
std::vector<Point<Dim>> samples(const std::vector<Point<Dim>>& points, std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point<Dim>> result;
  double extent = 0;
  for (const auto& p : points) {
    for (const double x : p) extent = std::max(extent, std::abs(x));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Point<Dim>& a = points[random() % points.size()];
    Point<Dim> y = a;
    const std::size_t kind = i % 5;
    if (kind == 1 || kind == 2) {
      const Point<Dim>& b = points[random() % points.size()];
      for (std::size_t k = 0; k < Dim; ++k) y[k] = a[k] / 2 + b[k] / 2;
    } else if (kind == 3) {
      double total = 0;
      y = {};
      for (int j = 0; j <= Dim; ++j) {
        const double weight = uniform(random, 0.01, 1);
        const Point<Dim>& b = points[random() % points.size()];
        for (std::size_t k = 0; k < Dim; ++k) y[k] += weight * b[k];
        total += weight;
      }
      for (double& x : y) x /= total;
    } else if (kind == 4) {
      for (double& x : y) x = std::clamp(x + 0.4 * extent * uniform(random, -1, 1), -extent, extent);
    }
    result.push_back(y);
  }
  return result;
}

/// A point nearer to x than any two different values of these sets of doubles are to each other.
template <int Dim>
RationalPoint<Dim> beside(RationalPoint<Dim> x, const RationalPoint<Dim>& direction) {
  for (std::size_t k = 0; k < Dim; ++k) {
    Rational step = direction[k];
    mpq_div_2exp(step.get_mpq_t(), step.get_mpq_t(), 3000);
    x[k] += step;
  }
  return x;
}

template <int Dim>
RationalPoint<Dim> some_direction(Random& random) {
  RationalPoint<Dim> u{};
  while (u == RationalPoint<Dim>{}) {
    for (auto& x : u) x = uniform_int(random, -9, 9);
  }
  return u;
}

double relative_error(double value, const Rational& exact) {
  if (exact == 0) return value == 0 ? 0 : HUGE_VAL;
  const Rational error = (Rational(value) - exact) / exact;
  return std::abs(error.get_d());
}

TYPED_TEST(DistanceFunctionsTest, PiIsTheSquareDistanceToTheNearestPoint) {
  constexpr int kDim = TypeParam::value;
  for (const PointSet<kDim>& set : small_sets<kDim>()) {
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
  for (const PointSet<kDim>& set : small_sets<kDim>()) {
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
  for (const PointSet<kDim>& set : small_sets<kDim>()) {
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
  for (const PointSet<kDim>& set : small_sets<kDim>()) {
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

// [EG01, 3.2] The local maxima of pi are the sinks. Let z be the center of a simplex, and C its cell: the
// simplices around it with the same center. The vertices at distance r from z are the corners of C, and pi near
// z is |z-p|^2 for the nearest of them. If z is in the interior of conv C, every step away from z gets nearer to
// a corner; if not, a step along the outer normal of a facet of C that z does not lie strictly inside of gets
// nearer to none. In general position C is one simplex: a sink, or not. In a degenerate set the flow from a
// simplex of C can leave C only across a facet that z is not strictly inside of, so if z is in the interior,
// one simplex of C is a sink.
TYPED_TEST(DistanceFunctionsTest, LocalMaximaOfPiAreTheSinks) {
  constexpr int kDim = TypeParam::value;
  std::size_t maxima = 0;
  std::size_t others = 0;
  Random random(9);
  for (const PointSet<kDim>& set : small_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    const Complex<kDim>& complex = triangulation.complex();
    const Oracle<kDim> oracle(set.points, triangulation);
    Flow<kDim> flow(triangulation);
    std::map<RationalPoint<kDim>, std::vector<Simplex>> cells;
    for (const auto& [s, sphere] : oracle.spheres()) cells[sphere.center].push_back(s);
    for (const auto& [center, cell] : cells) {
      const RationalPoint<kDim>& z = center;
      // Where z lies with respect to the facets that bound the cell.
      RationalPoint<kDim> uphill{};
      bool is_interior = true;
      bool is_outside = false;
      for (const HalfFacet h : boundary<kDim>(complex, cell)) {
        const auto i = static_cast<std::size_t>(Complex<kDim>::corner_of(h));
        const auto corners = oracle.corners(Complex<kDim>::simplex_of(h));
        const Rational side = barycentric<kDim>(corners, z)[i];
        if (side > 0) continue;
        is_interior = false;
        is_outside = is_outside || side < 0;
        // The outer normal: the barycentric coordinate falls along it.
        for (std::size_t k = 0; k < kDim; ++k) {
          RationalPoint<kDim> moved = z;
          moved[k] += 1;
          uphill[k] = side - barycentric<kDim>(corners, moved)[i];
        }
      }
      const bool has_sink = std::any_of(cell.begin(), cell.end(), [&](Simplex s) { return flow.is_sink(s); });
      if (is_interior) {
        ASSERT_TRUE(has_sink);
      }
      if (is_outside) {
        ASSERT_FALSE(has_sink);
      }

      // The same from pi alone, next to z.
      const Rational here = oracle.pi(z);
      ASSERT_EQ(here, oracle.sphere(cell[0]).radius2);
      if (is_interior) {
        ++maxima;
        for (int trial = 0; trial < 3; ++trial) {
          ASSERT_LT(oracle.pi(beside<kDim>(z, some_direction<kDim>(random))), here);
        }
      } else {
        ++others;
        ASSERT_GT(oracle.pi(beside<kDim>(z, uphill)), here);
      }
    }
  }
  EXPECT_GT(maxima, 100U);
  EXPECT_GT(others, 100U);
}

// [EG01, 3.2] The minima of phi are the centers that lie in their simplices, its maxima the vertices. Elsewhere
// the gradient leads down, as shown above, and phi is strictly convex along the face that holds y, so that it
// rises one way or the other.
TYPED_TEST(DistanceFunctionsTest, LocalExtremesOfPhiAreSinksAndVertices) {
  constexpr int kDim = TypeParam::value;
  std::size_t minima = 0;
  std::size_t maxima = 0;
  std::size_t others = 0;
  Random random(10);
  for (const PointSet<kDim>& set : small_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    const Complex<kDim>& complex = triangulation.complex();
    const Oracle<kDim> oracle(set.points, triangulation);
    for (const auto& [s, sphere] : oracle.spheres()) {
      const auto weights = barycentric<kDim>(oracle.corners(s), sphere.center);
      if (!std::all_of(weights.begin(), weights.end(), [](const Rational& w) { return w > 0; })) continue;
      ++minima;
      ASSERT_EQ(oracle.phi(sphere.center), -sphere.radius2);
      for (int trial = 0; trial < 3; ++trial) {
        ASSERT_GT(oracle.phi(beside<kDim>(sphere.center, some_direction<kDim>(random))), -sphere.radius2);
      }
    }
    for (std::uint32_t v = 0; v < set.points.size(); ++v) {
      const std::vector<Simplex> around = star(complex, Vertex(v));
      if (std::any_of(around.begin(), around.end(), [&](Simplex s) { return complex.is_ghost(s); })) continue;
      ++maxima;
      const auto p = rational<kDim>(set.points[v]);
      for (int trial = 0; trial < 3; ++trial) {
        ASSERT_LT(oracle.phi(beside<kDim>(p, some_direction<kDim>(random))), 0);
      }
    }
    for (const Point<kDim>& sample : samples<kDim>(set.points, 20, 4)) {
      const auto y = rational<kDim>(sample);
      for (const auto& [s, sphere] : oracle.spheres()) {
        if (!oracle.holds(s, y)) continue;
        // Two corners of the face that holds y, if it is no vertex.
        std::vector<RationalPoint<kDim>> face;
        const auto weights = barycentric<kDim>(oracle.corners(s), y);
        for (std::size_t i = 0; i <= kDim; ++i) {
          if (weights[i] != 0) face.push_back(oracle.corners(s)[i]);
        }
        if (face.size() < 2) break;
        RationalPoint<kDim> along;
        RationalPoint<kDim> back;
        for (std::size_t k = 0; k < kDim; ++k) {
          along[k] = face[1][k] - face[0][k];
          back[k] = -along[k];
        }
        ++others;
        const Rational here = oracle.phi(y);
        ASSERT_TRUE(oracle.phi(beside<kDim>(y, along)) > here || oracle.phi(beside<kDim>(y, back)) > here);
        break;
      }
    }
  }
  EXPECT_GT(minima, 80U);
  EXPECT_GT(maxima, 100U);
  EXPECT_GT(others, 100U);
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
