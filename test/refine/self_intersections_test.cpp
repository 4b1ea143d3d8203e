// SPDX-License-Identifier: MIT
#include "refine/self_intersections.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>

#include "test/support/data_files.h"
#include "test/support/dimensions.h"
#include "test/support/intersection_oracle.h"
#include "test/support/surfaces.h"
#include "tools/io/read.h"

namespace sinkmesh::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

// Facets of random points; ids within a facet are distinct, points need not be.
template <int Dim, class MakePoint>
Surface<Dim> soup(std::size_t points, std::size_t facets, std::mt19937_64& random, MakePoint make_point) {
  Surface<Dim> surface;
  for (std::size_t i = 0; i < points; ++i) surface.points.push_back(make_point());
  while (surface.facets.size() < facets) {
    typename Surface<Dim>::Facet facet;
    for (std::uint32_t& v : facet) v = static_cast<std::uint32_t>(random() % points);
    auto sorted = facet;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()) surface.facets.push_back(facet);
  }
  return surface;
}

// Soups with all kinds of degenerate contact: points of a small grid, as it is, scaled and sheared so that
// contacts are rounded away or not, moved by a bit, or flattened into a plane.
enum class Kind { grid, flat, rounded_flat, sheared, moved, anywhere };
constexpr Kind kKinds[] = {Kind::grid,    Kind::flat,  Kind::rounded_flat,
                           Kind::sheared, Kind::moved, Kind::anywhere};

template <int Dim>
Surface<Dim> random_soup(Kind kind, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const std::uint64_t side = (Dim == 2 ? 4 : 2) + seed % 3;
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  return soup<Dim>(16, 24, random, [&] {
    Point<Dim> p;
    for (double& x : p) x = static_cast<double>(random() % (side + 1));
    const double last = p[Dim - 1];
    switch (kind) {
      case Kind::grid:
        break;
      case Kind::flat:
        p[Dim - 1] = Dim == 3 ? 2 * p[0] - p[1] : p[0];
        break;
      case Kind::rounded_flat:
        for (double& x : p) x = 0.1 * x + 0.3;
        p[Dim - 1] = Dim == 3 ? 0.7 * p[0] + 0.1 * p[1] : 0.7 * p[0];
        break;
      case Kind::sheared:
        for (double& x : p) x = 0.1 * x + 0.3 + 0.2 * last;
        break;
      case Kind::moved:
        for (double& x : p) {
          const auto choice = random() % 8;
          if (choice < 2) x = std::nextafter(x + 1, choice == 0 ? 0.0 : 9.0);
        }
        break;
      case Kind::anywhere:
        for (double& x : p) x = unit();
        break;
    }
    return p;
  });
}

// A pair as the coordinates of its facets, whatever the ids.
template <int Dim>
auto in_coordinates(const Surface<Dim>& surface) {
  using FacetPoints = std::vector<Point<Dim>>;
  std::vector<std::pair<FacetPoints, FacetPoints>> result;
  for (const auto& [f, g] : self_intersections(surface)) {
    std::array<FacetPoints, 2> both;
    for (std::size_t k = 0; k < Dim; ++k) {
      both[0].push_back(surface.points[surface.facets[f][k]]);
      both[1].push_back(surface.points[surface.facets[g][k]]);
    }
    for (FacetPoints& points : both) std::sort(points.begin(), points.end());
    std::sort(both.begin(), both.end());
    result.emplace_back(both[0], both[1]);
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <class T>
class SelfIntersections : public testing::Test {};
TYPED_TEST_SUITE(SelfIntersections, PlaneAndSpace, DimensionName);

TYPED_TEST(SelfIntersections, OfSoupsAreThoseOfTheDefinition) {
  constexpr int kDim = TypeParam::value;
  for (const Kind kind : kKinds) {
    std::size_t pairs = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      SCOPED_TRACE(testing::Message() << "kind " << static_cast<int>(kind) << ", seed " << seed);
      const Surface<kDim> surface = random_soup<kDim>(kind, seed);
      const auto expected = self_intersections_by_definition(surface);
      ASSERT_EQ(self_intersections(surface), expected);
      pairs += expected.size();
    }
    EXPECT_GT(pairs, 50U) << "a test of next to nothing";
  }
}

// Facets of sizes from 1 to 2^-20, some of them where the large ones are.
TYPED_TEST(SelfIntersections, OfFacetsOfAllSizesAreThoseOfTheDefinition) {
  constexpr int kDim = TypeParam::value;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    std::mt19937_64 random(seed);
    Surface<kDim> surface;
    for (int i = 0; i < 60; ++i) {
      const double size = std::ldexp(1.0, -static_cast<int>(random() % 3 * 10));
      Point<kDim> center;
      for (double& x : center) x = static_cast<double>(random() % 5) / 4;
      typename Surface<kDim>::Facet facet;
      for (std::uint32_t& v : facet) {
        v = static_cast<std::uint32_t>(surface.points.size());
        Point<kDim>& p = surface.points.emplace_back(center);
        for (double& x : p) x += size * (static_cast<double>(random() % 5) - 2);
      }
      surface.facets.push_back(facet);
    }
    EXPECT_EQ(self_intersections(surface), self_intersections_by_definition(surface)) << "seed " << seed;
  }
}

