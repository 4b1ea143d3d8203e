// SPDX-License-Identifier: MIT
#include "core/bulk_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "core/conflict.h"
#include "core/triangulation.h"
#include "test/support/dimensions.h"
#include "test/support/point_sets.h"

namespace sinkmesh {
namespace {

template <class T>
class BulkSearchIn : public testing::Test {};
TYPED_TEST_SUITE(BulkSearchIn, test::PlaneAndSpace, test::DimensionName);

// Points on a parabola or paraboloid lie beyond the hull of any others; in a random order the ways are long,
// too.
template <int Dim>
std::vector<Point<Dim>> paraboloid_points(std::size_t n) {
  std::vector<Point<Dim>> points = test::uniform_points<Dim>(n, 3);
  for (auto& p : points) {
    p[Dim - 1] = 0;
    for (std::size_t k = 0; k + 1 < Dim; ++k) p[Dim - 1] += p[k] * p[k] / 2;
  }
  return points;
}

// The fewest points from the front that span the space.
template <int Dim>
Triangulation<Dim> from_the_first(std::span<const Point<Dim>> points, std::size_t& count) {
  for (count = Dim + 1;; ++count) {
    try {
      return Triangulation<Dim>(points.first(count));
    } catch (const DegenerateInput&) {
      if (count == points.size()) throw;
    }
  }
}

// Inserts the points one by one, from the first few on, as bulk loading does.
TYPED_TEST(BulkSearchIn, FindsAConflictForEveryPoint) {
  constexpr int kDim = TypeParam::value;
  std::vector<test::PointSet<kDim>> sets = test::point_sets<kDim>(300, 7);
  sets.push_back({"paraboloid", paraboloid_points<kDim>(600)});
  sets.push_back({"sphere", test::sphere_points<kDim>()});
  std::size_t found = 0;
  std::size_t ghosts = 0;
  for (auto& set : sets) {
    SCOPED_TRACE(set.name);
    // The largest coordinate, which fixes the units, comes first.
    const auto largest = [](const Point<kDim>& p) {
      double most = 0;
      for (const double x : p) most = std::max(most, std::abs(x));
      return most;
    };
    std::iter_swap(set.points.begin(),
                   std::max_element(set.points.begin(), set.points.end(),
                                    [&](const auto& p, const auto& q) { return largest(p) < largest(q); }));
    std::size_t i = 0;
    Triangulation<kDim> grown = from_the_first<kDim>(set.points, i);
    BulkSearch<kDim> search;
    Cavity<kDim> cavity;
    for (; i < set.points.size(); ++i) {
      const Point<kDim> p = grown.gate().in(set.points[i]);
      grown.announce(p);
      const Complex<kDim>& complex = grown.complex();
      if (grown.locate(p).is_at_corner()) continue;  // twice in the set
      const Simplex s = search.find(complex, grown.predicates(), p);
      ASSERT_TRUE(complex.is_alive(s));
      ASSERT_TRUE(in_conflict(complex, grown.predicates(), s, p));
      ghosts += complex.is_ghost(s) ? 1 : 0;
      ++found;
      grown.grow_prestar(cavity, p, s);
      const Vertex v = grown.substitute_star(cavity, p);
      search.settle(complex, cavity, v);
    }
    EXPECT_TRUE(grown.validate().ok());
    EXPECT_TRUE(grown.is_delaunay());
  }
  EXPECT_GT(found, 1000U);
  EXPECT_GT(ghosts, found / 10);
}

}  // namespace
}  // namespace sinkmesh
