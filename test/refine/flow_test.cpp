// SPDX-License-Identifier: MIT
//
// The flow relation [EG01, 3.3].
#include "refine/flow.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/triangulation.h"
#include "test/support/dimensions.h"
#include "test/support/exact_signs.h"
#include "test/support/point_sets.h"
#include "test/support/rational_geometry.h"

namespace sinkmesh {
namespace {

using namespace test;

// Degenerate sets: cospherical by the thousand, coplanar layers, and all integer points on one sphere.
template <int Dim>
std::vector<PointSet<Dim>> large_sets() {
  std::vector<PointSet<Dim>> sets = {{"uniform", uniform_points<Dim>(2000, 1)},
                                     {"grid", grid_points<Dim>(Dim == 2 ? 20 : 8)},
                                     {"tenth", grid_points<Dim>(Dim == 2 ? 15 : 6, 0.1)},
                                     {"sphere", sphere_points<Dim>()}};
  sets.push_back({"sphere with center", sets.back().points});
  sets.back().points.push_back(Point<Dim>{});
  sets.push_back({"small integers", uniform_points<Dim>(400, 2)});
  for (auto& p : sets.back().points) {
    for (double& x : p) x = std::floor(5 * x);
  }
  return sets;
}

template <class T>
class FlowTest : public testing::Test {};
TYPED_TEST_SUITE(FlowTest, PlaneAndSpace, DimensionName);

TYPED_TEST(FlowTest, IsTheSideOfTheExactCircumcenterOrAPerturbedTie) {
  constexpr int kDim = TypeParam::value;
  std::size_t ties = 0;
  for (const PointSet<kDim>& set : large_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    Flow<kDim> flow(triangulation);
    for (const Simplex s : solid_simplices(triangulation.complex())) {
      const auto corners = rational_corners<kDim>(triangulation.complex().corners(s));
      // Negative for corner i: the center lies beyond the facet opposite i. Independent of the polynomial G.
      const auto weight = barycentric<kDim>(corners, orthosphere<kDim>(corners).center);
      for (int i = 0; i <= kDim; ++i) {
        const bool crosses = flow.crosses(Complex<kDim>::half_facet(s, i));
        const int sign = sgn(weight[static_cast<std::size_t>(i)]);
        if (sign == 0) {
          ++ties;
        } else {
          ASSERT_EQ(crosses, sign < 0);
        }
      }
    }
  }
  EXPECT_GT(ties, 500U);
}

// Repeatedly takes away what has no successor left: everything goes iff there is no cycle. Then each simplex
// leads to a sink or to omega, because a simplex that is neither has a successor.
TYPED_TEST(FlowTest, IsAcyclicAndEndsInSinksOrOmega) {
  constexpr int kDim = TypeParam::value;
  std::vector<PointSet<kDim>> sets = large_sets<kDim>();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<PointSet<kDim>> more = point_sets<kDim>(60, seed);
    sets.insert(sets.end(), more.begin(), more.end());
  }
  for (const PointSet<kDim>& set : sets) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    const Complex<kDim>& complex = triangulation.complex();
    Flow<kDim> flow(triangulation);
    std::vector<std::size_t> out(complex.num_slots(), 0);
    std::vector<Simplex> done;
    std::size_t sinks = 0;
    for (const Simplex s : complex.simplices()) {
      const std::vector<Simplex> successors = flow.successors(s);
      out[s.index()] = successors.size();
      // In the plane at most one angle is obtuse.
      ASSERT_LE(successors.size(), kDim == 2 ? 1U : 3U);
      if (!successors.empty()) continue;
      done.push_back(s);
      EXPECT_EQ(flow.is_sink(s), !complex.is_ghost(s));
      sinks += flow.is_sink(s) ? 1 : 0;
    }
    for (std::size_t next = 0; next < done.size(); ++next) {
      for (int i = 0; i <= kDim; ++i) {
        const HalfFacet into = complex.mate(Complex<kDim>::half_facet(done[next], i));
        const Simplex before = Complex<kDim>::simplex_of(into);
        if (flow.crosses(into) && --out[before.index()] == 0) done.push_back(before);
      }
    }
    EXPECT_EQ(done.size(), complex.num_simplices());
    EXPECT_EQ(flow.sinks().size(), sinks);
  }
}