TYPED_TEST(SelfIntersections, DoNotDependOnTheOrderOfPointsFacetsAndCorners) {
  constexpr int kDim = TypeParam::value;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Surface<kDim> surface = random_soup<kDim>(Kind::grid, seed);
    test::Random random(seed);
    const Surface<kDim> other = test::in_another_order(surface, random);
    EXPECT_EQ(in_coordinates(surface), in_coordinates(other)) << "seed " << seed;
  }
}

TYPED_TEST(SelfIntersections, WithALimitAreTheFirstOnes) {
  constexpr int kDim = TypeParam::value;
  const Surface<kDim> surface = random_soup<kDim>(Kind::grid, 2);
  const std::vector<FacetPair> all = self_intersections(surface);
  ASSERT_GT(all.size(), 5U);
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
  for (std::size_t limit = 0; limit <= all.size() + 1; ++limit) {
    std::vector<FacetPair> first = all;
    first.resize(std::min(limit, all.size()));
    EXPECT_EQ(self_intersections(surface, limit), first);
  }
}

TYPED_TEST(SelfIntersections, DoNotDependOnTheUnit) {
  constexpr int kDim = TypeParam::value;
  const Surface<kDim> surface = random_soup<kDim>(Kind::sheared, 1);
  const std::vector<FacetPair> expected = self_intersections(surface);
  ASSERT_FALSE(expected.empty());
  for (const int exponent : {-1020, -900, -300, 300, 1020}) {
    Surface<kDim> scaled = surface;
    for (auto& p : scaled.points) {
      for (double& x : p) x = std::ldexp(x, exponent);
    }
    EXPECT_EQ(self_intersections(scaled), expected) << exponent;
  }
}

TYPED_TEST(SelfIntersections, AreLookedForAmongSoundFacetsOnly) {
  constexpr int kDim = TypeParam::value;
  Surface<kDim> surface = random_soup<kDim>(Kind::grid, 3);
  const std::vector<FacetPair> expected = self_intersections(surface);
  ASSERT_FALSE(expected.empty());
  const auto n = static_cast<std::uint32_t>(surface.points.size());
  for (const double x : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    Point<kDim> p{};
    p.back() = x;
    surface.points.push_back(p);
  }
  surface.points.push_back(surface.points.front());
  surface.points.push_back(surface.points.front());
  typename Surface<kDim>::Facet facet{};  // one vertex repeated
  surface.facets.push_back(facet);
  for (const std::uint32_t v : {n, n + 1, n + 4, ~std::uint32_t{0}}) {  // not finite; out of range
    facet = surface.facets.front();
    facet.back() = v;
    surface.facets.push_back(facet);
  }
  facet.fill(n + 2);  // of length 0, or collinear
  facet.back() = n + 3;
  facet.front() = 0;
  surface.facets.push_back(facet);
  if (kDim == 2) surface.facets.back() = {n + 2, n + 3};
  EXPECT_EQ(self_intersections(surface), expected);
  EXPECT_THAT(self_intersections(Surface<kDim>{}), IsEmpty());
}

