// SPDX-License-Identifier: MIT
//
// In which order off-sinks go in, and which of them make a round: against lists and all pairs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "core/conflict.h"
#include "core/mix.h"
#include "core/vector.h"
#include "predicates/circumcenter.h"
#include "refine/domain.h"
#include "refine/independence.h"
#include "refine/off_sink.h"
#include "refine/refiner.h"
#include "test/support/dimensions.h"
#include "test/support/point_sets.h"
#include "test/support/surfaces.h"

namespace sinkmesh {
namespace {

using namespace test;

/// What is stable of the convex hull of random points: nothing ties.
template <int Dim>
struct Inside {
  explicit Inside(std::uint64_t seed) : Inside(uniform_points<Dim>(Dim == 2 ? 300 : 250, seed)) {}
  explicit Inside(const std::vector<Point<Dim>>& points)
      : triangulation(points), domain(triangulation), flow(triangulation) {
    const Complex<Dim>& complex = triangulation.complex();
    std::vector<typename Domain<Dim>::Facet> hull;
    for (const Simplex s : complex.simplices()) {
      if (complex.is_ghost(s)) hull.push_back(complex.facet(complex.mate(Complex<Dim>::half_facet(s, Dim))));
    }
    EXPECT_TRUE(domain.label_facets(hull).empty());
    domain.peel(flow);
  }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;

  /// All, in the order in which they were inserted.
  std::vector<Point<Dim>> points() const {
    std::vector<Point<Dim>> result;
    for (std::uint32_t v = 0; v < triangulation.complex().num_vertices(); ++v) {
      result.push_back(triangulation.complex().point(Vertex(v)));
    }
    return result;
  }

  Triangulation<Dim> triangulation;
  Domain<Dim> domain;
  Flow<Dim> flow;
  std::size_t shared = 0;  ///< points of more than one simplex that have been met
};

template <int Dim>
struct Listed {
  Simplex owner;
  Point<Dim> point;
  double radius2;  ///< of the ball that holds no vertex
  double length2;  ///< of the shortest edge of the owner
  double key;      ///< the least comes first; simplices with the same shortest edge are not far to seek
  double size2;    ///< then the smallest circumradius, where the shortest edge is the key
  std::uint64_t tie;
};

/// The off-sinks of all simplices of low quality, in an order, of those in one place the first.
template <int Dim>
std::vector<Listed<Dim>> list(Inside<Dim>& inside, double max_ratio, double reach, Order order) {
  std::vector<Listed<Dim>> result;
  OffSinkWalk<Dim> walk;
  for (const Simplex s : inside.domain.simplices()) {
    const Shape shape = sinkmesh::shape<Dim>(inside.triangulation.complex().corners(s));
    if (!(shape.radius2 > max_ratio * max_ratio * shape.shortest2)) continue;
    const auto found = walk(inside.flow, s, reach * reach * max_ratio * max_ratio * shape.shortest2);
    if (!found) continue;
    const double key = order == Order::ratio      ? -shape.radius2 / shape.shortest2
                       : order == Order::shortest ? shape.shortest2
                                                  : shape.radius2;
    const std::uint64_t tie = hash_points<Dim>(inside.triangulation.complex().corners(s));
    const double size2 = order == Order::shortest ? shape.radius2 : 0;
    result.push_back({s, found->point, found->distance2, shape.shortest2, key, size2, tie});
  }
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    return std::tuple(a.key, a.size2, a.tie) < std::tuple(b.key, b.size2, b.tie);
  });
  std::set<Point<Dim>> met;
  inside.shared += std::erase_if(result, [&](const auto& entry) { return !met.insert(entry.point).second; });
  return result;
}

/// Exact, and nothing ties.
template <int Dim>
bool holds(const Inside<Dim>& inside, Simplex s, const Point<Dim>& x) {
  return in_conflict(inside.triangulation.complex(), inside.triangulation.predicates(), s, x);
}

/// Whether a point may go in next to the boundary, and is far enough from what is there. Walls are Gabriel in
/// a stable domain, so it does not matter which of them the prestar reaches.
template <int Dim>
bool is_refused(const Inside<Dim>& inside, const Listed<Dim>& entry, const std::vector<Point<Dim>>& vertices) {
  const Complex<Dim>& complex = inside.triangulation.complex();
  for (const HalfFacet wall : inside.domain.boundary()) {
    if (inside.triangulation.predicates().diametral_side(complex.facet_corners(wall), entry.point) <= 0)
      return true;
    const Simplex outer = Complex<Dim>::simplex_of(complex.mate(wall));
    if (holds<Dim>(inside, outer, entry.point)) return true;
  }
  return std::any_of(vertices.begin(), vertices.end(), [&](const Point<Dim>& p) {
    return squared_distance(p, entry.point) < entry.length2 * (1 - 1e-12);
  });
}

