// SPDX-License-Identifier: MIT
//
// The tests of one Steiner point, with points placed by hand where each of them decides.
#include "refine/steiner_inserter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/vector.h"
#include "predicates/error.h"
#include "refine/quality.h"
#include "test/support/clouds.h"
#include "test/support/conformed.h"
#include "test/support/rational_geometry.h"

namespace sinkmesh {
namespace {

using namespace test;

/// A domain in the plane, with an inserter; points are given in the units of the input.
class Bench {
 public:
  /// @param loops     closed polygons; together they bound the domain.
  /// @param interior  points inside.
  explicit Bench(const std::vector<std::vector<Point2>>& loops, const std::vector<Point2>& interior = {})
      : triangulation_(all_points(loops, interior)), domain_(triangulation_), flow_(triangulation_) {
    std::vector<Domain<2>::Facet> facets;
    std::uint32_t first = 0;
    for (const auto& loop : loops) {
      const auto n = static_cast<std::uint32_t>(loop.size());
      for (std::uint32_t i = 0; i < n; ++i) facets.push_back({Vertex(first + i), Vertex(first + (i + 1) % n)});
      first += n;
    }
    EXPECT_TRUE(domain_.label_facets(facets).empty());
    inserter_.emplace(triangulation_, domain_, flow_, 1.0);
    inserter_->measure_all();
  }

  const Triangulation2& triangulation() const { return triangulation_; }
  SteinerInserter<2>& inserter() { return *inserter_; }
  Flow<2>& flow() { return flow_; }
  const Domain<2>& domain() const { return domain_; }
  Point2 gated(const Point2& x) const { return triangulation_.gate().in(x); }

  /// x as the candidate of a simplex, which need not have its center there.
  Candidate<2> candidate(Simplex s, const Point2& x) const {
    Candidate<2> c;
    c.owner = c.simplex = s;
    c.owner_birth = c.birth = inserter_->birth(s);
    c.corner = triangulation_.complex().corner(s, 0);
    c.point = gated(x);
    return c;
  }

  /// The simplices of the domain that hold x inside their circles, exactly.
  std::vector<Simplex> in_conflict_with(const Point2& x) const {
    std::vector<Simplex> result;
    for (const Simplex s : domain_.simplices()) {
      if (circumsphere<2>(triangulation_.complex(), s).power(rational<2>(gated(x))) < 0) result.push_back(s);
    }
    return result;
  }

 private:
  static std::vector<Point2> all_points(const std::vector<std::vector<Point2>>& loops,
                                        const std::vector<Point2>& interior) {
    std::vector<Point2> points;
    for (const auto& loop : loops) points.insert(points.end(), loop.begin(), loop.end());
    points.insert(points.end(), interior.begin(), interior.end());
    return points;
  }