std::vector<FacetPair> of_segments(std::vector<Point2> points, std::vector<Surface2::Facet> facets) {
  return self_intersections(Surface2{std::move(points), std::move(facets)});
}

TEST(SelfIntersectionsInThePlane, AreCrossingsTouchesAndOverlaps) {
  const auto is_one = ElementsAre(Pair(0, 1));
  EXPECT_THAT(of_segments({{0, 0}, {2, 2}, {0, 2}, {2, 0}}, {{0, 1}, {2, 3}}), is_one);
  EXPECT_THAT(of_segments({{0, 0}, {2, 0}, {1, 0}, {1, 1}}, {{0, 1}, {2, 3}}), is_one);
  EXPECT_THAT(of_segments({{0, 0}, {2, 0}, {1, 0}, {3, 0}}, {{0, 1}, {2, 3}}), is_one);
  EXPECT_THAT(of_segments({{0, 0}, {2, 0}, {1, 0}}, {{0, 1}, {0, 2}}), is_one);
  EXPECT_THAT(of_segments({{0, 0}, {2, 0}, {-1, 0}}, {{0, 1}, {2, 0}}), IsEmpty());
  EXPECT_THAT(of_segments({{0, 0}, {2, 0}, {3, 0}, {4, 0}}, {{0, 1}, {2, 3}}), IsEmpty());
  EXPECT_THAT(of_segments({{0, 0}, {2, 0}, {2, 1}}, {{0, 1}, {1, 2}}), IsEmpty());
  EXPECT_THAT(of_segments({{0, 0}, {2, 0}}, {{0, 1}, {1, 0}}), IsEmpty()) << "duplicates are another defect";
}

std::vector<FacetPair> of_triangles(std::vector<Point3> points, std::vector<Surface3::Facet> facets) {
  return self_intersections(Surface3{std::move(points), std::move(facets)});
}

TEST(SelfIntersectionsInSpace, AtACommonEdgeAreFolds) {
  const std::vector<Point3> points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 0}, {0, -2, 0}, {1, 1, 0x1p-100}};
  EXPECT_THAT(of_triangles(points, {{0, 1, 2}, {0, 1, 3}}), ElementsAre(Pair(0, 1)));
  EXPECT_THAT(of_triangles(points, {{0, 1, 2}, {1, 0, 4}}), IsEmpty());
  EXPECT_THAT(of_triangles(points, {{0, 1, 2}, {1, 0, 5}}), IsEmpty());
  EXPECT_THAT(of_triangles(points, {{0, 1, 2}, {2, 1, 0}}), IsEmpty()) << "duplicates are another defect";
}

TEST(SelfIntersectionsInSpace, AtACommonVertexAreMoreThanThatVertex) {
  const std::vector<Point3> points = {{0, 0, 0},  {2, 0, 0},  {0, 2, 0}, {1, 1, 1}, {1, 1, -1}, {-2, 0, 0},
                                      {0, -2, 0}, {1, -1, 0}, {3, 1, 0}, {2, 2, 1}, {4, 0, 0},  {1, -1, 5}};
  const auto is_one = ElementsAre(Pair(0, 1));
  EXPECT_THAT(of_triangles(points, {{0, 1, 2}, {0, 3, 4}}), is_one) << "an edge through the inside";
  EXPECT_THAT(of_triangles(points, {{0, 1, 2}, {0, 5, 6}}), IsEmpty()) << "opposite, coplanar";
  EXPECT_THAT(of_triangles(points, {{0, 1, 2}, {0, 7, 8}}), is_one) << "overlapping, coplanar";
  EXPECT_THAT(of_triangles(points, {{0, 1, 2}, {0, 10, 6}}), is_one) << "along the same ray, coplanar";
  EXPECT_THAT(of_triangles(points, {{0, 1, 2}, {0, 10, 11}}), is_one) << "along the same ray";
  EXPECT_THAT(of_triangles(points, {{0, 1, 2}, {0, 9, 3}}), IsEmpty()) << "above";
}