template <class T>
class OrderTest : public testing::Test {};
TYPED_TEST_SUITE(OrderTest, PlaneAndSpace, DimensionName);

constexpr Order kOrders[] = {Order::ratio, Order::shortest, Order::smallest};

TEST(Order, DefaultLeavesTheFewestSimplices) {
  for (const bool divides : {false, true}) {
    for (const Insert insert : {Insert::sink, Insert::circumcenter}) {
      EXPECT_EQ(default_order<2>(insert, divides), Order::ratio);
      EXPECT_EQ(default_order<3>(insert, divides), Order::ratio);
    }
    EXPECT_EQ(default_order<2>(Insert::off_sink, divides), Order::shortest);
  }
  EXPECT_EQ(default_order<3>(Insert::off_sink, false), Order::smallest);
  EXPECT_EQ(default_order<3>(Insert::off_sink, true), Order::shortest);
  EXPECT_EQ(kDefaultReach<2>, 1.5);
  EXPECT_EQ(kDefaultReach<3>, 1.3);
}

// Unless one is named, the order is the default, and the reach, too.
TYPED_TEST(OrderTest, FirstPointIsThatOfTheFirstSimplexWhoseOffSinkIsNotRefused) {
  constexpr int kDim = TypeParam::value;
  using Options = std::pair<std::optional<Order>, std::optional<double>>;
  std::vector<Options> all = {{std::nullopt, std::nullopt}};
  for (const Order order : kOrders) {
    for (const double reach : {1.05, kDefaultReach<kDim>, 2.0}) all.emplace_back(order, reach);
  }
  std::set<Point<kDim>> different;
  for (const auto& [order, reach] : all) {
    for (const Schedule schedule : {Schedule::incremental, Schedule::block, Schedule::parallel}) {
      for (const double max_ratio : {1.0, 1.5}) {
        for (const std::uint64_t seed : {1, 2, 3}) {
          SCOPED_TRACE(testing::Message() << name(order.value_or(default_order<kDim>(Insert::off_sink, false)))
                                          << ", reach " << reach.value_or(0) << ", " << name(schedule)
                                          << ", ratio " << max_ratio << ", seed " << seed);
          Inside<kDim> inside(seed);
          const std::vector<Point<kDim>> before = inside.points();
          const auto expected_order = order.value_or(default_order<kDim>(Insert::off_sink, false));
          const auto listed =
              list<kDim>(inside, max_ratio, reach.value_or(kDefaultReach<kDim>), expected_order);
          std::vector<Point<kDim>> first;  // more than one, if they tie
          double key = HUGE_VAL;
          for (const Listed<kDim>& entry : listed) {
            if (entry.key > key) break;
            if (is_refused<kDim>(inside, entry, before)) continue;
            first.push_back(entry.point);
            key = entry.key;
          }
          ASSERT_FALSE(first.empty());

          RefineOptions options;
          options.order = order;
          options.reach = reach;
          options.schedule = schedule;
          options.max_ratio = max_ratio;
          // Counts vertices of the domain only.
          std::set<Vertex> used;
          for (const Simplex s : inside.domain.simplices()) {
            for (int i = 0; i <= kDim; ++i) used.insert(inside.triangulation.complex().corner(s, i));
          }
          options.max_vertices = used.size() + 1;
          const RefineResult result =
              Refiner<kDim>(inside.triangulation, inside.domain, inside.flow, options).run();
          EXPECT_EQ(result.order, expected_order);
          EXPECT_EQ(result.stop, Stop::budget);
          const std::vector<Point<kDim>> after = inside.points();
          ASSERT_EQ(after.size(), before.size() + 1);
          ASSERT_NE(std::find(first.begin(), first.end(), after.back()), first.end());
          different.insert(after.back());
        }
      }
    }
  }
  EXPECT_GT(different.size(), 20U);
}

