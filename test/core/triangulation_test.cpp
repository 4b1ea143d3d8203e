// SPDX-License-Identifier: MIT
//
// What a triangulation promises beyond being Delaunay: refusals, ids, duplicates, the hull, counts.
#include "core/triangulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/mix.h"
#include "test/support/complexes.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class Dimension>
class Triangulations : public testing::Test {};
TYPED_TEST_SUITE(Triangulations, Dimensions, DimensionNames);

/// -2 if the points can be triangulated.
template <int Dim>
int refused_dimension(const std::vector<Point<Dim>>& points, Engine engine) {
  try {
    const Triangulation<Dim> triangulation(points, engine);
    return -2;
  } catch (const DegenerateInput& error) {
    return error.affine_dimension();
  }
}

/// Images of random integer points of a flat under a map that keeps them exact: combinations of its directions.
template <int Dim>
std::vector<Point<Dim>> points_of_flat(int dimension, std::size_t n, Random& random) {
  std::vector<Point<Dim>> directions(static_cast<std::size_t>(dimension));
  for (auto& d : directions) {
    for (double& x : d) x = uniform_int(random, -5, 5);
  }
  Point<Dim> origin;
  for (double& x : origin) x = uniform_int(random, -9, 9);
  std::vector<Point<Dim>> points(n, origin);
  for (auto& p : points) {
    for (const auto& d : directions) {
      const int factor = uniform_int(random, -20, 20);
      for (std::size_t k = 0; k < Dim; ++k) p[k] += factor * d[k];
    }
  }
  return points;
}

/// By the ranks of integer matrices.
template <int Dim>
int affine_dimension_of(const std::vector<Point<Dim>>& points) {
  if (points.empty()) return -1;
  std::vector<std::vector<mpq_class>> rows;
  for (const auto& p : points) {
    auto& row = rows.emplace_back();
    for (std::size_t k = 0; k < Dim; ++k) row.emplace_back(p[k] - points[0][k]);
  }
  int rank = 0;
  for (std::size_t column = 0; column < Dim; ++column) {
    auto pivot =
        std::find_if(rows.begin() + rank, rows.end(), [&](const auto& row) { return row[column] != 0; });
    if (pivot == rows.end()) continue;
    std::iter_swap(rows.begin() + rank, pivot);
    for (auto row = rows.begin() + rank + 1; row != rows.end(); ++row) {
      const mpq_class factor = (*row)[column] / rows[static_cast<std::size_t>(rank)][column];
      for (std::size_t k = 0; k < Dim; ++k) (*row)[k] -= factor * rows[static_cast<std::size_t>(rank)][k];
    }
    ++rank;
  }
  return rank;
}

TYPED_TEST(Triangulations, RefusePointsOfAFlatAndNameItsDimension) {
  constexpr int Dim = TypeParam::value;
  Random random(1);
  std::set<int> seen;
  for (const Engine engine : kEngines) {
    EXPECT_EQ(refused_dimension<Dim>({}, engine), -1);
    EXPECT_EQ(refused_dimension<Dim>(std::vector<Point<Dim>>(7, Point<Dim>{}), engine), 0);
    for (int trial = 0; trial < 200; ++trial) {
      const auto points = points_of_flat<Dim>(trial % (Dim + 1), 1 + random() % 30, random);
      const int expected = affine_dimension_of<Dim>(points);
      EXPECT_EQ(refused_dimension<Dim>(points, engine), expected == Dim ? -2 : expected);
      seen.insert(expected);
    }
  }
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(Dim + 1));
}

// One point off the flat, in the last bit, is enough.
TYPED_TEST(Triangulations, TakeAFlatAndOnePointBesideIt) {
  constexpr int Dim = TypeParam::value;
  Random random(2);
  for (const Engine engine : kEngines) {
    std::vector<Point<Dim>> points(60);
    for (auto& p : points) {
      for (double& x : p) x = uniform_int(random, -9, 9);
      p[Dim - 1] = 1;
    }
    points[17][Dim - 1] = std::nextafter(1.0, 2.0);
    ASSERT_EQ(affine_dimension_of<Dim>(points), Dim);
    const Triangulation<Dim> triangulation(points, engine);
    EXPECT_TRUE(triangulation.validate().ok()) << triangulation.validate();
    for (const Simplex s : triangulation.complex().simplices()) {
      if (!triangulation.complex().is_ghost(s)) {
        EXPECT_GE(triangulation.complex().index_of(s, Vertex(17)), 0);
      }
    }
  }
}

