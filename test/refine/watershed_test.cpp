// SPDX-License-Identifier: MIT
//
// Ancestor sets, sets of sinks, and their labels [EG01, 3.3].
#include "refine/watershed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/star.h"
#include "refine/sink_walk.h"
#include "test/support/dimensions.h"
#include "test/support/point_sets.h"
#include "test/support/rational_geometry.h"

namespace sinkmesh {
namespace {

using namespace test;

template <int Dim>
std::vector<PointSet<Dim>> small_sets() {
  std::vector<PointSet<Dim>> sets = point_sets<Dim>(50, 3);
  sets.push_back({"more uniform", uniform_points<Dim>(Dim == 2 ? 600 : 150, 4)});
  sets.push_back({"grid", grid_points<Dim>(Dim == 2 ? 9 : 4)});
  sets.push_back({"sphere", sphere_points<Dim>()});
  return sets;
}

// The sinks reached from each simplex, from the definition: transitive closure, from successors decided by
// exact centers where they are not tied.
template <int Dim>
std::vector<std::set<Simplex>> sets_of_sinks(Flow<Dim>& flow) {
  const Complex<Dim>& complex = flow.complex();
  std::vector<std::set<Simplex>> sinks(complex.num_slots());
  for (const Simplex s : solid_simplices(complex)) {
    if (flow.successors(s).empty()) sinks[s.index()].insert(s);
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (const Simplex s : solid_simplices(complex)) {
      for (const Simplex t : flow.successors(s)) {
        for (const Simplex sink : sinks[t.index()]) changed |= sinks[s.index()].insert(sink).second;
      }
    }
  }
  return sinks;
}

template <class T>
class WatershedTest : public testing::Test {};
TYPED_TEST_SUITE(WatershedTest, PlaneAndSpace, DimensionName);

TYPED_TEST(WatershedTest, CountsAreThoseOfTheTransitiveClosure) {
  constexpr int kDim = TypeParam::value;
  std::size_t several = 0;
  for (const PointSet<kDim>& set : small_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    Flow<kDim> flow(triangulation);
    const std::vector<std::set<Simplex>> expected = sets_of_sinks<kDim>(flow);
    const std::vector<std::uint32_t> count = count_sinks(flow);
    for (const Simplex s : triangulation.complex().simplices()) {
      ASSERT_EQ(count[s.index()], expected[s.index()].size()) << s;
      several += count[s.index()] > 1 ? 1 : 0;
    }
  }
  // In the plane maximal ancestor sets are disjoint; in space they are not.
  if constexpr (kDim == 2) {
    EXPECT_EQ(several, 0U);
  } else {
    EXPECT_GT(several, 50U);
  }
}

TYPED_TEST(WatershedTest, LabelIsTheFirstSinkOfTheSteepestWalk) {
  constexpr int kDim = TypeParam::value;
  std::size_t to_omega = 0;
  std::size_t labelled = 0;
  for (const PointSet<kDim>& set : small_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    Flow<kDim> flow(triangulation);
    const Watersheds<kDim> watersheds = find_watersheds(flow);
    EXPECT_EQ(watersheds.sinks, flow.sinks());
    SinkWalk<kDim> walk;
    for (const Simplex s : triangulation.complex().simplices()) {
      Simplex first;
      walk(flow, s, [&](Simplex sink) {
        first = sink;
        return true;
      });
      const std::int32_t label = watersheds[s];
      ASSERT_EQ(label == Watersheds<kDim>::kOmega, first.is_null()) << s;
      if (first.is_null()) {
        to_omega += triangulation.complex().is_ghost(s) ? 0 : 1;
      } else {
        ++labelled;
        ASSERT_EQ(watersheds.sinks[static_cast<std::size_t>(label)], first) << s;
      }
    }
  }
  EXPECT_GT(to_omega, 20U);
  EXPECT_GT(labelled, 500U);
}

// From the definition, without SinkWalk: at every simplex the way goes to the successor of the largest exact
// circumradius from which a sink can be reached.
TYPED_TEST(WatershedTest, SteepestMeansTheLargestExactRadius) {
  constexpr int kDim = TypeParam::value;
  const Triangulation<kDim> triangulation(uniform_points<kDim>(200, 8));
  const Complex<kDim>& complex = triangulation.complex();
  Flow<kDim> flow(triangulation);
  const Watersheds<kDim> watersheds = find_watersheds(flow);
  const std::vector<std::set<Simplex>> reached = sets_of_sinks<kDim>(flow);
  std::size_t choices = 0;
  for (const Simplex s : solid_simplices(complex)) {
    std::vector<Simplex> successors = flow.successors(s);
    std::erase_if(successors, [&](Simplex t) { return reached[t.index()].empty(); });
    if (successors.empty()) continue;
    const Simplex best = *std::max_element(successors.begin(), successors.end(), [&](Simplex a, Simplex b) {
      return circumsphere<kDim>(complex, a).radius2 < circumsphere<kDim>(complex, b).radius2;
    });
    choices += successors.size() > 1 ? 1 : 0;
    ASSERT_EQ(watersheds[s], watersheds[best]);
  }
  if constexpr (kDim == 3) {
    EXPECT_GT(choices, 50U);
  }
}

TYPED_TEST(WatershedTest, DoesNotDependOnTheOrderOfPointsNorOnTheEngine) {
  constexpr int kDim = TypeParam::value;
  for (const PointSet<kDim>& set : small_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    // Simplices by their coordinates, each with the coordinates of its sink.
    using Key = std::vector<Point<kDim>>;
    const auto labels = [](const std::vector<Point<kDim>>& points, Engine engine) {
      const Triangulation<kDim> triangulation(points, engine);
      Flow<kDim> flow(triangulation);
      const Watersheds<kDim> watersheds = find_watersheds(flow);
      const auto key = [&](Simplex s) {
        Key k;
        for (const Point<kDim>* p : triangulation.complex().corners(s)) k.push_back(*p);
        std::sort(k.begin(), k.end());
        return k;
      };
      std::map<Key, Key> result;
      for (const Simplex s : solid_simplices(triangulation.complex())) {
        const std::int32_t label = watersheds[s];
        result[key(s)] = label < 0 ? Key() : key(watersheds.sinks[static_cast<std::size_t>(label)]);
      }
      return result;
    };
    std::vector<Point<kDim>> shuffled = set.points;
    Random random(2);
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    EXPECT_EQ(labels(set.points, Engine::star), labels(shuffled, Engine::flips));
  }
}

TYPED_TEST(WatershedTest, BoundariesSeparateLabels) {
  constexpr int kDim = TypeParam::value;
  for (const PointSet<kDim>& set : small_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    const Complex<kDim>& complex = triangulation.complex();
    Flow<kDim> flow(triangulation);
    const Watersheds<kDim> watersheds = find_watersheds(flow);
    std::set<HalfFacet> separating;
    for (const HalfFacet h : watershed_boundaries(complex, watersheds)) {
      EXPECT_TRUE(separating.insert(h).second);
      EXPECT_FALSE(separating.contains(complex.mate(h)));
      EXPECT_FALSE(complex.is_ghost(Complex<kDim>::simplex_of(h)));
    }
    // Each facet between different labels, from one side or the other; ghosts have the label of omega.
    for (const Simplex s : solid_simplices(complex)) {
      for (int i = 0; i <= kDim; ++i) {
        const HalfFacet h = Complex<kDim>::half_facet(s, i);
        ASSERT_EQ(separating.contains(h) || separating.contains(complex.mate(h)),
                  watersheds[s] != watersheds[complex.neighbor(s, i)]);
      }
    }
    // Without the separating facets, the complex falls into pieces of one label each, and each watershed is one
    // piece: its simplices flow to the sink without leaving it.
    std::set<Simplex> met;
    std::map<std::int32_t, int> pieces;
    for (const Simplex s : solid_simplices(complex)) {
      if (met.contains(s)) continue;
      ++pieces[watersheds[s]];
      std::vector<Simplex> piece{s};
      met.insert(s);
      while (!piece.empty()) {
        const Simplex at = piece.back();
        piece.pop_back();
        ASSERT_EQ(watersheds[at], watersheds[s]);
        for (int i = 0; i <= kDim; ++i) {
          const HalfFacet h = Complex<kDim>::half_facet(at, i);
          const Simplex next = complex.neighbor(at, i);
          if (separating.contains(h) || separating.contains(complex.mate(h)) || complex.is_ghost(next))
            continue;
          if (met.insert(next).second) piece.push_back(next);
        }
      }
    }
    for (const auto& [label, count] : pieces) {
      if (label >= 0) {
        EXPECT_EQ(count, 1) << label;
      }
    }
    EXPECT_GE(pieces.size(), watersheds.sinks.size());
  }
}

// The boundary of an ancestor set is crossed by the flow outwards only, or not at all.
TYPED_TEST(WatershedTest, NoFlowEntersAnAncestorSet) {
  constexpr int kDim = TypeParam::value;
  for (const PointSet<kDim>& set : small_sets<kDim>()) {
    SCOPED_TRACE(set.name);
    const Triangulation<kDim> triangulation(set.points);
    const Complex<kDim>& complex = triangulation.complex();
    Flow<kDim> flow(triangulation);
    for (const Simplex sink : flow.sinks()) {
      const std::vector<Simplex> ancestors = flow.ancestors({sink});
      ASSERT_EQ(ancestors.front(), sink);
      const std::vector<HalfFacet> edge = boundary<kDim>(complex, ancestors);
      EXPECT_FALSE(edge.empty());
      for (const HalfFacet h : edge) {
        const Simplex outside = Complex<kDim>::simplex_of(complex.mate(h));
        EXPECT_EQ(std::count(ancestors.begin(), ancestors.end(), outside), 0);
        EXPECT_FALSE(flow.crosses(complex.mate(h)));
        // In the plane, where a triangle has one successor, none leaves it either.
        if (kDim == 2) {
          EXPECT_FALSE(flow.crosses(h));
        }
      }
    }
  }
}

// [EG01, 3.3] "it can also belong to more than one ancestor set": the tetrahedron of the first four points
// flows into two sinks.
TEST(Watershed, ATetrahedronInSpaceCanHaveSeveralSinks) {
  const std::vector<Point3> points = {{-2, -2, -1}, {-1, 1, -2}, {-2, 1, 0}, {-2, -1, 1}, {2, -1, -1}};
  const Triangulation3 triangulation(points);
  Flow<3> flow(triangulation);
  std::size_t found = 0;
  for (const Simplex s : solid_simplices(triangulation.complex())) {
    std::set<std::uint32_t> corners;
    for (int i = 0; i < 4; ++i) corners.insert(triangulation.complex().corner(s, i).index());
    if (corners != std::set<std::uint32_t>{0, 1, 2, 3}) continue;
    ++found;
    const std::vector<Simplex> sinks = flow.sinks_reached({s});
    ASSERT_EQ(sinks.size(), 2U);
    EXPECT_NE(circumsphere<3>(triangulation.complex(), sinks[0]).center,
              circumsphere<3>(triangulation.complex(), sinks[1]).center);
    EXPECT_EQ(count_sinks(flow)[s.index()], 2U);
    const std::int32_t label = find_watersheds(flow)[s];
    ASSERT_GE(label, 0);
    const Simplex steepest = find_watersheds(flow).sinks[static_cast<std::size_t>(label)];
    EXPECT_NE(std::find(sinks.begin(), sinks.end(), steepest), sinks.end());
  }
  EXPECT_EQ(found, 1U);
}

}  // namespace
}  // namespace sinkmesh