// The rounds, without caches and early ends; and how many candidates are looked at, or not.
struct Counts {
  std::size_t considered = 0;
  std::size_t needless = 0;
};
template <int Dim>
std::vector<Point<Dim>> expected_round(Inside<Dim>& inside, Schedule schedule, double max_ratio, double reach,
                                       Order order, Counts& counts) {
  const Complex<Dim>& complex = inside.triangulation.complex();
  std::vector<Point<Dim>> vertices = inside.points();
  std::vector<Listed<Dim>> chosen;
  std::set<Vertex> taken;
  std::vector<Point<Dim>> result;
  for (const Listed<Dim>& entry : list<Dim>(inside, max_ratio, reach, order)) {
    // Its owner is gone.
    if (std::any_of(result.begin(), result.end(),
                    [&](const Point<Dim>& x) { return holds<Dim>(inside, entry.owner, x); })) {
      ++counts.needless;
      continue;
    }
    ++counts.considered;
    std::set<Vertex> closure;
    if (schedule == Schedule::block) {
      if (std::any_of(chosen.begin(), chosen.end(), [&](const Listed<Dim>& other) {
            return squared_distance(entry.point, other.point) < entry.radius2 + other.radius2;
          })) {
        continue;
      }
    } else {
      for (const Simplex s : inside.domain.simplices()) {
        if (!holds<Dim>(inside, s, entry.point)) continue;
        for (int i = 0; i <= Dim; ++i) closure.insert(complex.corner(s, i));
      }
      if (std::any_of(closure.begin(), closure.end(), [&](Vertex v) { return taken.contains(v); })) continue;
    }
    if (is_refused<Dim>(inside, entry, vertices)) continue;
    chosen.push_back(entry);
    taken.insert(closure.begin(), closure.end());
    vertices.push_back(entry.point);
    result.push_back(entry.point);
  }
  return result;
}

TYPED_TEST(OrderTest, FirstRoundIsWhatAllPairsLeaveOfTheList) {
  constexpr int kDim = TypeParam::value;
  std::size_t needless = 0;
  std::size_t shared = 0;
  for (const Schedule schedule : {Schedule::block, Schedule::parallel}) {
    for (const Order order : kOrders) {
      for (const std::uint64_t seed : {1, 2}) {
        SCOPED_TRACE(testing::Message() << name(schedule) << ", " << name(order) << ", seed " << seed);
        Inside<kDim> model(seed);
        Counts counts;
        const auto expected = expected_round<kDim>(model, schedule, 1.0, kDefaultReach<kDim>, order, counts);
        ASSERT_GT(expected.size(), 3U);
        needless += counts.needless;
        shared += model.shared;

        Inside<kDim> inside(seed);
        const std::size_t before = inside.points().size();
        RefineOptions options;
        options.schedule = schedule;
        options.order = order;
        options.max_ratio = 1;
        options.observer = [&](const Progress& progress) {
          if (progress.round != 1) return;
          EXPECT_EQ(progress.inserted, expected.size());
          EXPECT_EQ(progress.candidates, counts.considered);
          std::vector<Point<kDim>> points = inside.points();
          points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(before));
          EXPECT_EQ(points, expected);
        };
        Refiner<kDim>(inside.triangulation, inside.domain, inside.flow, options).run();
      }
    }
  }
  EXPECT_GT(needless, 100U);
  EXPECT_GT(shared, kDim == 2 ? 0U : 10U);
}

// Two orthogonal balls do not hold each other's centers, so points of a round leave each other alone.
TYPED_TEST(OrderTest, EmptyBallsOfABlockAreOrthogonalOrFurther) {
  constexpr int kDim = TypeParam::value;
  std::size_t pairs = 0;
  for (const double max_ratio : {1.0, 1.4}) {
    SCOPED_TRACE(max_ratio);
    Inside<kDim> inside(4);
    RefineOptions options;
    options.schedule = Schedule::block;
    options.max_ratio = max_ratio;
    std::size_t before = inside.points().size();
    options.observer = [&](const Progress&) {
      const std::vector<Point<kDim>> points = inside.points();
      std::vector<double> radius2(points.size(), HUGE_VAL);
      for (std::size_t i = before; i < points.size(); ++i) {
        for (std::size_t j = 0; j < before; ++j) {
          radius2[i] = std::min(radius2[i], squared_distance(points[i], points[j]));
        }
        for (std::size_t j = before; j < i; ++j) {
          ASSERT_GE(squared_distance(points[i], points[j]), (radius2[i] + radius2[j]) * (1 - 1e-9));
          ++pairs;
        }
      }
      before = points.size();
    };
    Refiner<kDim>(inside.triangulation, inside.domain, inside.flow, options).run();
  }
  EXPECT_GT(pairs, 1000U);
}

// Round, so that all can be mended.
template <int Dim>
std::vector<Point<Dim>> round_points(std::uint64_t seed) {
  if constexpr (Dim == 3) {
    return ellipsoid_surface(3, {1, 1.1, 0.9 + 0.01 * static_cast<double>(seed)}).points;
  } else {
    Random random(seed);
    std::vector<Point2> points;
    for (int i = 0; i < 80; ++i) {
      const double angle = std::numbers::pi / 40 * (i + uniform(random, 0, 0.4));
      points.push_back({std::cos(angle), std::sin(angle)});
    }
    return points;
  }
}