TYPED_TEST(Triangulations, NameTheFirstCoordinateThatIsNotFinite) {
  constexpr int Dim = TypeParam::value;
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()}) {
    auto points = full_grid<Dim>(3);
    points[6][1] = bad;
    points[7][0] = bad;
    for (const Engine engine : kEngines) {
      try {
        const Triangulation<Dim> triangulation(points, engine);
        FAIL() << "accepted " << bad;
      } catch (const DegenerateInput& error) {
        FAIL() << error.what();
      } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("point 6"));
        EXPECT_THAT(error.what(), testing::HasSubstr("y is"));
      }
    }
  }
}

// Each point two or three times, shuffled, some as -0.0: the ids of the input stay, copies are in no simplex.
TYPED_TEST(Triangulations, KeepTheIdsOfTheInputAndReportCopies) {
  constexpr int Dim = TypeParam::value;
  Random random(3);
  for (const Engine engine : kEngines) {
    std::vector<Point<Dim>> points;
    for (const auto& p : full_grid<Dim>(4)) points.insert(points.end(), 1 + random() % 3, p);
    std::shuffle(points.begin(), points.end(), random);
    for (std::size_t i = 0; i < points.size(); i += 2) {
      for (double& x : points[i]) {
        if (x == 0) x = -0.0;
      }
    }
    const Triangulation<Dim> triangulation(points, engine);
    const auto& complex = triangulation.complex();
    EXPECT_TRUE(triangulation.validate().ok()) << triangulation.validate();
    EXPECT_EQ(complex.num_vertices(), points.size());

    std::map<Point<Dim>, std::uint32_t> first;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> expected;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(triangulation.point(Vertex(i)), points[i]);  // -0.0 equals 0.0
      const auto [found, is_new] = first.try_emplace(points[i], i);
      if (!is_new) expected.emplace_back(i, found->second);
      EXPECT_EQ(complex.incident_simplex(Vertex(i)).is_null(), !is_new);
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> copies;
    for (const auto& [copy, original] : triangulation.duplicates()) copies.emplace_back(copy, original);
    EXPECT_EQ(copies, expected);
    EXPECT_EQ(triangulation.hash(), Triangulation<Dim>(full_grid<Dim>(4)).hash());
  }
}

// Coordinates of any size come back bit for bit, and so does the complex.
TYPED_TEST(Triangulations, DoNotDependOnTheUnitOfLength) {
  constexpr int Dim = TypeParam::value;
  Random random(4);
  std::vector<Point<Dim>> points(60);
  for (auto& p : points) {
    for (double& x : p) x = uniform(random, -1, 1);
  }
  const auto expected = simplex_sets(Triangulation<Dim>(points).complex());
  for (const int exponent : {-700, -1, 1, 64, 1000}) {
    auto scaled = points;
    for (auto& p : scaled) {
      for (double& x : p) x = std::ldexp(x, exponent);
    }
    const Triangulation<Dim> triangulation(scaled);
    EXPECT_EQ(simplex_sets(triangulation.complex()), expected) << exponent;
    for (std::uint32_t i = 0; i < points.size(); ++i) EXPECT_EQ(triangulation.point(Vertex(i)), scaled[i]);
  }
}

/// Dim! times the volume of all solid simplices; counts those that are not positive.
template <int Dim>
std::int64_t volume_of(const Triangulation<Dim>& triangulation, std::size_t& not_positive) {
  std::int64_t sum = 0;
  for (const Simplex s : triangulation.complex().simplices()) {
    if (triangulation.complex().is_ghost(s)) continue;
    std::array<Point<Dim>, Dim + 1> p;
    for (int i = 0; i <= Dim; ++i) {
      p[static_cast<std::size_t>(i)] = triangulation.point(triangulation.complex().corner(s, i));
    }
    const std::int64_t volume = integer_volume<Dim>(p);
    not_positive += volume <= 0 ? 1 : 0;
    sum += volume;
  }
  return sum;
}

