// SPDX-License-Identifier: MIT
#include "refine/flow.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/triangulation.h"

namespace sinkmesh {
namespace {

using Rational = mpq_class;

// The solution of a linear system of three equations, by Cramer's rule.
std::array<Rational, 3> solve(const std::array<std::array<Rational, 4>, 3>& rows) {
  const auto det = [&](int i, int j, int k) -> Rational {
    const auto& r = rows;
    return r[0][i] * (r[1][j] * r[2][k] - r[1][k] * r[2][j]) -
           r[0][j] * (r[1][i] * r[2][k] - r[1][k] * r[2][i]) +
           r[0][k] * (r[1][i] * r[2][j] - r[1][j] * r[2][i]);
  };
  const Rational d = det(0, 1, 2);
  return {det(3, 1, 2) / d, det(0, 3, 2) / d, det(0, 1, 3) / d};
}

// The circumcenter from |z-p|^2 = |z-a|^2, and its barycentric coordinates: negative for corner i means that it
// lies beyond the facet opposite i. Independent of the polynomial G.
std::array<int, 4> barycentric_signs(const Corners<3>& corners) {
  std::array<std::array<Rational, 3>, 4> p;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 3; ++k) p[i][k] = (*corners[i])[k];
  }
  std::array<std::array<Rational, 4>, 3> equations;
  for (std::size_t i = 1; i < 4; ++i) {
    Rational right = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      equations[i - 1][k] = 2 * (p[i][k] - p[0][k]);
      right += p[i][k] * p[i][k] - p[0][k] * p[0][k];
    }
    equations[i - 1][3] = right;
  }
  const auto z = solve(equations);
  std::array<std::array<Rational, 4>, 3> weights;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 1; i < 4; ++i) weights[k][i - 1] = p[i][k] - p[0][k];
    weights[k][3] = z[k] - p[0][k];
  }
  const auto w = solve(weights);
  return {sgn(Rational(1 - w[0] - w[1] - w[2])), sgn(w[0]), sgn(w[1]), sgn(w[2])};
}

struct Cloud {
  const char* name;
  std::vector<Point3> points;
};

std::vector<Point3> grid(int n) {
  std::vector<Point3> points;
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      for (int z = 0; z < n; ++z) points.push_back({1.0 * x, 1.0 * y, 1.0 * z});
    }
  }
  return points;
}

std::vector<Point3> uniform(int n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Point3> points(static_cast<std::size_t>(n));
  for (Point3& p : points) {
    for (double& x : p) x = static_cast<double>(random() >> 11) * 0x1p-53;
  }
  return points;
}

// Degenerate sets: cospherical by the thousand, coplanar layers, and all integer points on one sphere.
std::vector<Cloud> clouds() {
  std::vector<Cloud> result = {{"uniform", uniform(2000, 1)}, {"grid", grid(8)}};
  Cloud tenth{"tenth", grid(6)};
  for (Point3& p : tenth.points) {
    for (double& x : p) x *= 0.1;
  }
  result.push_back(tenth);
  Cloud sphere{"sphere", {}};
  for (int x = -9; x <= 9; ++x) {
    for (int y = -9; y <= 9; ++y) {
      for (int z = -9; z <= 9; ++z) {
        if (x * x + y * y + z * z == 81) sphere.points.push_back({1.0 * x, 1.0 * y, 1.0 * z});
      }
    }
  }
  result.push_back(sphere);
  sphere.name = "sphere with center";
  sphere.points.push_back({0, 0, 0});
  result.push_back(sphere);
  Cloud lattice{"small integers", uniform(400, 2)};
  for (Point3& p : lattice.points) {
    for (double& x : p) x = std::floor(5 * x);
  }
  result.push_back(lattice);
  return result;
}

TEST(Flow, IsTheSideOfTheExactCircumcenterOrAPerturbedTie) {
  std::size_t ties = 0;
  for (const Cloud& cloud : clouds()) {
    SCOPED_TRACE(cloud.name);
    const Triangulation3 triangulation(cloud.points);
    Flow<3> flow(triangulation);
    for (const Simplex s : triangulation.complex().simplices()) {
      if (triangulation.complex().is_ghost(s)) continue;
      const std::array<int, 4> sign = barycentric_signs(triangulation.complex().corners(s));
      for (int i = 0; i < 4; ++i) {
        const bool crosses = flow.crosses(Complex<3>::half_facet(s, i));
        if (sign[static_cast<std::size_t>(i)] == 0) {
          ++ties;
        } else {
          ASSERT_EQ(crosses, sign[static_cast<std::size_t>(i)] < 0);
        }
      }
    }
  }
  EXPECT_GT(ties, 1000U);
}

// Repeatedly takes away what has no successor left: everything goes iff there is no cycle. Then each simplex
// leads to a sink or to omega, because a simplex that is neither has a successor.
TEST(Flow, IsAcyclicAndEndsInSinksOrOmegaOnDegenerateInput) {
  for (const Cloud& cloud : clouds()) {
    SCOPED_TRACE(cloud.name);
    const Triangulation3 triangulation(cloud.points);
    const Complex<3>& complex = triangulation.complex();
    Flow<3> flow(triangulation);
    std::vector<int> out(complex.num_slots(), 0);
    std::vector<Simplex> done;
    std::size_t sinks = 0;
    for (const Simplex s : complex.simplices()) {
      for (int i = 0; i < 4; ++i) out[s.index()] += flow.crosses(Complex<3>::half_facet(s, i)) ? 1 : 0;
      ASSERT_LE(out[s.index()], 3);
      if (out[s.index()] == 0) {
        done.push_back(s);
        EXPECT_EQ(flow.is_sink(s), !complex.is_ghost(s));
        sinks += flow.is_sink(s) ? 1 : 0;
      }
    }
    for (std::size_t next = 0; next < done.size(); ++next) {
      for (int i = 0; i < 4; ++i) {
        const HalfFacet into = complex.mate(Complex<3>::half_facet(done[next], i));
        const Simplex before = Complex<3>::simplex_of(into);
        if (flow.crosses(into) && --out[before.index()] == 0) done.push_back(before);
      }
    }
    EXPECT_EQ(done.size(), complex.num_simplices());
    EXPECT_EQ(flow.sinks().size(), sinks);
  }
}