// Of circumcenters the spheres are those of their simplices, and where these are orthogonal but for rounding it
// is their corners that decide. Lattices with holes are full of them.
TYPED_TEST(OrderTest, SpheresOfABlockOfCentersAreExactlyOrthogonalOrFurther) {
  constexpr int kDim = TypeParam::value;
  std::size_t close = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<Point<kDim>> points = grid_points<kDim>(kDim == 2 ? 24 : 8, 0.1);
    std::erase_if(points, [&](const Point<kDim>&) { return random() % 10 < 4; });
    Inside<kDim> model(points);
    std::map<Point<kDim>, std::vector<Simplex>> owners;
    for (const Simplex s : model.domain.simplices()) {
      Point<kDim> center;
      if (circumcenter(model.triangulation.complex().corners(s), center)) owners[center].push_back(s);
    }
    Inside<kDim> inside(points);
    RefineOptions options;
    options.insert = Insert::circumcenter;
    options.schedule = Schedule::block;
    options.max_ratio = 1;
    options.observer = [&](const Progress& progress) {
      if (progress.round != 1) return;
      const std::vector<Point<kDim>> all = inside.points();
      for (std::size_t i = points.size(); i < all.size(); ++i) {
        const auto& of_i = owners.at(all[i]);
        const double radius2 = shape<kDim>(model.triangulation.complex().corners(of_i.front())).radius2;
        for (std::size_t j = points.size(); j < i; ++j) {
          const auto& of_j = owners.at(all[j]);
          const double sum2 =
              radius2 + shape<kDim>(model.triangulation.complex().corners(of_j.front())).radius2;
          if (std::abs(squared_distance(all[i], all[j]) - sum2) > 1e-12) continue;
          ++close;
          EXPECT_TRUE(std::any_of(of_i.begin(), of_i.end(), [&](Simplex s) {
            return std::any_of(of_j.begin(), of_j.end(),
                               [&](Simplex t) { return are_orthogonal_or_further(model.triangulation, s, t); });
          }));
        }
      }
    };
    Refiner<kDim>(inside.triangulation, inside.domain, inside.flow, options).run();
  }
  EXPECT_GT(close, 10U);
}

// With the least reach and the least bound the points of off-sinks are as near to vertices as they may be.
TYPED_TEST(OrderTest, LeastReachIsNotRefusedBecauseOfRounding) {
  constexpr int kDim = TypeParam::value;
  Inside<kDim> inside(round_points<kDim>(1));
  RefineOptions options;
  options.reach = 1;
  options.max_ratio = 1;
  options.max_vertices = 2000;
  const RefineResult result = Refiner<kDim>(inside.triangulation, inside.domain, inside.flow, options).run();
  EXPECT_GT(result.inserted, 50U);
  EXPECT_LT(result.rejected.separation, result.inserted / 10);
}

// Candidates that have lost their simplices are not asked for, and do not ask for a vertex of the budget.
TYPED_TEST(OrderTest, BudgetOfJustTheVerticesNeededDoesNotStopARun) {
  constexpr int kDim = TypeParam::value;
  std::size_t ended = 0;
  for (const Schedule schedule : {Schedule::incremental, Schedule::block, Schedule::parallel}) {
    for (const Order order : kOrders) {
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(testing::Message() << name(schedule) << ", " << name(order) << ", seed " << seed);
        RefineOptions options;
        options.schedule = schedule;
        options.order = order;
        options.max_ratio = 1.6;
        Inside<kDim> free(round_points<kDim>(seed));
        std::size_t vertices = 0;
        options.observer = [&](const Progress& progress) { vertices = progress.vertices; };
        const RefineResult expected = Refiner<kDim>(free.triangulation, free.domain, free.flow, options).run();
        if (expected.remaining.total() != 0) continue;
        ++ended;
        Inside<kDim> bound(round_points<kDim>(seed));
        options.max_vertices = vertices;
        const RefineResult result = Refiner<kDim>(bound.triangulation, bound.domain, bound.flow, options).run();
        EXPECT_EQ(result.stop, Stop::no_candidate);
        EXPECT_EQ(result.candidates, expected.candidates);
        EXPECT_EQ(bound.points(), free.points());
      }
    }
  }
  EXPECT_GT(ended, 20U);
}

}  // namespace
}  // namespace sinkmesh