  Triangulation2 triangulation_;
  Domain<2> domain_;
  Flow<2> flow_;
  std::optional<SteinerInserter<2>> inserter_;
};

/// One of the eight symmetries of the square, around the origin.
Point2 turned(const Point2& p, int symmetry) {
  Point2 q = (symmetry & 1) != 0 ? Point2{p[1], p[0]} : p;
  if ((symmetry & 2) != 0) q[0] = -q[0];
  if ((symmetry & 4) != 0) q[1] = -q[1];
  return q;
}
std::vector<Point2> turned(std::vector<Point2> points, int symmetry) {
  for (Point2& p : points) p = turned(p, symmetry);
  return points;
}

std::size_t count_of(const Rejections& rejections, Verdict verdict) {
  switch (verdict) {
    case Verdict::inserted:
      return 0;
    case Verdict::boundary:
      return rejections.boundary;
    case Verdict::crossing:
      return rejections.crossing;
    case Verdict::separation:
      return rejections.separation;
    case Verdict::dependent:
      return rejections.dependent;
  }
  return 0;
}

/// The verdict on x must not depend on the simplex from which the search starts; it is counted and kept. A
/// refusal must leave the complex as it was, and what else is known of the simplex.
void expect_verdict(Bench& bench, const Point2& x, Verdict expected) {
  const std::vector<Simplex> starts = bench.in_conflict_with(x);
  ASSERT_FALSE(starts.empty());
  std::vector<Vertex> closure;
  const std::uint64_t hash = bench.triangulation().hash();
  std::size_t refused = 0;
  for (const Simplex s : starts) {
    const bool is_low = bench.inserter().is_low_quality(s);
    EXPECT_EQ(is_low, !(shape<2>(bench.triangulation().complex().corners(s)).ratio2() <= 1));
    EXPECT_EQ(bench.inserter().test(bench.candidate(s, x), closure), expected);
    refused += expected == Verdict::inserted ? 0 : 1;
    EXPECT_EQ(count_of(bench.inserter().rejections(), expected), refused);
    EXPECT_EQ(bench.inserter().is_low_quality(s), is_low);
    EXPECT_TRUE(bench.triangulation().validate().ok()) << bench.triangulation().validate();
    EXPECT_EQ(bench.triangulation().hash(), hash);
    EXPECT_EQ(bench.inserter().rejection(s), expected);
  }
  EXPECT_EQ(bench.inserter().insert(bench.candidate(starts.back(), x)), expected);
  EXPECT_TRUE(bench.triangulation().validate().ok()) << bench.triangulation().validate();
}

const std::vector<Point2> kSquare = {{-4, -4}, {-2, -4}, {0, -4}, {2, -4},  {4, -4}, {4, -2},
                                     {4, 0},   {4, 2},   {4, 4},  {3.5, 4}, {2, 4},  {0, 4},
                                     {-2, 4},  {-4, 4},  {-4, 2}, {-4, 0},  {-4, -2}};

// The diametral sphere is closed [PS, 9]: a point on it is refused, whatever its rank among the corners.
TEST(SteinerInserter, RefusesAPointOnTheDiametralSphereOfABoundaryFacet) {
  for (int symmetry = 0; symmetry < 8; ++symmetry) {
    SCOPED_TRACE(symmetry);
    Bench on({turned(kSquare, symmetry)});
    expect_verdict(on, turned({1, -3}, symmetry), Verdict::boundary);
    Bench inside({turned(kSquare, symmetry)});
    expect_verdict(inside, turned({1, -3 - 0x1p-40}, symmetry), Verdict::boundary);
    Bench outside({turned(kSquare, symmetry)});
    expect_verdict(outside, turned({1, -3 + 0x1p-40}, symmetry), Verdict::inserted);
  }
}

// A vertex of another part, close above the edge (0,0)-(2,0), makes an outer triangle whose circle reaches far
// into the lower part: center (1, -91/60), radius 109/60. Two vertices at the bottom make delta small.
const std::vector<Point2> kLower = {{0, 0},    {2, 0},  {3, -1},    {3, -2.5}, {2, -4},
                                    {1.9, -4}, {0, -4}, {-1, -2.5}, {-1, -1}};
const std::vector<Point2> kUpper = {{1, 0.3}, {2, 3}, {0, 3}};

TEST(SteinerInserter, RefusesAPointWhosePrestarCrossesTheBoundary) {
  for (int symmetry = 0; symmetry < 8; ++symmetry) {
    SCOPED_TRACE(symmetry);
    const auto lower = turned(kLower, symmetry);
    const auto upper = turned(kUpper, symmetry);
    Bench bench({lower, upper});
    expect_verdict(bench, turned({1, -2}, symmetry), Verdict::crossing);
    Bench alone({lower});
    expect_verdict(alone, turned({1, -2}, symmetry), Verdict::inserted);
  }
}

// Both reasons apply to a point in the diametral sphere of another edge; `boundary` is reported, whichever is
// met first.
TEST(SteinerInserter, ReportsTheBoundaryBeforeACrossing) {
  for (int symmetry = 0; symmetry < 8; ++symmetry) {
    SCOPED_TRACE(symmetry);
    for (const double side : {0.0, 1.0}) {
      Bench bench({turned(kLower, symmetry), turned(kUpper, symmetry)});
      expect_verdict(bench, turned({side == 0 ? 2.3 : -0.3, -1.5}, symmetry), Verdict::boundary);
    }
  }
}

// Two vertices 1/2 apart fix delta; around one of them a new point is tried from both sides of that distance.
TEST(SteinerInserter, KeepsTheShortestDistanceOfTheInput) {
  const std::vector<Point2> interior = {{0, 0}, {0.5, 0}};
  Random random(1);
  int refused = 0;
  int inserted = 0;
  int close = 0;
  for (int trial = 0; trial < 400; ++trial) {
    Bench bench({kSquare}, interior);
    const Point2 a = bench.gated(interior[0]);
    const Point2 b = bench.gated(interior[1]);
    const Rational delta2 = squared_distance(rational<2>(a), rational<2>(b));
    const double angle = uniform(random, 2, 4);
    // What is kept is 2^-51 shorter: every other trial is as near to that as doubles allow.
    const double offset = trial % 2 == 0 ? std::ldexp(uniform(random, -1, 1), -uniform_int(random, 4, 50))
                                         : -0x1p-51 * uniform(random, 0.5, 1.5);
    const double radius = 0.5 * (1 + offset);
    const Point2 x = bench.gated({radius * std::cos(angle), radius * std::sin(angle)});
    const Rational distance2 = squared_distance(rational<2>(x), rational<2>(a));
    std::vector<Simplex> starts = bench.in_conflict_with(bench.triangulation().gate().out(x));
    ASSERT_FALSE(starts.empty());
    const Verdict verdict =
        bench.inserter().insert(bench.candidate(starts[0], bench.triangulation().gate().out(x)));
    // What is kept is rounded down a little, never up; and it is really kept.
    const Rational kept2 = bench.inserter().separation2();
    ASSERT_LE(kept2, delta2);
    ASSERT_GE(kept2, delta2 * (1 - 0x1p-49));
    if (verdict == Verdict::inserted) {
      ASSERT_GE(distance2, kept2);
      ++inserted;
    } else {
      ASSERT_EQ(verdict, Verdict::separation);
      ASSERT_LT(distance2, delta2 * (1 + 0x1p-49));
      ++refused;
    }
    close += abs(Rational(distance2 / delta2 - 1)) < 0x1p-40;
    ASSERT_TRUE(bench.triangulation().validate().ok());
  }
  EXPECT_GE(refused, 100);
  EXPECT_GE(inserted, 100);
  EXPECT_GE(close, 50);
}

// Points of a grid are coarse, and a new point next to one of its many circles is fine: the certificates of
// zero that the grid allows must have ended before the search.
TEST(SteinerInserter, LooksAtFinePointsNextToTheCirclesOfAGrid) {
  std::vector<Point2> interior;
  for (int i = -3; i <= 3; ++i) {
    for (int j = -3; j <= 3; ++j) interior.push_back({0.5 * i, 0.5 * j});
  }
  std::vector<Point2> square = kSquare;
  square.insert(std::find(square.begin(), square.end(), Point2{4, 4}) + 1, {4 - 0x1p-4, 4});  // a small delta
  Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    Bench bench({square}, interior);
    // Near the circle of a cell, next to the middle of a side, from where the circle is seen from both cells.
    const double angle = std::numbers::pi / 2 * uniform_int(random, 0, 3) + uniform(random, -0.3, 0.3);
    const double radius = std::sqrt(0.125) + std::ldexp(uniform(random, -1, 1), -uniform_int(random, 40, 60));
    Point2 x{0.5 * uniform_int(random, -2, 1) + 0.25, 0.5 * uniform_int(random, -2, 1) + 0.25};
    x[0] += radius * std::cos(angle);
    x[1] += radius * std::sin(angle);
    const std::vector<Simplex> starts = bench.in_conflict_with(x);
    ASSERT_FALSE(starts.empty());
    std::vector<Vertex> expected;
    for (const Simplex s : starts) {
      for (int k = 0; k <= 2; ++k) expected.push_back(bench.triangulation().complex().corner(s, k));
    }
    std::sort(expected.begin(), expected.end());
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    std::vector<Vertex> closure;
    ASSERT_EQ(bench.inserter().test(bench.candidate(starts[0], x), closure), Verdict::inserted);
    ASSERT_EQ(closure, expected);
    ASSERT_EQ(bench.inserter().insert(bench.candidate(starts[0], x)), Verdict::inserted);
    ASSERT_TRUE(bench.triangulation().validate().ok()) << bench.triangulation().validate();
  }
}

std::size_t total(const Rejections& rejections) {
  return rejections.boundary + rejections.crossing + rejections.separation + rejections.dependent;
}

// What is known of the center of a simplex has nothing to do with another point.
TEST(SteinerInserter, NotesNothingWhenAnotherPointIsRefused) {
  for (int symmetry = 0; symmetry < 8; ++symmetry) {
    SCOPED_TRACE(symmetry);
    Bench bench({turned(kLower, symmetry), turned(kUpper, symmetry)});
    const std::uint64_t hash = bench.triangulation().hash();
    const std::vector<std::pair<Point2, Verdict>> refused = {{{1, -2}, Verdict::crossing},
                                                             {{2.3, -1.5}, Verdict::boundary}};
    for (const auto& [x, verdict] : refused) {
      for (const Simplex s : bench.in_conflict_with(turned(x, symmetry))) {
        EXPECT_EQ(bench.inserter().insert_other(bench.candidate(s, turned(x, symmetry))), verdict);
        EXPECT_EQ(bench.inserter().rejection(s), Verdict::inserted);
        EXPECT_EQ(total(bench.inserter().rejections()), 0U);
        EXPECT_TRUE(bench.triangulation().validate().ok()) << bench.triangulation().validate();
        EXPECT_EQ(bench.triangulation().hash(), hash);
      }
    }
    // Nor is a refusal forgotten.
    const Point2 center = turned({1, -2}, symmetry);
    const Simplex s = bench.in_conflict_with(center).front();
    EXPECT_EQ(bench.inserter().insert(bench.candidate(s, center)), Verdict::crossing);
    Candidate<2> other = bench.candidate(s, center);
    other.least2 = 100;
    EXPECT_EQ(bench.inserter().insert_other(other), Verdict::separation);
    EXPECT_EQ(bench.inserter().rejection(s), Verdict::crossing);
    EXPECT_EQ(total(bench.inserter().rejections()), 1U);

    Bench square({turned(kSquare, symmetry)});
    const Simplex at = square.in_conflict_with({0, 0}).front();
    const std::size_t vertices = square.inserter().num_vertices();
    EXPECT_EQ(square.inserter().insert_other(square.candidate(at, {0, 0})), Verdict::inserted);
    EXPECT_EQ(square.inserter().num_inserted(), 1U);
    EXPECT_EQ(square.inserter().num_vertices(), vertices + 1);
    EXPECT_TRUE(square.triangulation().validate().ok()) << square.triangulation().validate();
  }
}

// The nearest vertices of the middle of the square are at distance 4, gated 1.
TEST(SteinerInserter, KeepsTheDistanceThatACandidateAsksFor) {
  constexpr double kMost = 1 - 0x1p-50;  // distances are taken for a little less than they are
  for (const double least2 : {0.0, 0.5, kMost, std::nextafter(kMost, 2), 1.0, 2.0}) {
    SCOPED_TRACE(least2);
    Bench bench({kSquare});
    const Simplex s = bench.in_conflict_with({0, 0}).front();
    Candidate<2> candidate = bench.candidate(s, {0, 0});
    candidate.least2 = least2;
    const Verdict expected = least2 > kMost ? Verdict::separation : Verdict::inserted;
    EXPECT_EQ(bench.inserter().insert(candidate), expected);
    if (expected != Verdict::inserted) {
      EXPECT_EQ(bench.inserter().rejection(s), expected);
    }
  }
  // It does not replace that of all.
  Bench bench({kSquare});
  const Point2 near{-3.9, 3.9};
  Candidate<2> candidate = bench.candidate(bench.in_conflict_with(near).front(), near);
  candidate.least2 = 1e-6;
  EXPECT_EQ(bench.inserter().insert_other(candidate), Verdict::separation);
}

TEST(SteinerInserter, DescribesAnOffSinkByTheSimplexItIsIn) {
  Random random(7);
  std::vector<Point2> interior;
  for (int i = 0; i < 60; ++i) interior.push_back({uniform(random, -2, 2), uniform(random, -2, 2)});
  Bench bench({kSquare}, interior);
  OffSinkWalk<2> walk;
  std::size_t elsewhere = 0;
  for (const Simplex s : bench.inserter().low_quality()) {
    SCOPED_TRACE(testing::Message() << s);
    const double length2 = shape<2>(bench.triangulation().complex().corners(s)).shortest2;
    for (const double reach : {1.0, 1.5, 3.0}) {
      const auto found = walk(bench.flow(), s, reach * reach * length2);
      Candidate<2> candidate;
      ASSERT_TRUE(bench.inserter().make_off_sink(s, reach, candidate));
      ASSERT_TRUE(found);
      EXPECT_EQ(candidate.owner, s);
      EXPECT_EQ(candidate.owner_birth, bench.inserter().birth(s));
      EXPECT_EQ(candidate.simplex, found->simplex);
      EXPECT_EQ(candidate.birth, bench.inserter().birth(found->simplex));
      for (std::size_t i = 0; i <= 2; ++i) {
        EXPECT_EQ(candidate.corners[i], *bench.triangulation().complex().corners(found->simplex)[i]);
      }
      EXPECT_EQ(bench.triangulation().complex().point(candidate.corner), candidate.corners[0]);
      EXPECT_EQ(candidate.point, found->point);
      EXPECT_FALSE(candidate.is_center);
      EXPECT_EQ(candidate.radius2, found->distance2);
      EXPECT_EQ(candidate.tie, bench.inserter().tie(s));
      EXPECT_LE(candidate.least2, length2);
      EXPECT_NEAR(std::sqrt(candidate.least2), std::sqrt(length2), 0x1p-49);
      elsewhere += found->simplex != s ? 1 : 0;
    }
  }
  EXPECT_GT(elsewhere, 10U);
  EXPECT_EQ(total(bench.inserter().rejections()), 0U);
}

TEST(SteinerInserter, RejectsASimplexWhoseChainLeadsOutside) {
  Bench bench({{{0, 0}, {4, 0}, {2, 0.5}}});
  ASSERT_EQ(bench.inserter().low_quality().size(), 1U);
  const Simplex s = bench.inserter().low_quality().front();
  Candidate<2> candidate;
  EXPECT_TRUE(bench.inserter().make_off_sink(s, 1, candidate));  // left before
  EXPECT_FALSE(bench.inserter().is_rejected(s));
  EXPECT_FALSE(bench.inserter().make_off_sink(s, 10, candidate));
  EXPECT_EQ(bench.inserter().rejection(s), Verdict::crossing);
  EXPECT_EQ(bench.inserter().rejections().crossing, 1U);
}

// Not where its point lies: the center of that simplex is another matter.
TEST(SteinerInserter, NotesARefusalAtTheOwnerWhileItLives) {
  Bench bench({kSquare});
  const Point2 x{1, -3};
  const std::vector<Simplex> holding = bench.in_conflict_with(x);
  const auto all = bench.domain().simplices();
  const auto other = std::find_if(all.begin(), all.end(), [&](Simplex s) {
    return std::find(holding.begin(), holding.end(), s) == holding.end();
  });
  ASSERT_NE(other, all.end());
  Candidate<2> candidate = bench.candidate(holding.front(), x);
  candidate.owner = *other;
  candidate.owner_birth = bench.inserter().birth(*other) + 1;  // another one in its place
  EXPECT_EQ(bench.inserter().insert(candidate), Verdict::boundary);
  EXPECT_EQ(bench.inserter().rejection(*other), Verdict::inserted);
  candidate.owner_birth = bench.inserter().birth(*other);
  EXPECT_EQ(bench.inserter().insert(candidate), Verdict::boundary);
  EXPECT_EQ(bench.inserter().rejection(*other), Verdict::boundary);
  EXPECT_EQ(bench.inserter().rejection(holding.front()), Verdict::inserted);
}

// Halves, so that some points lie on the circles.
TEST(SteinerInserter, FindsTheWallsThatAPointEncroaches) {
  Random random(3);
  std::size_t encroached = 0;
  std::size_t on_circle = 0;
  std::size_t left_alone = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Bench bench({kSquare});
    const Point2 x{0.5 * uniform_int(random, -7, 7), 0.5 * uniform_int(random, -7, 7)};
    const auto at = rational<2>(bench.gated(x));
    const std::vector<Simplex> starts = bench.in_conflict_with(x);
    ASSERT_FALSE(starts.empty());
    std::vector<HalfFacet> expected;
    for (const Simplex s : starts) {
      for (int i = 0; i <= 2; ++i) {
        const HalfFacet h = Complex<2>::half_facet(s, i);
        if (!bench.domain().is_wall(h)) continue;
        const FacetCorners<2> corners = bench.triangulation().complex().facet_corners(h);
        const auto p = rational<2>(*corners[0]);
        const auto q = rational<2>(*corners[1]);
        const Rational side = (p[0] - at[0]) * (q[0] - at[0]) + (p[1] - at[1]) * (q[1] - at[1]);
        if (side <= 0) expected.push_back(h);
        encroached += side < 0;
        on_circle += side == 0;
        left_alone += side > 0;
      }
    }
    std::sort(expected.begin(), expected.end());
    for (const Simplex s : starts) {
      std::vector<HalfFacet> found = bench.inserter().encroached_walls(bench.candidate(s, x));
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected) << x[0] << ' ' << x[1];
    }
    EXPECT_TRUE(bench.triangulation().validate().ok()) << bench.triangulation().validate();
  }
  EXPECT_GE(encroached, 20U);
  EXPECT_GE(on_circle, 10U);
  EXPECT_GE(left_alone, 20U);
}