TEST(Flow, UnitCubeHasOneSink) {
  const Triangulation3 cube(grid(2));
  Flow<3> flow(cube);
  ASSERT_EQ(cube.num_solid(), 6U);
  const std::vector<Simplex> sinks = flow.sinks();
  ASSERT_EQ(sinks.size(), 1U);
  std::vector<std::uint32_t> corners;
  for (int i = 0; i < 4; ++i) corners.push_back(cube.complex().corner(sinks[0], i).index());
  std::sort(corners.begin(), corners.end());
  EXPECT_EQ(corners, (std::vector<std::uint32_t>{1, 2, 3, 4}));  // [PS, 12]
  EXPECT_EQ(flow.ancestors(sinks).size(), 6U);
}

// Searches are compared with walks from each simplex alone.
TEST(Flow, BulkSearchesAgreeWithSingleOnes) {
  const Triangulation3 triangulation(uniform(300, 9));
  const Complex<3>& complex = triangulation.complex();
  Flow<3> flow(triangulation);
  const std::vector<Simplex> sinks = flow.sinks();
  ASSERT_GT(sinks.size(), 100U);
  std::vector<std::vector<Simplex>> ancestors_of(complex.num_slots());
  for (const Simplex sink : sinks) {
    for (const Simplex s : flow.ancestors({sink})) ancestors_of[s.index()].push_back(sink);
  }
  std::vector<Simplex> all;
  std::vector<Simplex> expected_for_all;
  for (const Simplex s : complex.simplices()) {
    if (complex.is_ghost(s)) continue;
    std::vector<Simplex> reached = flow.sinks_reached({s});
    std::sort(reached.begin(), reached.end());
    std::vector<Simplex>& expected = ancestors_of[s.index()];
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(reached, expected) << s;
    if (s.index() % 7 == 0) {
      all.push_back(s);
      expected_for_all.insert(expected_for_all.end(), expected.begin(), expected.end());
    }
  }
  std::sort(expected_for_all.begin(), expected_for_all.end());
  expected_for_all.erase(std::unique(expected_for_all.begin(), expected_for_all.end()), expected_for_all.end());
  std::vector<Simplex> together = flow.sinks_reached(all);
  std::sort(together.begin(), together.end());
  EXPECT_EQ(together, expected_for_all);
}

TEST(Flow, RadiusGrowsAlongIt) {
  const Triangulation3 triangulation(uniform(2000, 4));
  Flow<3> flow(triangulation);
  const Complex<3>& complex = triangulation.complex();
  const auto radius2 = [&](Simplex s) {
    // By Cramer's rule, in rationals.
    const Corners<3> c = complex.corners(s);
    std::array<std::array<Rational, 4>, 3> equations;
    for (std::size_t i = 1; i < 4; ++i) {
      Rational right = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Rational d = Rational((*c[i])[k]) - (*c[0])[k];
        equations[i - 1][k] = 2 * d;
        right += d * d;
      }
      equations[i - 1][3] = right;
    }
    const auto z = solve(equations);
    return Rational(z[0] * z[0] + z[1] * z[1] + z[2] * z[2]);
  };
  std::size_t steps = 0;
  for (const Simplex s : complex.simplices()) {
    if (complex.is_ghost(s) || s.index() % 10 != 0) continue;
    for (int i = 0; i < 4; ++i) {
      const HalfFacet h = Complex<3>::half_facet(s, i);
      const Simplex t = complex.neighbor(s, i);
      if (!flow.crosses(h) || complex.is_ghost(t)) continue;
      ++steps;
      ASSERT_LT(radius2(s), radius2(t));
    }
  }
  EXPECT_GT(steps, 500U);
}

// In a Poisson process the expected fraction of sinks among all Delaunay tetrahedra is 105/384.
TEST(Flow, SinkFractionOfUniformPointsIsThatOfPoisson) {
  const Triangulation3 triangulation(uniform(1000000, 12));
  const Complex<3>& complex = triangulation.complex();
  Flow<3> flow(triangulation);
  std::size_t interior = 0;
  std::size_t sinks = 0;
  for (const Simplex s : complex.simplices()) {
    if (complex.is_ghost(s)) continue;
    const Corners<3> corners = complex.corners(s);
    const auto is_central = [&](const Point3* p) {
      // Gated coordinates: the unit cube becomes one of side between 1 and 2.
      const Point3 q = triangulation.gate().out(*p);
      return std::all_of(q.begin(), q.end(), [](double x) { return 0.05 < x && x < 0.95; });
    };
    if (!std::all_of(corners.begin(), corners.end(), is_central)) continue;
    ++interior;
    sinks += flow.is_sink(s) ? 1 : 0;
  }
  EXPECT_GT(interior, 4000000U);
  EXPECT_NEAR(static_cast<double>(sinks) / static_cast<double>(interior), 105.0 / 384, 0.0015);
}

}  // namespace
}  // namespace sinkmesh
