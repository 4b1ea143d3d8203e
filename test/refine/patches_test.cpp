// SPDX-License-Identifier: MIT
#include "refine/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "core/triangulation.h"
#include "test/support/rational_geometry.h"
#include "test/support/voxels.h"

namespace sinkmesh {
namespace {

using Facet = std::array<Vertex, 3>;
using Facets = std::vector<Facet>;
using Patches = std::vector<BoundaryFeatures<3>::Patch>;
using test::Random;
using test::Rational;

// Of facets none of which has been divided.
std::vector<PatchFacet> patches_of(const Complex<3>& complex, const Facets& facets,
                                   const std::vector<std::int64_t>& tags, double flat, Patches& planes) {
  std::vector<PlacedFacet> placed;
  for (std::uint32_t f = 0; f < facets.size(); ++f) placed.push_back({facets[f], f});
  return find_patches(complex, placed, tags, flat, planes);
}

Facet sorted(Facet f) {
  std::sort(f.begin(), f.end());
  return f;
}

// The sets of facets of the patches, by sorted corners.
std::set<std::set<Facet>> partition(const std::vector<PatchFacet>& of_facet) {
  std::map<std::uint32_t, std::set<Facet>> sets;
  for (const PatchFacet& f : of_facet) sets[f.patch].insert(sorted(f.vertices));
  std::set<std::set<Facet>> result;
  for (const auto& [patch, set] : sets) result.insert(set);
  return result;
}

// The pairs of facets that share an edge which no other facet has.
std::vector<std::pair<std::size_t, std::size_t>> pairs_of(const Facets& facets) {
  std::map<std::pair<Vertex, Vertex>, std::vector<std::size_t>> edges;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges[std::minmax(facets[f][k], facets[f][(k + 1) % 3])].push_back(f);
    }
  }
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (const auto& [edge, users] : edges) {
    if (users.size() == 2) result.emplace_back(users[0], users[1]);
  }
  return result;
}

// Joined by those pairs for which `is_joined`.
template <class IsJoined>
std::set<std::set<Facet>> joined(const Facets& facets, IsJoined&& is_joined) {
  std::vector<std::size_t> set(facets.size());
  std::iota(set.begin(), set.end(), std::size_t{0});
  for (const auto& [f, g] : pairs_of(facets)) {
    if (!is_joined(f, g)) continue;
    const std::size_t old = set[g];
    const std::size_t now = set[f];
    std::replace(set.begin(), set.end(), old, now);
  }
  std::map<std::size_t, std::set<Facet>> sets;
  for (std::size_t f = 0; f < facets.size(); ++f) sets[set[f]].insert(sorted(facets[f]));
  std::set<std::set<Facet>> result;
  for (const auto& [number, members] : sets) result.insert(members);
  return result;
}

void shuffle(Facets& facets, std::vector<std::int64_t>& tags, Random& random) {
  std::vector<std::size_t> order(facets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), random);
  Facets moved;
  std::vector<std::int64_t> moved_tags;
  for (const std::size_t f : order) {
    moved.push_back(facets[f]);
    std::shuffle(moved.back().begin(), moved.back().end(), random);
    if (!tags.empty()) moved_tags.push_back(tags[f]);
  }
  facets = moved;
  tags = moved_tags;
}

Rational projected_area(const Complex<3>& complex, const Plane& plane, const Facet& f) {
  std::array<std::array<Rational, 2>, 3> p;
  for (std::size_t k = 0; k < 3; ++k) {
    p[k] = test::rational<2>(plane.project(complex.point(f[k])));
  }
  return Rational((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]));
}

void expect_counterclockwise(const Complex<3>& complex, const Facets& facets,
                             const std::vector<PatchFacet>& of_facet, const Patches& planes) {
  ASSERT_EQ(of_facet.size(), facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    ASSERT_LT(of_facet[f].patch, planes.size());
    ASSERT_EQ(sorted(of_facet[f].vertices), sorted(facets[f]));
    ASSERT_GT(projected_area(complex, planes[of_facet[f].patch].plane, of_facet[f].vertices), 0);
  }
  for (std::uint32_t p = 0; p < planes.size(); ++p) EXPECT_EQ(of_facet[planes[p].facet].patch, p);
}