TEST(SteinerInserter, SaysHowNearVerticesAtTheResolutionOfDoublesAre) {
  const std::vector<Point2> square = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  EXPECT_NO_THROW(Bench({square}, {{0, 0}, {0x1p-38, 0}}));
  try {
    const Bench bench({square}, {{0, 0}, {0x1p-42, 0}});
    FAIL() << "should have been refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("two vertices are 1.1e-13 times the largest coordinate apart"),
              std::string::npos)
        << error.what();
  }
}

TEST(SteinerInserter, GoesTowardsACenterThatIsTooFarAway) {
  for (int symmetry = 0; symmetry < 8; ++symmetry) {
    SCOPED_TRACE(symmetry);
    for (const double height : {0x1p-2, 0x1p-30}) {
      Bench bench({turned({{-1, 0}, {1, 0}, {0, height}}, symmetry)});
      const std::vector<Simplex> all = bench.domain().simplices();
      ASSERT_EQ(all.size(), 1U);
      const Corners<2> corners = bench.triangulation().complex().corners(all[0]);
      const auto center = circumsphere<2>(corners).center;
      const Point2 found = bench.inserter().center_or_direction(all[0]);
      if (height > 0x1p-20) {
        EXPECT_EQ(found, (Point2{center[0].get_d(), center[1].get_d()}));
        continue;
      }
      // On the ray from a corner to the center, beyond the hull.
      const Point2& from =
          bench.triangulation().complex().point(bench.triangulation().complex().corner(all[0], 0));
      EXPECT_GE(std::max(std::abs(found[0]), std::abs(found[1])), 2);
      EXPECT_LE(std::max(std::abs(found[0]), std::abs(found[1])), 6);
      const Point2 way = found - from;
      const Point2 whole{center[0].get_d() - from[0], center[1].get_d() - from[1]};
      EXPECT_NEAR(dot(way, whole) / std::sqrt(dot(way, way) * dot(whole, whole)), 1, 1e-12);
    }
  }
}