/// Calls check(triangulation, points) for clouds that contain the corners of a box, and the box's size along
/// each axis.
template <int Dim, class Check>
void for_boxes(std::uint64_t seed, Check&& check) {
  Random random(seed);
  for (int trial = 0; trial < 30; ++trial) {
    std::array<int, Dim> side;
    for (int& s : side) s = uniform_int(random, 1, 9);
    std::vector<Point<Dim>> points;
    for (Point<Dim> p : full_grid<Dim>(2)) {
      for (std::size_t k = 0; k < Dim; ++k) p[k] *= side[k];
      points.push_back(p);
    }
    for (int i = uniform_int(random, 0, 150); i > 0; --i) {
      auto& p = points.emplace_back();
      for (std::size_t k = 0; k < Dim; ++k) p[k] = uniform_int(random, 0, side[k]);
    }
    for (const Engine engine : kEngines) check(Triangulation<Dim>(points, engine), points, side);
  }
}

TYPED_TEST(Triangulations, FillTheirHullExactly) {
  constexpr int Dim = TypeParam::value;
  for_boxes<Dim>(5, [](const Triangulation<Dim>& triangulation, const auto& points, const auto& side) {
    std::size_t not_positive = 0;
    std::int64_t expected = Dim == 2 ? 2 : 6;
    for (const int s : side) expected *= s;
    EXPECT_EQ(volume_of(triangulation, not_positive), expected);
    EXPECT_EQ(not_positive, 0U);

    // No vertex is strictly beyond a hull facet, and the hull's facets are those of the box.
    const auto& complex = triangulation.complex();
    std::size_t ghosts = 0;
    for (const Simplex s : complex.simplices()) {
      if (!complex.is_ghost(s)) continue;
      ++ghosts;
      std::array<Point<Dim>, Dim + 1> p;
      for (int i = 0; i < Dim; ++i) p[static_cast<std::size_t>(i)] = triangulation.point(complex.corner(s, i));
      bool on_side = false;
      for (std::size_t k = 0; k < Dim; ++k) {
        for (const double x : {0.0, static_cast<double>(side[k])}) {
          on_side = on_side || std::all_of(p.begin(), p.end() - 1, [&](const auto& q) { return q[k] == x; });
        }
      }
      EXPECT_TRUE(on_side);
      for (const auto& q : points) {
        p[Dim] = q;
        EXPECT_LE(integer_volume<Dim>(p), 0);
      }
    }
    EXPECT_EQ(triangulation.num_ghosts(), ghosts);
    EXPECT_EQ(triangulation.num_solid(), complex.num_simplices() - ghosts);
  });
}

// With infinity the complex is a sphere: the alternating sum of the numbers of its faces is 2 in the plane, 0
// in space. The hull is a sphere of one dimension less.
TYPED_TEST(Triangulations, SatisfyTheEulerRelation) {
  constexpr int Dim = TypeParam::value;
  for_boxes<Dim>(6, [](const Triangulation<Dim>& triangulation, const auto&, const auto&) {
    const auto& complex = triangulation.complex();
    std::set<std::vector<std::uint32_t>> faces;
    std::set<std::vector<std::uint32_t>> hull;
    for (const Simplex s : complex.simplices()) {
      const auto ids = ids_of(complex, s);
      for (unsigned subset = 1; subset < 1U << (Dim + 1); ++subset) {
        std::vector<std::uint32_t> face;
        for (std::size_t i = 0; i <= Dim; ++i) {
          if (subset >> i & 1U) face.push_back(ids[i]);
        }
        faces.insert(face);
        if (complex.is_ghost(s) && face.back() != Vertex::infinite().index()) hull.insert(face);
      }
    }
    const auto alternating_sum = [](const auto& set) {
      int sum = 0;
      for (const auto& face : set) sum += face.size() % 2 != 0 ? 1 : -1;
      return sum;
    };
    EXPECT_EQ(alternating_sum(faces), Dim == 2 ? 2 : 0);
    EXPECT_EQ(alternating_sum(hull), Dim == 2 ? 0 : 2);
  });
}