// Solids made of cubes: two facets are coplanar if they have the same constant coordinate. Sides that meet in
// edges of four facets are not joined, tags keep facets apart.
TEST(Patches, OfSolidsMadeOfCubesAreTheirSides) {
  Random random(11);
  test::Voxels<3> voxels(6);
  const Complex<3>& complex = voxels.triangulation().complex();
  for (int round = 0; round < 12; ++round) {
    SCOPED_TRACE(round);
    voxels.fill_at_random(round % 3 == 0 ? 2 : 1, random);
    Facets facets = voxels.facets(voxels.interfaces());
    std::vector<std::int64_t> tags;
    if (round % 2 == 0) {
      for (std::size_t f = 0; f < facets.size(); ++f) tags.push_back(static_cast<std::int64_t>(random() % 2));
    }
    const auto axis_of = [&](const Facet& f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = complex.point(f[0])[k];
        if (complex.point(f[1])[k] == x && complex.point(f[2])[k] == x) return k;
      }
      return std::size_t{3};
    };
    const auto expected = joined(facets, [&](std::size_t f, std::size_t g) {
      return axis_of(facets[f]) == axis_of(facets[g]) && (tags.empty() || tags[f] == tags[g]);
    });
    EXPECT_GT(expected.size(), 10U);
    for (const double flat : {0.0, 0x1p-42}) {
      for (int order = 0; order < 3; ++order) {
        Patches planes;
        const auto of_facet = patches_of(complex, facets, tags, flat, planes);
        EXPECT_EQ(partition(of_facet), expected);
        expect_counterclockwise(complex, facets, of_facet, planes);
        shuffle(facets, tags, random);
      }
    }
  }
}

// A sheet of unit squares with random heights of a few levels of the tolerance.
struct Sheet {
  std::vector<Point3> points;
  Facets facets;

  Sheet(int n, double height, Random& random) {
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        points.push_back({i + test::uniform(random, -0.3, 0.3), j + test::uniform(random, -0.3, 0.3),
                          height * test::uniform(random, -1, 1)});
      }
    }
    const auto id = [n](int i, int j) { return Vertex(static_cast<std::uint32_t>(i * (n + 1) + j)); };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        facets.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
        facets.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
      }
    }
  }
};

double distance_from(const Complex<3>& complex, const Facet& base, Vertex v) {
  const auto a = test::rational<3>(complex.point(base[0]));
  std::array<std::array<Rational, 3>, 3> d;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto p = test::rational<3>(complex.point(i < 2 ? base[i + 1] : v));
    for (std::size_t k = 0; k < 3; ++k) d[i][k] = p[k] - a[k];
  }
  std::array<Rational, 3> n;
  for (std::size_t k = 0; k < 3; ++k) {
    n[k] = d[0][(k + 1) % 3] * d[1][(k + 2) % 3] - d[0][(k + 2) % 3] * d[1][(k + 1) % 3];
  }
  const Rational height = n[0] * d[2][0] + n[1] * d[2][1] + n[2] * d[2][2];
  return std::abs(height.get_d()) / std::sqrt(Rational(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).get_d());
}