TEST(Flow, UnitCubeHasOneSink) {
  const Triangulation3 cube(grid_points<3>(2));
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
TYPED_TEST(FlowTest, BulkSearchesAgreeWithSingleOnes) {
  constexpr int kDim = TypeParam::value;
  const Triangulation<kDim> triangulation(uniform_points<kDim>(300, 9));
  const Complex<kDim>& complex = triangulation.complex();
  Flow<kDim> flow(triangulation);
  const std::vector<Simplex> sinks = flow.sinks();
  ASSERT_GT(sinks.size(), 100U);
  std::vector<std::vector<Simplex>> ancestors_of(complex.num_slots());
  for (const Simplex sink : sinks) {
    for (const Simplex s : flow.ancestors({sink})) ancestors_of[s.index()].push_back(sink);
  }
  std::vector<Simplex> all;
  std::vector<Simplex> expected_for_all;
  for (const Simplex s : solid_simplices(complex)) {
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

// Without perturbation: a tie shares its center with the neighbour, and its radius.
TYPED_TEST(FlowTest, RadiusGrowsAlongItStrictlyButForTies) {
  constexpr int kDim = TypeParam::value;
  std::size_t steps = 0;
  std::size_t equal = 0;
  for (const PointSet<kDim>& set : large_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    const Complex<kDim>& complex = triangulation.complex();
    Flow<kDim> flow(triangulation);
    for (const Simplex s : solid_simplices(complex)) {
      if (s.index() % 5 != 0) continue;
      for (const Simplex t : flow.successors(s)) {
        if (complex.is_ghost(t)) continue;
        const auto from = circumsphere<kDim>(complex, s);
        const auto to = circumsphere<kDim>(complex, t);
        ++steps;
        if (from.center == to.center) {
          ++equal;
          ASSERT_EQ(from.radius2, to.radius2);
        } else {
          ASSERT_LT(from.radius2, to.radius2);
        }
      }
    }
  }
  EXPECT_GT(steps, 500U);
  EXPECT_GT(equal, 20U);
}

// With real weights, tiny enough to decide every tie as the symbolic ones do, the radii of the orthospheres
// grow strictly, whatever the degeneracy: the reason why the relation is acyclic [PS, 2b].
TYPED_TEST(FlowTest, OrthoradiusGrowsStrictlyAlongIt) {
  constexpr int kDim = TypeParam::value;
  std::size_t steps = 0;
  std::size_t ties = 0;
  for (const PointSet<kDim>& set : point_sets<kDim>(kDim == 2 ? 24 : 14, 5)) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    const Complex<kDim>& complex = triangulation.complex();
    const ExactPoints<kDim> exact(set.points);
    const TinyWeights weights(exact.ranks(), exact.bits(), 2 * kDim + 4);
    Flow<kDim> flow(triangulation);
    const auto sphere = [&](Simplex s) {
      std::array<RationalPoint<kDim>, kDim + 1> p;
      std::array<Rational, kDim + 1> lift;
      for (std::size_t i = 0; i <= kDim; ++i) {
        const std::size_t v = complex.corner(s, static_cast<int>(i)).index();
        for (std::size_t k = 0; k < kDim; ++k) p[i][k] = exact[v][k];
        lift[i] = weights.lift[v];
        mpq_div_2exp(lift[i].get_mpq_t(), lift[i].get_mpq_t(), weights.unit);
      }
      return orthosphere<kDim>(p, lift);
    };
    std::vector<Rational> radius2(complex.num_slots());
    for (const Simplex s : solid_simplices(complex)) radius2[s.index()] = sphere(s).radius2;
    for (const Simplex s : solid_simplices(complex)) {
      for (const Simplex t : flow.successors(s)) {
        if (complex.is_ghost(t)) continue;
        ++steps;
        ties += circumsphere<kDim>(complex, s).center == circumsphere<kDim>(complex, t).center ? 1 : 0;
        ASSERT_LT(radius2[s.index()], radius2[t.index()]) << s << ' ' << t;
      }
    }
  }
  EXPECT_GT(steps, 100U);
  EXPECT_GT(ties, 5U);
}

// In a Poisson process the expected fraction of sinks among all Delaunay simplices is 1/2 in the plane, where
// they are the acute triangles, and 105/384 in space.
TYPED_TEST(FlowTest, SinkFractionOfUniformPointsIsThatOfPoisson) {
  constexpr int kDim = TypeParam::value;
  const Triangulation<kDim> triangulation(uniform_points<kDim>(1000000, 12));
  const Complex<kDim>& complex = triangulation.complex();
  Flow<kDim> flow(triangulation);
  std::size_t interior = 0;
  std::size_t sinks = 0;
  for (const Simplex s : complex.simplices()) {
    if (complex.is_ghost(s)) continue;
    const Corners<kDim> corners = complex.corners(s);
    const auto is_central = [&](const Point<kDim>* p) {
      // Gated coordinates: the unit cube becomes one of side between 1 and 2.
      const Point<kDim> q = triangulation.gate().out(*p);
      return std::all_of(q.begin(), q.end(), [](double x) { return 0.05 < x && x < 0.95; });
    };
    if (!std::all_of(corners.begin(), corners.end(), is_central)) continue;
    ++interior;
    sinks += flow.is_sink(s) ? 1 : 0;
  }
  EXPECT_GT(interior, kDim == 2 ? 1600000U : 4000000U);
  const double fraction = static_cast<double>(sinks) / static_cast<double>(interior);
  if constexpr (kDim == 2) {
    EXPECT_NEAR(fraction, 0.5, 0.003);
  } else {
    EXPECT_NEAR(fraction, 105.0 / 384, 0.0015);
  }
}

}  // namespace
}  // namespace sinkmesh
