// SPDX-License-Identifier: MIT
//
// The flips themselves: that every kind occurs, and what one replacement does to the complex.
#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "core/flip_inserter.h"
#include "core/retriangulator.h"
#include "core/triangulation.h"
#include "test/support/complexes.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class Dimension>
class Flips : public testing::Test {};
TYPED_TEST_SUITE(Flips, Dimensions, DimensionNames);

/// Inserts one point as Triangulation::insert does, with an inserter whose flips can be counted.
template <int Dim>
Location<Dim> insert_counted(Triangulation<Dim>& triangulation, FlipInserter<Dim>& inserter,
                             const PointArg<Dim>& p) {
  const Point<Dim> x = triangulation.gate().in(p);
  triangulation.announce(x);
  const Location<Dim> at = triangulation.locate(x);
  if (!at.is_at_corner()) {
    const Vertex v = triangulation.mutable_complex().add_vertex(x);
    inserter.insert(triangulation.mutable_complex(), triangulation.predicates(), at, v);
  }
  return at;
}

// On a small grid inserted in random order, points fall into simplices, facets, edges and outside, and
// everything is coplanar with something. The number of simplices must change as the flips say.
TYPED_TEST(Flips, OfEveryKindOccurAndAccountForTheNumberOfSimplices) {
  constexpr int Dim = TypeParam::value;
  Random random(1);
  typename FlipInserter<Dim>::Counts total;
  std::map<int, int> insertions;  // by the dimension of the face that is subdivided, +1; 0: outside
  for (int trial = 0; trial < 20; ++trial) {
    auto points = full_grid<Dim>(Dim == 2 ? 8 : 4);
    std::shuffle(points.begin(), points.end(), random);
    points = with_basis_first<Dim>(points);
    Point<Dim> scale;
    scale.fill(8);
    points.insert(points.begin(), scale);
    Triangulation<Dim> triangulation(std::span<const Point<Dim>>(points).first(Dim + 2));
    FlipInserter<Dim> inserter;
    for (std::size_t i = Dim + 2; i < points.size(); ++i) {
      const auto before = triangulation.complex().num_simplices();
      const auto old = inserter.counts();
      const Location<Dim> at = insert_counted(triangulation, inserter, points[i]);
      ++insertions[at.support()];
      const auto now = inserter.counts();
      ASSERT_EQ(now.subdivisions, old.subdivisions + 1);
      // A face of dimension d whose link has f simplices becomes d+1 simplices for each of the f.
      const auto face = static_cast<std::size_t>(at.support() == 0 ? Dim + 1 : at.support());
      const auto after = triangulation.complex().num_simplices();
      const auto gained =
          after + (now.three_to_two - old.three_to_two) - (now.two_to_three - old.two_to_three) - before;
      ASSERT_EQ(gained % (face - 1), 0U);
      if (face == Dim + 1) {
        ASSERT_EQ(gained, static_cast<std::size_t>(Dim));
      }
      if (face == Dim) {
        ASSERT_EQ(gained, 2U * (Dim - 1));
      }
      ASSERT_TRUE(triangulation.validate().ok()) << triangulation.validate();
    }
    total.subdivisions += inserter.counts().subdivisions;
    total.two_to_two += inserter.counts().two_to_two;
    total.two_to_three += inserter.counts().two_to_three;
    total.three_to_two += inserter.counts().three_to_two;
    total.four_to_four += inserter.counts().four_to_four;
    EXPECT_EQ(triangulation.hash(), Triangulation<Dim>(points, Engine::star).hash());
  }
  EXPECT_GT(insertions[0], 0) << "outside the hull";
  EXPECT_EQ(insertions[1], 0) << "at a vertex";
  for (int support = 2; support <= Dim + 1; ++support) EXPECT_GT(insertions[support], 0) << support;
  EXPECT_EQ(total.two_to_two > 0, Dim == 2);
  EXPECT_EQ(total.two_to_three > 0, Dim == 3);
  EXPECT_EQ(total.three_to_two > 0, Dim == 3);
  EXPECT_EQ(total.four_to_four > 0, Dim == 3);
}

// Four points of the plane through an edge, around which there are four tetrahedra, and the edge is the wrong
// diagonal.
TEST(FlipsInSpace, FourToFourChangesTheDiagonalOfAnOctahedron) {
  // The octahedron ±e1, ±e2, ±2 e3 and, to begin with, without e2.
  const std::vector<Point3> points{{1, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 2}, {0, 0, -2}};
  Triangulation3 triangulation(points);
  FlipInserter<3> inserter;
  insert_counted(triangulation, inserter, {0, 0.5, 0});
  EXPECT_TRUE(triangulation.validate().ok()) << triangulation.validate();
  auto all = points;
  all.push_back({0, 0.5, 0});
  EXPECT_EQ(simplex_sets(triangulation.complex()), simplex_sets(Triangulation3(all, Engine::star).complex()));
}