// What makes a patch: all of it near the plane of its largest facet, nothing next to it left out that would
// fit, unless a patch before it, that of a larger facet, has taken it.
TEST(Patches, GrowFromTheLargestFacetAsFarAsTheToleranceAllows) {
  Random random(12);
  for (const double height : {0.5e-3, 2e-3, 8e-3}) {
    SCOPED_TRACE(height);
    Sheet sheet(8, height, random);
    const Triangulation3 triangulation(sheet.points);
    const Complex<3>& complex = triangulation.complex();
    const double flat = 1e-3 * std::ldexp(1.0, triangulation.gate().exponent());
    std::vector<std::int64_t> tags;
    Patches planes;
    const auto of_facet = patches_of(complex, sheet.facets, tags, flat, planes);
    expect_counterclockwise(complex, sheet.facets, of_facet, planes);
    std::vector<double> area;
    for (const Facet& f : sheet.facets) {
      const Plane plane = Plane::through(complex.point(f[0]), complex.point(f[1]), complex.point(f[2]));
      area.push_back(std::abs(projected_area(complex, plane, f).get_d() / plane.normal[plane.dropped]));
    }
    std::size_t joins = 0;
    std::size_t borders = 0;
    for (std::size_t f = 0; f < sheet.facets.size(); ++f) {
      const Facet& base = sheet.facets[planes[of_facet[f].patch].facet];
      EXPECT_LE(area[f], area[planes[of_facet[f].patch].facet] * (1 + 1e-12));
      for (const Vertex v : sheet.facets[f]) EXPECT_LE(distance_from(complex, base, v), flat * (1 + 1e-9));
    }
    for (const auto& [f, g] : pairs_of(sheet.facets)) {
      if (of_facet[f].patch == of_facet[g].patch) {
        ++joins;
        continue;
      }
      ++borders;
      // Patches are numbered as they were grown.
      const std::size_t later = of_facet[f].patch < of_facet[g].patch ? g : f;
      const std::size_t earlier = later == g ? f : g;
      const Facet& base = sheet.facets[planes[of_facet[earlier].patch].facet];
      double farthest = 0;
      for (const Vertex v : sheet.facets[later]) farthest = std::max(farthest, distance_from(complex, base, v));
      EXPECT_GT(farthest, flat * (1 - 1e-9));
    }
    EXPECT_GT(joins, 5U);
    EXPECT_GT(borders, height > 1e-3 ? 5U : 0U);
    const auto expected = partition(of_facet);
    for (int order = 0; order < 4; ++order) {
      shuffle(sheet.facets, tags, random);
      EXPECT_EQ(partition(patches_of(complex, sheet.facets, tags, flat, planes)), expected);
    }
    // Nothing but itself is exactly coplanar.
    patches_of(complex, sheet.facets, tags, 0, planes);
    EXPECT_EQ(planes.size(), sheet.facets.size());
  }
}

// Two coplanar facets on the same side of their edge would overlap in projection.
TEST(Patches, DoNotFold) {
  const std::vector<Point3> points = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {1, 2, 0}, {1, 1, 2}};
  const Triangulation3 triangulation(points);
  for (const double flat : {0.0, 1e-6}) {
    Patches planes;
    const Facets folded = {{Vertex(0), Vertex(1), Vertex(2)}, {Vertex(1), Vertex(0), Vertex(3)}};
    patches_of(triangulation.complex(), folded, {}, flat, planes);
    EXPECT_EQ(planes.size(), 2U);
    const Facets open = {{Vertex(0), Vertex(1), Vertex(3)}, {Vertex(0), Vertex(3), Vertex(2)}};
    patches_of(triangulation.complex(), open, {}, flat, planes);
    EXPECT_EQ(planes.size(), 1U);
  }
}

// An edge of three facets is a border, also where two of them are coplanar.
TEST(Patches, DoNotGrowAcrossAnEdgeOfThreeFacets) {
  const std::vector<Point3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  const Triangulation3 triangulation(points);
  Facets facets = {{Vertex(0), Vertex(1), Vertex(2)}, {Vertex(1), Vertex(0), Vertex(3)}};
  Patches planes;
  patches_of(triangulation.complex(), facets, {}, 0, planes);
  EXPECT_EQ(planes.size(), 1U);
  facets.push_back({Vertex(0), Vertex(1), Vertex(4)});
  patches_of(triangulation.complex(), facets, {}, 0, planes);
  EXPECT_EQ(planes.size(), 3U);
}