/// Points in a square whose boundary has features.
Surface<2> square_with(const std::vector<Point2>& interior) {
  Surface<2> surface;
  surface.points = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  surface.facets = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  surface.points.insert(surface.points.end(), interior.begin(), interior.end());
  return surface;
}

// Below a ratio of 2 the floor counts for more: a point on a segment may be nearer than an edge is long.
TEST(SteinerInserter, CountsNoEdgeAsShorterThanTheFloor) {
  Random random(4);
  std::vector<Point2> interior;
  for (int i = 0; i < 80; ++i) interior.push_back({uniform(random, -0.9, 0.9), uniform(random, -0.9, 0.9)});
  for (const double ratio : {1.0, 1.5, 2.0, 4.0, 10.0}) {
    SCOPED_TRACE(ratio);
    constexpr double kFloor = 0.1;
    Conforming<2> mesh(square_with(interior));
    mesh.label();
    SteinerInserter<2> inserter(mesh.triangulation, mesh.domain, mesh.flow, ratio,
                                {&mesh.boundary.features(), 0.5, kFloor});
    inserter.measure_all();
    const double least = ratio < 2 ? kFloor * 2 / ratio : kFloor;
    std::size_t at_floor = 0;
    for (const Simplex s : mesh.domain.simplices()) {
      const Shape of_s = shape<2>(mesh.complex().corners(s));
      EXPECT_EQ(inserter.is_at_floor(s), std::sqrt(of_s.shortest2) <= least);
      at_floor += inserter.is_at_floor(s) ? 1 : 0;
      // Of points inside there is no other excuse, and none that could be told.
      bool is_inside = true;
      for (int i = 0; i <= 2; ++i) is_inside = is_inside && mesh.complex().corner(s, i).index() >= 4;
      if (!is_inside) continue;
      const double length = std::max(std::sqrt(of_s.shortest2), least);
      EXPECT_NEAR(std::sqrt(inserter.relaxed_length2(s)), length, 1e-14);
      EXPECT_EQ(inserter.is_low_quality(s), of_s.ratio2() > ratio * ratio);
      if (inserter.is_low_quality(s)) {
        EXPECT_EQ(inserter.is_excused(s), std::sqrt(of_s.radius2) <= ratio * length);
      }
      EXPECT_FALSE(inserter.rung(s));
    }
    EXPECT_GE(at_floor, 5U);
    EXPECT_LT(at_floor, mesh.domain.simplices().size());
  }
}

}  // namespace
}  // namespace sinkmesh
