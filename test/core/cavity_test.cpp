// SPDX-License-Identifier: MIT
//
// The prestar: against the oracle, which simply compares the complex without the point and with it; and guides.
#include "core/cavity.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "core/triangulation.h"
#include "test/support/complexes.h"

namespace sinkmesh {
namespace {

using namespace test;

template <int Dim>
using Sets = std::vector<IdSet<Dim + 1>>;

template <int Dim>
Sets<Dim> difference(const Sets<Dim>& a, const Sets<Dim>& b) {
  Sets<Dim> result;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

template <int Dim>
IdSet<Dim> facet_ids(const Complex<Dim>& complex, HalfFacet h) {
  IdSet<Dim> ids;
  const std::array<Vertex, Dim> vertices = complex.facet(h);
  for (std::size_t k = 0; k < Dim; ++k) ids[k] = vertices[k].index();
  std::sort(ids.begin(), ids.end());
  return ids;
}

template <int Dim>
Sets<Dim> members_of(const Complex<Dim>& complex, const Cavity<Dim>& cavity) {
  Sets<Dim> sets;
  for (std::size_t i = 0; i < cavity.num_simplices(); ++i) sets.push_back(ids_of(complex, cavity.simplex(i)));
  std::sort(sets.begin(), sets.end());
  return sets;
}

template <int Dim>
bool same_records(const Complex<Dim>& a, const Complex<Dim>& b) {
  return a.records().size() == b.records().size() &&
         std::memcmp(a.records().data(), b.records().data(),
                     a.records().size() * sizeof(typename Complex<Dim>::Record)) == 0;
}

/// Calls check(triangulation, points, p) for grid clouds and points in, on and around them, none of them a
/// vertex.
template <int Dim, class Check>
void for_clouds_and_points(std::uint64_t seed, int clouds, Check&& check) {
  Random random(seed);
  for (int trial = 0; trial < clouds; ++trial) {
    SCOPED_TRACE(testing::Message() << "cloud " << trial);
    auto points = grid_cloud<Dim>(11, 17, 5, random);
    if (!spans_space<Dim>(points)) continue;
    Triangulation<Dim> triangulation(points);
    for (int i = 0; i < 6; ++i) {
      Point<Dim> p;
      for (double& x : p) x = uniform_int(random, 16, 22);
      if (std::find(points.begin(), points.end(), p) != points.end()) continue;
      triangulation.announce(triangulation.gate().in(p));
      check(triangulation, points, p);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

template <class Dimension>
class Prestar : public testing::Test {};
TYPED_TEST_SUITE(Prestar, Dimensions, DimensionNames);

// From every simplex in conflict, solid or ghost, the search finds the same set: what the oracle's complex
// loses.
TYPED_TEST(Prestar, IsWhatTheComplexLosesAndItsStarWhatItGains) {
  constexpr int Dim = TypeParam::value;
  std::size_t ghosts = 0;
  for_clouds_and_points<Dim>(1, 500, [&](Triangulation<Dim>& triangulation, const auto& points, const auto& p) {
    const auto& complex = triangulation.complex();
    const Point<Dim> x = triangulation.gate().in(p);
    auto more = points;
    more.push_back(p);
    const auto before = with_ghosts(brute_force_delaunay<Dim>(points));
    const auto after = with_ghosts(brute_force_delaunay<Dim>(more));
    const Complex<Dim> untouched = complex;
    const auto lost = difference<Dim>(before, after);

    Cavity<Dim> cavity;
    for (const Simplex start : untouched.simplices()) {
      if (!std::binary_search(lost.begin(), lost.end(), ids_of(untouched, start))) continue;
      ghosts += untouched.is_ghost(start) ? 1 : 0;
      ASSERT_TRUE(triangulation.grow_prestar(cavity, x, start));
      ASSERT_EQ(cavity.simplex(0), start);
      ASSERT_EQ(members_of(complex, cavity), lost);
      // Every member is marked and nothing else is.
      for (const Simplex s : untouched.simplices()) {
        const bool is_marked = complex.records()[s.index()].corner[0] & Complex<Dim>::kMark;
        ASSERT_EQ(is_marked, std::binary_search(lost.begin(), lost.end(), ids_of(untouched, s)));
      }
      // The boundary: mates, one of them inside.
      std::set<IdSet<Dim>> boundary;
      for (std::size_t i = 0; i < cavity.num_facets(); ++i) {
        const auto [outer, inner] = cavity.facet(i);
        ASSERT_EQ(complex.mate(HalfFacet(inner)), HalfFacet(outer));
        ASSERT_TRUE(boundary.insert(facet_ids(complex, HalfFacet(outer))).second);
        ASSERT_FALSE(complex.records()[outer / (Dim + 1)].corner[0] & Complex<Dim>::kMark);
        ASSERT_TRUE(complex.records()[inner / (Dim + 1)].corner[0] & Complex<Dim>::kMark);
      }
      std::set<IdSet<Dim>> expected;
      for (const IdSet<Dim>& facet : boundary_of(lost)) expected.insert(facet);
      ASSERT_EQ(boundary, expected);
      triangulation.release(cavity);
      ASSERT_TRUE(same_records(complex, untouched));
    }

    // The star on that boundary.
    Triangulation<Dim> copy = triangulation;
    const Simplex start = copy.locate(x).simplex;
    copy.grow_prestar(cavity, x, start);
    std::vector<IdSet<Dim>> facets;
    for (std::size_t i = 0; i < cavity.num_facets(); ++i) {
      facets.push_back(facet_ids(copy.complex(), HalfFacet(cavity.facet(i).outer)));
    }
    const Vertex v = copy.substitute_star(cavity, x);
    Sets<Dim> star;
    for (std::size_t i = 0; i < cavity.num_facets(); ++i) {
      const Simplex s = cavity.star(i);
      const int corner = copy.complex().index_of(s, v);
      ASSERT_GE(corner, 0);
      ASSERT_EQ(facet_ids(copy.complex(), Complex<Dim>::half_facet(s, corner)), facets[i]);
      star.push_back(ids_of(copy.complex(), s));
    }
    std::sort(star.begin(), star.end());
    ASSERT_EQ(star, difference<Dim>(after, before));
    ASSERT_TRUE(copy.validate().ok()) << copy.validate();
  });
  EXPECT_GT(ghosts, 500U);
}

// -- guides

/// Writes down what it is asked; does not enter the simplices of a set, and gives up after so many calls.
template <int Dim>
struct RecordingGuide {
  const Complex<Dim>& complex;
  Sets<Dim> walls;
  int patience = 1 << 30;
  std::vector<HalfFacet> entries{};
  std::vector<HalfFacet> crossings{};

  bool enter(HalfFacet entry) {
    entries.push_back(entry);
    return --patience > 0;
  }
  Passage cross(HalfFacet inner, HalfFacet outer) {
    EXPECT_EQ(complex.mate(inner), outer);
    crossings.push_back(inner);
    if (--patience <= 0) return Passage::stop;
    return std::binary_search(walls.begin(), walls.end(), ids_of(complex, Complex<Dim>::simplex_of(outer)))
               ? Passage::wall
               : Passage::pass;
  }
};

// What a search with walls finds is the part of the prestar around its start that is left when the walls are
// taken out.
TYPED_TEST(Prestar, EndsAtWalls) {
  constexpr int Dim = TypeParam::value;
  Random random(2);
  std::size_t parts = 0;
  for_clouds_and_points<Dim>(3, 300, [&](Triangulation<Dim>& triangulation, const auto&, const auto& p) {
    const auto& complex = triangulation.complex();
    const Complex<Dim> untouched = complex;
    const Point<Dim> x = triangulation.gate().in(p);
    Cavity<Dim> cavity;
    const Simplex start = triangulation.locate(x).simplex;
    triangulation.grow_prestar(cavity, x, start);
    const auto whole = members_of(complex, cavity);
    triangulation.release(cavity);

    // Every second simplex is a wall, in the prestar or not.
    RecordingGuide<Dim> guide{complex, {}};
    for (const Simplex s : complex.simplices()) {
      if (s != start && random() % 2 != 0) guide.walls.push_back(ids_of(complex, s));
    }
    std::sort(guide.walls.begin(), guide.walls.end());
    std::vector<Simplex> reached{start};
    for (std::size_t next = 0; next < reached.size(); ++next) {
      for (int i = 0; i <= Dim; ++i) {
        const Simplex t = complex.neighbor(reached[next], i);
        const auto ids = ids_of(complex, t);
        if (std::binary_search(whole.begin(), whole.end(), ids) &&
            !std::binary_search(guide.walls.begin(), guide.walls.end(), ids) &&
            std::find(reached.begin(), reached.end(), t) == reached.end()) {
          reached.push_back(t);
        }
      }
    }
    Sets<Dim> expected;
    for (const Simplex s : reached) expected.push_back(ids_of(complex, s));
    std::sort(expected.begin(), expected.end());

    ASSERT_TRUE(triangulation.grow_prestar(cavity, x, start, guide));
    ASSERT_EQ(members_of(complex, cavity), expected);
    parts += expected.size() < whole.size() ? 1 : 0;
    // Each member but the first was entered once, from a member; each facet of the boundary was asked for.
    ASSERT_EQ(guide.entries.size(), cavity.num_simplices() - 1);
    for (std::size_t i = 0; i < guide.entries.size(); ++i) {
      ASSERT_EQ(Complex<Dim>::simplex_of(guide.entries[i]), cavity.simplex(i + 1));
      const Simplex from = Complex<Dim>::simplex_of(complex.mate(guide.entries[i]));
      ASSERT_NE(std::find(reached.begin(), reached.end(), from), reached.end());
    }
    for (std::size_t i = 0; i < cavity.num_facets(); ++i) {
      ASSERT_EQ(std::count(guide.crossings.begin(), guide.crossings.end(), HalfFacet(cavity.facet(i).inner)),
                1);
    }
    ASSERT_EQ(guide.crossings.size(), cavity.num_facets() + cavity.num_simplices() - 1);
    triangulation.release(cavity);
    ASSERT_TRUE(same_records(complex, untouched));
  });
  EXPECT_GT(parts, 100U);
}

// Giving up at any of its calls leaves no mark behind.
TYPED_TEST(Prestar, IsReleasedWhenTheGuideGivesUp) {
  constexpr int Dim = TypeParam::value;
  std::size_t stops = 0;
  for_clouds_and_points<Dim>(4, 60, [&](Triangulation<Dim>& triangulation, const auto&, const auto& p) {
    const Complex<Dim> untouched = triangulation.complex();
    const Point<Dim> x = triangulation.gate().in(p);
    const Simplex start = triangulation.locate(x).simplex;
    Cavity<Dim> cavity;
    for (int patience = 1;; ++patience) {
      RecordingGuide<Dim> guide{triangulation.complex(), {}, patience};
      const bool finished = triangulation.grow_prestar(cavity, x, start, guide);
      ASSERT_EQ(finished, guide.patience > 0);
      if (finished) {
        triangulation.release(cavity);
        break;
      }
      ++stops;
      ASSERT_EQ(guide.entries.size() + guide.crossings.size(), static_cast<std::size_t>(patience));
      ASSERT_TRUE(same_records(triangulation.complex(), untouched));
      ASSERT_TRUE(triangulation.validate().ok());
    }
  });
  EXPECT_GT(stops, 1000U);
}

// A prestar of several hundred simplices, so that the lists grow during the search, after one of a few.
TYPED_TEST(Prestar, MayBeLarge) {
  constexpr int Dim = TypeParam::value;
  Random random(5);
  std::vector<Point<Dim>> points(800);
  for (auto& p : points) {
    p[Dim - 1] = 0;
    for (std::size_t k = 0; k + 1 < Dim; ++k) {
      p[k] = uniform(random, -1, 1);
      p[Dim - 1] += p[k] * p[k] / 2;
    }
  }
  points.push_back({});
  points.back()[Dim - 1] = 1.5;
  Triangulation<Dim> triangulation(points);
  Point<Dim> x{};
  x[Dim - 1] = -1.75;  // sees the whole paraboloid
  triangulation.announce(x);
  const Complex<Dim> untouched = triangulation.complex();
  Cavity<Dim> cavity;
  triangulation.grow_prestar(cavity, x, triangulation.locate(x).simplex);
  std::size_t marked = 0;
  for (const auto& record : triangulation.complex().records()) marked += record.corner[0] >> 31;
  EXPECT_EQ(marked, cavity.num_simplices());
  EXPECT_GT(cavity.num_simplices(), 100U);
  triangulation.release(cavity);
  EXPECT_TRUE(same_records(triangulation.complex(), untouched));
  // As many simplices go as the flips, which know no prestar, take away: the star has one for each facet.
  const auto facets = cavity.num_facets();
  const auto before = triangulation.complex().num_simplices();
  triangulation.insert(x, Engine::flips);
  EXPECT_EQ(before - marked + facets, triangulation.complex().num_simplices());
}

}  // namespace
}  // namespace sinkmesh
