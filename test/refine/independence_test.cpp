// SPDX-License-Identifier: MIT
//
// The Independence Lemma [EG01, 4.4]: I implies II, II implies III, III implies IV; and no more.
#include "refine/independence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "refine/flower.h"
#include "test/support/dimensions.h"
#include "test/support/point_sets.h"
#include "test/support/rational_geometry.h"

namespace sinkmesh {
namespace {

using namespace test;

/// The four statements for one pair of points, each from its definition: D, D_y and D_xy are built from
/// scratch.
template <int Dim>
struct Statements {
  bool independent;            ///< I
  bool no_edge;                ///< II
  bool outside_star_flower;    ///< III
  bool outside_star_balls;     ///< III after perturbation
  bool outside_flower;         ///< IV
  bool disjoint_closed_stars;  ///< what [EG01, 4.4] calls equivalent to I
  bool are_interior;           ///< x and y lie strictly inside the hull, and are no vertices
  bool general_position;  ///< x is on no sphere that decides III or IV, and D_xy has no cospherical neighbours

  Statements(std::vector<Point<Dim>> points, const Point<Dim>& x, const Point<Dim>& y) {
    Triangulation<Dim> d(points);
    const Point<Dim> x_in_d = d.gate().in(x);
    const Point<Dim> y_in_d = d.gate().in(y);
    const std::vector<Simplex> prestar_of_x = prestar(d, x_in_d);
    const std::vector<Simplex> prestar_of_y = prestar(d, y_in_d);
    const auto is_ghost = [&](Simplex s) { return d.complex().is_ghost(s); };
    are_interior = !prestar_of_x.empty() && !prestar_of_y.empty() && x != y &&
                   std::none_of(prestar_of_x.begin(), prestar_of_x.end(), is_ghost) &&
                   std::none_of(prestar_of_y.begin(), prestar_of_y.end(), is_ghost);
    if (!are_interior) return;
    independent = are_independent(d, x_in_d, y_in_d);
    const FlowerSide in_d = flower_side<Dim>(d, prestar_of_y, x_in_d);
    outside_flower = in_d != FlowerSide::inside;

    const Vertex v(static_cast<std::uint32_t>(points.size()));
    points.push_back(y);
    Triangulation<Dim> d_y(points);
    const Point<Dim> x_in_d_y = d_y.gate().in(x);
    d_y.announce(x_in_d_y);
    const std::vector<Simplex> star_of_y = star(d_y.complex(), v);
    const FlowerSide in_d_y = flower_side<Dim>(d_y, star_of_y, x_in_d_y);
    outside_star_flower = in_d_y != FlowerSide::inside;
    outside_star_balls = std::none_of(star_of_y.begin(), star_of_y.end(), [&](Simplex s) {
      return in_conflict<Dim>(d_y.complex(), d_y.predicates(), s, x_in_d_y);
    });

    const Vertex w(static_cast<std::uint32_t>(points.size()));
    points.push_back(x);
    const Triangulation<Dim> d_xy(points);
    const Complex<Dim>& complex = d_xy.complex();
    no_edge = true;
    std::set<Vertex> near_v;
    std::set<Vertex> near_w;
    for (const Simplex s : complex.simplices()) {
      const bool has_v = complex.index_of(s, v) >= 0;
      const bool has_w = complex.index_of(s, w) >= 0;
      if (has_v && has_w) no_edge = false;
      for (int i = 0; i <= Dim; ++i) {
        if (has_v) near_v.insert(complex.corner(s, i));
        if (has_w) near_w.insert(complex.corner(s, i));
      }
    }
    disjoint_closed_stars =
        std::none_of(near_v.begin(), near_v.end(), [&](Vertex u) { return near_w.contains(u); });

    general_position = in_d_y != FlowerSide::sphere && in_d != FlowerSide::sphere;
    for (const Simplex u : solid_simplices(complex)) {
      for (int i = 0; i <= Dim; ++i) {
        const HalfFacet h = complex.mate(Complex<Dim>::half_facet(u, i));
        if (complex.apex(h).is_infinite()) continue;
        const Point<Dim>& apex = complex.point(complex.apex(h));
        general_position &= d_xy.predicates().in_sphere_unperturbed(complex.corners(u), apex) != 0;
      }
    }
  }
};

template <class T>
class IndependenceTest : public testing::Test {};
TYPED_TEST_SUITE(IndependenceTest, PlaneAndSpace, DimensionName);

// Points where ties are the rule: vertices' averages of two or of Dim+1, and random ones.
template <int Dim>
Point<Dim> some_point(const std::vector<Point<Dim>>& points, Random& random) {
  const int count = uniform_int(random, 1, 3) == 1 ? 2 : Dim + 1;
  const bool is_random = random() % 2 != 0;
  Point<Dim> sum{};
  double total = 0;
  for (int i = 0; i < count; ++i) {
    const double weight = is_random ? uniform(random, 0.1, 1) : 1;
    const Point<Dim>& p = points[random() % points.size()];
    for (std::size_t k = 0; k < Dim; ++k) sum[k] += weight * p[k];
    total += weight;
  }
  for (double& x : sum) x /= total;
  return sum;
}

TYPED_TEST(IndependenceTest, EachStatementImpliesTheNext) {
  constexpr int kDim = TypeParam::value;
  std::size_t holds[5] = {};
  std::size_t pairs = 0;
  std::size_t general = 0;
  Random random(11);
  std::vector<PointSet<kDim>> sets = point_sets<kDim>(40, 6);
  for (std::uint64_t seed = 0; seed < 8; ++seed) sets.push_back({"uniform", uniform_points<kDim>(80, seed)});
  sets.push_back({"grid", grid_points<kDim>(kDim == 2 ? 7 : 4)});
  sets.push_back({"circle or sphere", sphere_points<kDim>()});
  for (const PointSet<kDim>& set : sets) {
    SCOPED_TRACE(set.name);
    for (int trial = 0; trial < 60; ++trial) {
      SCOPED_TRACE(trial);
      const Point<kDim> x = some_point<kDim>(set.points, random);
      const Point<kDim> y = some_point<kDim>(set.points, random);
      const Statements<kDim> s(set.points, x, y);
      if (!s.are_interior) continue;
      ++pairs;
      holds[1] += s.independent ? 1 : 0;
      holds[2] += s.no_edge ? 1 : 0;
      holds[3] += s.outside_star_flower ? 1 : 0;
      holds[4] += s.outside_flower ? 1 : 0;
      ASSERT_LE(s.independent, s.no_edge) << "I => II";
      ASSERT_LE(s.no_edge, s.outside_star_flower) << "II => III";
      ASSERT_LE(s.outside_star_flower, s.outside_flower) << "III => IV";
      ASSERT_EQ(s.independent, s.disjoint_closed_stars);
      // After perturbation, and so in general position, II and III are equivalent.
      ASSERT_EQ(s.no_edge, s.outside_star_balls);
      if (s.general_position) {
        ++general;
        ASSERT_EQ(s.no_edge, s.outside_star_flower);
      }
    }
  }
  EXPECT_GT(pairs, 500U);
  EXPECT_GT(general, 100U);
  // The statements differ, so that the implications say something.
  EXPECT_GT(holds[1], 20U);
  EXPECT_LT(holds[1], holds[2]);
  EXPECT_LT(holds[2], holds[3]);
  EXPECT_LT(holds[3], holds[4]);
  EXPECT_LT(holds[4], pairs);
}

// No converse holds. All coordinates are integers; I and IV fail or hold in general position.

TEST(IndependenceLemma, PointsWithoutAnEdgeNeedNotBeIndependentInThePlane) {
  // The vertex (1,0) is in the closures of both prestars.
  const Statements<2> s({{-1, -2}, {2, -2}, {-1, 2}, {2, 2}, {1, 0}}, {1, 1}, {1, -1});
  EXPECT_TRUE(s.are_interior && s.general_position);
  EXPECT_TRUE(s.no_edge && s.outside_star_flower && s.outside_flower);
  EXPECT_FALSE(s.independent);
}

TEST(IndependenceLemma, PointsWithoutAnEdgeNeedNotBeIndependentInSpace) {
  const Statements<3> s(
      {{-1, 0, 0}, {3, 3, -3}, {-2, 2, -3}, {3, -2, 1}, {-3, -3, 2}, {-1, 0, 2}, {-2, 3, 3}, {2, 3, 3}},
      {-1, -1, 2}, {-1, 2, -2});
  EXPECT_TRUE(s.are_interior && s.general_position);
  EXPECT_TRUE(s.no_edge && s.outside_star_flower && s.outside_flower);
  EXPECT_FALSE(s.independent);
}

// III does not imply II, but for this a tie is needed: x lies on the spheres of the star of y, so not in the
// interior of the flower; the perturbation raises the lexicographically first point, -e1, the most, and the
// cospherical points are divided along the edge from x to y.
TEST(IndependenceLemma, PointsOutsideTheFlowerOfTheStarCanHaveAnEdgeInThePlane) {
  const Statements<2> s({{-1, 0}, {1, 0}, {-4, -5}, {4, -5}, {-4, 5}, {4, 5}}, {0, 1}, {0, -1});
  EXPECT_TRUE(s.are_interior);
  EXPECT_TRUE(s.outside_star_flower);
  EXPECT_FALSE(s.no_edge);
}

TEST(IndependenceLemma, PointsOutsideTheFlowerOfTheStarCanHaveAnEdgeInSpace) {
  const Statements<3> s({{-1, 0, 0},
                         {1, 0, 0},
                         {0, -1, 0},
                         {0, 1, 0},
                         {-6, -6, -7},
                         {6, -6, -7},
                         {-6, 6, -7},
                         {6, 6, -7},
                         {-6, -6, 7},
                         {6, -6, 7},
                         {-6, 6, 7},
                         {6, 6, 7}},
                        {0, 0, 1}, {0, 0, -1});
  EXPECT_TRUE(s.are_interior);
  EXPECT_TRUE(s.outside_star_flower);
  EXPECT_FALSE(s.no_edge);
}

// Inserting y makes its flower grow over x.
TEST(IndependenceLemma, PointsOutsideTheFlowerOfThePrestarCanBeInsideThatOfTheStarInThePlane) {
  const Statements<2> s({{-2, -1}, {2, 2}, {1, -2}, {0, 0}}, {0, -1}, {1, 0});
  EXPECT_TRUE(s.are_interior && s.general_position);
  EXPECT_TRUE(s.outside_flower);
  EXPECT_FALSE(s.outside_star_flower || s.no_edge || s.independent);
}

TEST(IndependenceLemma, PointsOutsideTheFlowerOfThePrestarCanBeInsideThatOfTheStarInSpace) {
  const Statements<3> s({{3, 1, 3}, {0, 1, -3}, {-1, -3, -2}, {-3, 0, -1}, {-3, -3, 3}, {3, 3, -1}, {1, 1, 0}},
                        {0, 0, -2}, {-2, -1, 1});
  EXPECT_TRUE(s.are_interior && s.general_position);
  EXPECT_TRUE(s.outside_flower);
  EXPECT_FALSE(s.outside_star_flower || s.no_edge || s.independent);
}

// Sharing a vertex is enough to be dependent: no simplex, no facet, and no edge is shared here.
TEST(IndependenceLemma, ClosuresThatShareOneVertexAreNotDisjoint) {
  // Two triangles that touch at the origin, far apart otherwise.
  const Triangulation2 d(std::vector<Point2>{
      {0, 0}, {2, 1}, {2, -1}, {-2, 1}, {-2, -1}, {0, 3}, {0, -3}, {9, 9}, {-9, 9}, {9, -9}, {-9, -9}});
  const auto at = [&](const Point2& p) { return d.locate(d.gate().in(p)).simplex; };
  const std::vector<Simplex> right = {at({1.5, 0})};
  const std::vector<Simplex> left = {at({-1.5, 0})};
  const std::vector<Simplex> far = {at({8.5, 0})};
  EXPECT_FALSE(have_disjoint_closures<2>(d.complex(), right, left));
  EXPECT_TRUE(have_disjoint_closures<2>(d.complex(), left, far));
}

}  // namespace
}  // namespace sinkmesh
