// SPDX-License-Identifier: MIT
#include "core/star_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/triangulation.h"
#include "test/support/brute_force.h"
#include "test/support/dimensions.h"
#include "test/support/point_sets.h"

namespace sinkmesh {
namespace {

template <class T>
class StarWalks : public testing::Test {
 public:
  static constexpr int kSpace = T::value;
  using Points = std::vector<Point<kSpace>>;
  using Facet = std::array<Vertex, kSpace>;

  static std::vector<std::pair<std::string, Points>> sets() {
    return {{"random", test::uniform_points<kSpace>(30, 5)},
            {"grid", test::grid_points<kSpace>(kSpace == 2 ? 5 : 3)},
            {"sphere", test::sphere_points<kSpace>()}};
  }

  template <std::size_t N>
  static std::array<Vertex, N> vertices(const test::IdSet<N>& ids) {
    std::array<Vertex, N> result;
    for (std::size_t k = 0; k < N; ++k) result[k] = Vertex(ids[k]);
    return result;
  }
  static Facet sorted(Facet facet) {
    std::sort(facet.begin(), facet.end());
    return facet;
  }
};
TYPED_TEST_SUITE(StarWalks, test::PlaneAndSpace, test::DimensionName);

// Against the sets of all facets and edges, over all subsets of the vertices.
TYPED_TEST(StarWalks, FindsExactlyTheFacetsAndEdgesThatThereAre) {
  constexpr int kDim = TypeParam::value;
  for (const auto& [name, points] : this->sets()) {
    SCOPED_TRACE(name);
    const Triangulation<kDim> triangulation(points);
    const Complex<kDim>& complex = triangulation.complex();
    std::set<typename TestFixture::Facet> facets;
    std::set<std::pair<Vertex, Vertex>> edges;
    for (const Simplex s : complex.simplices()) {
      for (int i = 0; i <= kDim; ++i) {
        facets.insert(this->sorted(complex.facet(Complex<kDim>::half_facet(s, i))));
        for (int j = 0; j < i; ++j) edges.insert(std::minmax(complex.corner(s, i), complex.corner(s, j)));
      }
    }
    StarWalk<kDim> walk;
    const auto n = static_cast<std::uint32_t>(std::min<std::size_t>(points.size(), 40));
    test::Random random(1);
    std::size_t found = 0;
    test::for_all_subsets<kDim>(n, [&](const test::IdSet<kDim>& ids) {
      auto corners = this->vertices(ids);
      std::shuffle(corners.begin(), corners.end(), random);
      const HalfFacet h = walk.find_facet(complex, corners);
      ASSERT_EQ(!h.is_null(), facets.contains(this->sorted(corners)));
      if (h.is_null()) return;
      ++found;
      ASSERT_EQ(this->sorted(complex.facet(h)), this->sorted(corners));
    });
    EXPECT_GT(found, 20U);
    test::for_all_subsets<2>(n, [&](const test::IdSet<2>& ids) {
      const bool expected = edges.contains({Vertex(ids[0]), Vertex(ids[1])});
      ASSERT_EQ(walk.has_edge(complex, Vertex(ids[0]), Vertex(ids[1])), expected);
      ASSERT_EQ(walk.has_edge(complex, Vertex(ids[1]), Vertex(ids[0])), expected);
    });
  }
}

TYPED_TEST(StarWalks, VisitsTheWholeStarOnceAndStopsWhenTold) {
  constexpr int kDim = TypeParam::value;
  for (const auto& [name, points] : this->sets()) {
    SCOPED_TRACE(name);
    const Triangulation<kDim> triangulation(points);
    const Complex<kDim>& complex = triangulation.complex();
    StarWalk<kDim> walk;
    for (std::uint32_t v = 0; v < points.size(); ++v) {
      std::vector<Simplex> star;
      for (const Simplex s : complex.simplices()) {
        if (complex.index_of(s, Vertex(v)) >= 0) star.push_back(s);
      }
      std::vector<Simplex> visited;
      EXPECT_FALSE(walk(complex, Vertex(v), [&](Simplex s) { return visited.push_back(s), false; }));
      std::sort(visited.begin(), visited.end());
      ASSERT_EQ(visited, star);
      std::size_t calls = 0;
      EXPECT_TRUE(walk(complex, Vertex(v), [&](Simplex) { return ++calls == star.size(); }));
      EXPECT_EQ(calls, star.size());
    }
  }
}

// Every start, and queries inside and outside the hull, some of them at the same distance from many vertices.
TYPED_TEST(StarWalks, NearestVertexIsTheNearestOfAllTiesByCoordinates) {
  constexpr int kDim = TypeParam::value;
  for (const auto& [name, points] : this->sets()) {
    SCOPED_TRACE(name);
    const Triangulation<kDim> triangulation(points);
    const Complex<kDim>& complex = triangulation.complex();
    StarWalk<kDim> walk;
    test::Random random(2);
    double size = 0;
    for (const auto& p : points) size = std::max(size, *std::max_element(p.begin(), p.end()));
    for (int query = 0; query < 60; ++query) {
      Point<kDim> p;
      for (double& x : p) x = test::uniform(random, -0.5 * size, 1.5 * size);
      if (query % 3 != 0) {
        for (double& x : p) x = std::round(2 * x / size * 4) / 8 * size;  // the same for many
      }
      if (!triangulation.gate().admits(p)) continue;
      p = triangulation.gate().in(p);
      const auto distance2 = [&](Vertex v) {
        double sum = 0;
        for (std::size_t k = 0; k < kDim; ++k) {
          sum += (complex.point(v)[k] - p[k]) * (complex.point(v)[k] - p[k]);
        }
        return sum;
      };
      Vertex best(0);
      for (std::uint32_t v = 1; v < points.size(); ++v) {
        if (std::pair(distance2(Vertex(v)), complex.point(Vertex(v))) <
            std::pair(distance2(best), complex.point(best))) {
          best = Vertex(v);
        }
      }
      for (std::uint32_t start = 0; start < points.size(); start += 3) {
        ASSERT_EQ(walk.nearest(complex, p, Vertex(start)), best) << "from " << start;
      }
    }
  }
}

}  // namespace
}  // namespace sinkmesh