TEST(SelfIntersectionsInSpace, DoNotTellIdsOfEqualPointsApart) {
  const Surface3 box = box_surface({0, 0, 0}, {1, 1, 1});
  Surface3 pieces;
  for (const auto& facet : box.facets) {
    auto& piece = pieces.facets.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      piece[k] = static_cast<std::uint32_t>(pieces.points.size());
      pieces.points.push_back(box.points[facet[k]]);
    }
  }
  pieces.points.push_back({-0.0, 0.0, -0.0});
  EXPECT_THAT(self_intersections(pieces), IsEmpty());
}

TEST(SelfIntersectionsInSpace, OfTwoBoxesWithACommonSide) {
  const Surface3 box = box_surface({0, 0, 0}, {1, 1, 1});
  EXPECT_THAT(self_intersections(join(box, box_surface({2, 0, 0}, {3, 1, 1}))), IsEmpty());
  EXPECT_THAT(self_intersections(join(box, box_surface({1, 1, 1}, {2, 2, 2}))), IsEmpty()) << "a vertex";
  const Surface3 halves = join(box, box_surface({1, 0.5, 0}, {2, 1.5, 1}));
  EXPECT_EQ(self_intersections(halves), self_intersections_by_definition(halves));
  EXPECT_FALSE(self_intersections(halves).empty());
}

// A disk of thin triangles around one vertex: all boxes meet there.
TEST(SelfIntersectionsInSpace, OfAFan) {
  Surface3 fan;
  fan.points.push_back({0, 0, 0});
  constexpr std::uint32_t kSize = 300;
  for (std::uint32_t i = 0; i < kSize; ++i) {
    const double angle = 2 * std::acos(-1.0) * i / kSize;
    fan.points.push_back({std::cos(angle), std::sin(angle), 0});
    fan.facets.push_back({0, 1 + i, 1 + (i + 1) % kSize});
  }
  EXPECT_THAT(self_intersections(fan), IsEmpty());
  fan.points[7] = fan.points[9];
  fan.points[7][0] *= 2;
  fan.points[7][1] *= 2;
  EXPECT_FALSE(self_intersections(fan).empty());
}

// Counted by CGAL 5.5 with exact predicates. It tells vertices apart by their ids: where two are equal, in one
// of the models, it counts every pair of a facet at one and a facet at the other.
TEST(SelfIntersectionsOfRealModels, AreThoseThatOthersCount) {
  if (!has_collection()) GTEST_SKIP() << "no collection at " << collection();
  const auto nasty = [](const std::string& name) {
    return read_surface<3>((collection() / "real" / "nasty" / (name + ".off")).string());
  };
  EXPECT_EQ(self_intersections(nasty("self_intersecting")).size(), 251U);
  EXPECT_EQ(self_intersections(nasty("real_camel_selfint")).size(), 20U);
  const Surface3 cow = nasty("real_cow_duplicate_selfint");
  std::map<Point3, std::map<std::uint32_t, std::vector<std::uint32_t>>> facets_at;  // by point, then by vertex
  for (std::uint32_t f = 0; f < cow.facets.size(); ++f) {
    for (const std::uint32_t v : cow.facets[f]) facets_at[cow.points[v]][v].push_back(f);
  }
  const std::vector<FacetPair> pairs = self_intersections(cow);
  std::set<FacetPair> by_ids(pairs.begin(), pairs.end());
  for (const auto& [point, vertices] : facets_at) {
    if (vertices.size() != 2) continue;
    for (const std::uint32_t f : vertices.begin()->second) {
      for (const std::uint32_t g : vertices.rbegin()->second) by_ids.insert(std::minmax(f, g));
    }
  }
  EXPECT_EQ(by_ids.size(), 101U);
}

TEST(SelfIntersectionsOfRealModels, AreNoneInCleanOnes) {
  if (!has_collection()) GTEST_SKIP() << "no collection at " << collection();
  std::size_t models = 0;
  for (const auto& path : data_files(collection() / "real")) {
    EXPECT_THAT(self_intersections(read_surface<3>(path.string())), IsEmpty()) << path;
    ++models;
  }
  EXPECT_GE(models, 10U);
}

}  // namespace
}  // namespace sinkmesh::test