TYPED_TEST(Triangulations, CompactKeepsTheComplexAndTheIds) {
  constexpr int Dim = TypeParam::value;
  Random random(7);
  for (const Engine engine : kEngines) {
    // Insertion in a bad order, with a far point last, leaves gaps.
    auto points = full_grid<Dim>(Dim == 2 ? 12 : 5);
    std::shuffle(points.begin(), points.end(), random);
    Triangulation<Dim> triangulation(points, engine);
    Point<Dim> far;
    far.fill(Dim == 2 ? 15.75 : 7.75);
    triangulation.insert(far, Engine::star);
    points.push_back(far);
    for (int i = 0; i < 30; ++i) {
      auto& p = points.emplace_back();
      for (double& x : p) x = uniform(random, 0, Dim == 2 ? 12 : 5);
      triangulation.insert(p, engine);
    }
    // Gaps on purpose, wherever they are: slots given back unused, and one in front.
    auto& complex = triangulation.mutable_complex();
    complex.reserve(complex.free_slots().size() + 3);
    std::vector<Simplex> unused;
    for (auto n = complex.free_slots().size() + 3; n > 0; --n) unused.push_back(complex.allocate());
    // Simplex 0 moves to a later slot.
    const Simplex moved = unused.back();
    unused.pop_back();
    complex.records()[moved.index()] = complex.records()[0];
    for (int i = 0; i <= Dim; ++i) {
      complex.set_mates(Complex<Dim>::half_facet(moved, i), complex.mate(Complex<Dim>::half_facet(moved, i)));
      complex.set_incident(complex.corner(moved, i), moved);
    }
    complex.release(Simplex(0));
    for (const Simplex s : unused) complex.release(s);
    ASSERT_TRUE(triangulation.validate().ok()) << triangulation.validate();

    const auto before = simplex_sets(complex);
    const auto hash = triangulation.hash();
    EXPECT_GE(complex.num_slots(), complex.num_simplices() + 3);
    EXPECT_FALSE(complex.is_alive(Simplex(0)));
    triangulation.compact();
    EXPECT_EQ(complex.num_slots(), complex.num_simplices());
    EXPECT_TRUE(complex.free_slots().empty());
    EXPECT_TRUE(triangulation.validate().ok()) << triangulation.validate();
    EXPECT_EQ(simplex_sets(complex), before);
    EXPECT_EQ(triangulation.hash(), hash);
    for (std::uint32_t i = 0; i < points.size(); ++i) EXPECT_EQ(triangulation.point(Vertex(i)), points[i]);
    triangulation.compact();
    EXPECT_EQ(triangulation.hash(), hash);
    EXPECT_EQ(triangulation.hash(), Triangulation<Dim>(points).hash());
  }
}

TYPED_TEST(Triangulations, CompactKeepsTheSimplexInTheFirstSlot) {
  constexpr int Dim = TypeParam::value;
  Triangulation<Dim> triangulation(full_grid<Dim>(3));
  triangulation.compact();
  const auto hash = triangulation.hash();
  auto& complex = triangulation.mutable_complex();
  complex.reserve(1);
  complex.release(complex.allocate());
  ASSERT_TRUE(complex.is_alive(Simplex(0)));
  triangulation.compact();
  EXPECT_TRUE(triangulation.validate().ok()) << triangulation.validate();
  EXPECT_EQ(triangulation.hash(), hash);
}

// -- the hash

TYPED_TEST(Triangulations, HashDependsOnEveryCornerAndOnNoOrder) {
  constexpr int Dim = TypeParam::value;
  const auto points = full_grid<Dim>(3);
  using Corners = std::array<std::uint32_t, Dim + 1>;
  const auto hash = [&points](const std::vector<Corners>& simplices) {
    SimplexSetHash<Dim> h(points);
    for (const Corners& s : simplices) h.add(s);
    return h.value();
  };
  Corners s;
  std::iota(s.begin(), s.end(), 0U);
  Corners turned = s;
  std::reverse(turned.begin(), turned.end());
  EXPECT_EQ(hash({s}), hash({turned}));
  std::set<std::uint64_t> values{hash({}), hash({s}), hash({s, s})};
  for (std::size_t i = 0; i <= Dim; ++i) {
    Corners other = s;
    other[i] = 7;
    values.insert(hash({other}));
    values.insert(hash({s, other}));
    EXPECT_EQ(hash({s, other}), hash({other, s}));
  }
  EXPECT_EQ(values.size(), 3U + 2 * (Dim + 1));
}

TYPED_TEST(Triangulations, HashChangesWithTheComplexAndWithTheUnit) {
  constexpr int Dim = TypeParam::value;
  const auto points = full_grid<Dim>(3);
  std::set<std::uint64_t> values;
  for (std::size_t left = 0; left < points.size(); ++left) {
    auto fewer = points;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(left));
    values.insert(Triangulation<Dim>(fewer).hash());
  }
  auto doubled = points;
  for (auto& p : doubled) {
    for (double& x : p) x *= 2;
  }
  values.insert(Triangulation<Dim>(points).hash());
  values.insert(Triangulation<Dim>(doubled).hash());
  EXPECT_EQ(values.size(), points.size() + 2);
}

}  // namespace
}  // namespace sinkmesh