// A needle beside a facet of its side: the facet is divided in its place, the rest stays, and the surface is as
// closed as before. Not across tags, nor where nothing counts as flat.
TEST(Patches, NeedlesGiveTheirLongestEdgeAway) {
  const std::vector<Point3> points = {{0, 0, 0},     {1, 0, 0},      {0.5, 1e-9, 0},
                                      {0.4, 1, 0.2}, {0.5, -1, 0.3}, {0, 0, 1}};
  const Triangulation3 triangulation(points);
  const auto facet = [](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return Facet{Vertex(a), Vertex(b), Vertex(c)};
  };
  // The needle is 0 1 2; its longest edge 0 1 is that of 0 4 1, too.
  const Facets facets = {facet(0, 1, 2), facet(0, 4, 1), facet(0, 2, 3), facet(2, 1, 3), facet(0, 3, 5)};
  const auto ridges = [](const std::vector<PlacedFacet>& all) {
    std::map<std::pair<Vertex, Vertex>, int> count;
    for (const PlacedFacet& f : all) {
      for (std::size_t k = 0; k < 3; ++k) ++count[std::minmax(f.vertices[k], f.vertices[(k + 1) % 3])];
    }
    std::set<std::pair<Vertex, Vertex>> odd;
    for (const auto& [edge, n] : count) {
      if (n % 2 != 0) odd.insert(edge);
    }
    return odd;
  };
  const auto given = without_needles(triangulation.complex(), facets, {}, 0);
  ASSERT_EQ(given.size(), facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) EXPECT_EQ(given[f].vertices, facets[f]);
  const auto mended = without_needles(triangulation.complex(), facets, {}, 1e-6);
  ASSERT_EQ(mended.size(), facets.size());
  EXPECT_EQ(ridges(mended), ridges(given));
  std::set<Facet> now;
  for (const PlacedFacet& f : mended) now.insert(sorted(f.vertices));
  EXPECT_EQ(now,
            (std::set<Facet>{facet(0, 2, 4), facet(1, 2, 4), facet(0, 2, 3), facet(1, 2, 3), facet(0, 3, 5)}));
  for (const PlacedFacet& f : mended)
    EXPECT_EQ(f.parent == 1, std::count(f.vertices.begin(), f.vertices.end(), Vertex(4)) > 0);
  const std::vector<std::int64_t> tags = {1, 2, 1, 1, 1};
  const auto tagged = without_needles(triangulation.complex(), facets, tags, 1e-6);
  for (std::size_t f = 0; f < facets.size(); ++f) EXPECT_EQ(tagged[f].vertices, facets[f]);
}

// Nearly collinear corners, some of them one unit in the last place off a line: the projection must be turned
// towards the viewer, exactly.
TEST(Patches, NeedlesAreCounterclockwiseInTheirProjection) {
  Random random(13);
  for (int round = 0; round < 3000; ++round) {
    Point3 a;
    Point3 along;
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] = test::uniform(random, -1, 1);
      along[k] = round % 4 == 0 ? test::uniform_int(random, -1, 1) * 0.5 : test::uniform(random, -0.5, 0.5);
    }
    Point3 b;
    Point3 c;
    const double t = test::uniform(random, 0, 1);
    const double off = std::ldexp(1.0, test::uniform_int(random, -70, -20));
    for (std::size_t k = 0; k < 3; ++k) {
      b[k] = a[k] + along[k];
      c[k] = a[k] + t * along[k] + off * test::uniform(random, -1, 1);
    }
    bool is_collinear = true;
    const auto p = test::rational<3>(a);
    const auto q = test::rational<3>(b);
    const auto r = test::rational<3>(c);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      is_collinear = is_collinear && (q[k] - p[k]) * (r[l] - p[l]) == (q[l] - p[l]) * (r[k] - p[k]);
    }
    if (is_collinear) continue;
    const Plane plane = Plane::through(a, b, c);
    std::array<std::array<Rational, 2>, 3> f;
    const std::array<const Point3*, 3> corners = {&a, &b, &c};
    for (std::size_t k = 0; k < 3; ++k) f[k] = test::rational<2>(plane.project(*corners[k]));
    ASSERT_GT(Rational((f[1][0] - f[0][0]) * (f[2][1] - f[0][1]) - (f[1][1] - f[0][1]) * (f[2][0] - f[0][0])),
              0)
        << "round " << round;
    const double length = std::hypot(plane.normal[0], plane.normal[1], plane.normal[2]);
    EXPECT_NEAR(length, 1, 1e-14);
    for (const Point3* x : corners) EXPECT_LE(plane.distance(*x), 0x1p-50);
  }
}

// Lifting keeps the projection, and ends in the plane.
TEST(Patches, LiftedPointsLieInThePlane) {
  Random random(14);
  for (int round = 0; round < 500; ++round) {
    std::array<Point3, 3> p;
    for (Point3& x : p) {
      for (double& y : x) y = test::uniform(random, -1, 1);
    }
    const Plane plane = Plane::through(p[0], p[1], p[2]);
    const Point2 x = {test::uniform(random, -1, 1), test::uniform(random, -1, 1)};
    const Point3 lifted = plane.lift(x);
    EXPECT_EQ(plane.project(lifted), x);
    EXPECT_LE(plane.distance(lifted), 0x1p-48);
  }
}

}  // namespace
}  // namespace sinkmesh