// The flips leave infinity where it is; other callers need not.
TYPED_TEST(Flips, MayPutInfinityAnywhere) {
  constexpr int Dim = TypeParam::value;
  const Triangulation<Dim> original(full_grid<Dim>(2));
  Simplex ghost;
  for (const Simplex s : original.complex().simplices()) {
    if (original.complex().is_ghost(s)) ghost = s;
  }
  std::array<std::size_t, Dim + 1> order;
  std::iota(order.begin(), order.end(), std::size_t{0});
  do {
    std::size_t inversions = 0;
    std::array<Vertex, Dim + 1> corners;
    for (std::size_t i = 0; i <= Dim; ++i) {
      corners[i] = original.complex().corner(ghost, static_cast<int>(order[i]));
      for (std::size_t j = 0; j < i; ++j) inversions += order[j] > order[i] ? 1 : 0;
    }
    Triangulation<Dim> triangulation = original;
    Retriangulator<Dim>().replace(triangulation.mutable_complex(), std::vector{ghost}, std::vector{corners});
    EXPECT_TRUE(triangulation.complex().is_ghost(ghost));
    EXPECT_EQ(triangulation.validate().ok(), inversions % 2 == 0) << triangulation.validate();
  } while (std::next_permutation(order.begin(), order.end()));
}

// 2-3 in space and 2-2 in the plane, there and back.
TYPED_TEST(Flips, CanBeUndone) {
  constexpr int Dim = TypeParam::value;
  // Two simplices on either side of the first Dim points.
  std::vector<Point<Dim>> points(Dim + 2);
  for (std::size_t i = 1; i < Dim; ++i) points[i][i] = 4;
  points[Dim].fill(1);
  points[Dim + 1].fill(1);
  points[Dim][0] = 3;
  points[Dim + 1][0] = -3;

  // `left` out of the order gives one simplex of the ball; swapping two corners keeps or turns its sign.
  const auto without = [&](std::uint32_t left) {
    std::array<Vertex, Dim + 1> corners;
    std::array<Point<Dim>, Dim + 1> p;
    std::size_t k = 0;
    for (std::uint32_t i = 0; i < Dim + 2; ++i) {
      if (i == left) continue;
      p[k] = points[i];
      corners[k++] = Vertex(i);
    }
    if (integer_volume<Dim>(p) < 0) std::swap(corners[0], corners[1]);
    return corners;
  };
  Complex<Dim> complex;
  for (const auto& p : points) complex.add_vertex(p);
  complex.make_sphere(without(Dim + 1));
  Retriangulator<Dim> retriangulator;
  // The ghost on the shared facet becomes the other solid and its ghosts.
  Simplex ghost;
  for (const Simplex s : complex.simplices()) {
    if (complex.is_ghost(s) && complex.index_of(s, Vertex(Dim)) < 0) ghost = s;
  }
  std::vector<std::array<Vertex, Dim + 1>> fresh;
  for (int i = 0; i <= Dim; ++i) {
    std::array<Vertex, Dim + 1> corners;
    for (int k = 0; k <= Dim; ++k) {
      corners[static_cast<std::size_t>(k)] = k == i ? Vertex(Dim + 1) : complex.corner(ghost, k);
    }
    fresh.push_back(corners);
  }
  retriangulator.replace(complex, std::vector{ghost}, fresh);

  Box<Dim> box;
  for (const auto& p : points) box.include(p);
  const Predicates<Dim> predicates(box, 0);
  const auto is_sound = [&] {
    const auto report = validate(complex, predicates);
    return report.violations.size() == report.count("D2");  // one of the two is not Delaunay
  };
  EXPECT_TRUE(is_sound()) << validate(complex, predicates);
  const auto before = simplex_sets(complex);

  std::vector<Simplex> old;
  for (const Simplex s : complex.simplices()) {
    if (complex.is_solid(s)) old.push_back(s);
  }
  ASSERT_EQ(old.size(), 2U);
  fresh.clear();
  for (std::uint32_t i = 0; i < Dim; ++i) fresh.push_back(without(i));
  const auto created = retriangulator.replace(complex, old, fresh);
  EXPECT_EQ(created.size(), static_cast<std::size_t>(Dim));
  EXPECT_TRUE(is_sound()) << validate(complex, predicates);
  const auto flipped = simplex_sets(complex);
  EXPECT_NE(flipped, before);

  retriangulator.replace(complex, created, std::vector{without(Dim), without(Dim + 1)});
  EXPECT_TRUE(is_sound()) << validate(complex, predicates);
  EXPECT_EQ(simplex_sets(complex), before);
  EXPECT_EQ(complex.free_slots().size(), Dim == 2 ? 0U : 1U);
}

}  // namespace
}  // namespace sinkmesh
