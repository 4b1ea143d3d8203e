// SPDX-License-Identifier: MIT
#include "core/spatial_order.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <map>

#include "core/hilbert.h"
#include "core/mix.h"
#include "test/support/complexes.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class Dimension>
class Hilbert : public testing::Test {};
TYPED_TEST_SUITE(Hilbert, Dimensions, DimensionNames);

template <int Dim>
std::uint32_t distance(const std::array<std::uint32_t, Dim>& a, const std::array<std::uint32_t, Dim>& b) {
  std::uint32_t sum = 0;
  for (std::size_t k = 0; k < Dim; ++k) sum += a[k] > b[k] ? a[k] - b[k] : b[k] - a[k];
  return sum;
}

/// Every cell of the cube with 2^levels cells a side at `base`, once; calls visit(cell).
template <int Dim, class Visit>
void for_all_cells(const std::array<std::uint32_t, Dim>& base, int levels, Visit&& visit) {
  for (std::uint32_t n = 0; n < 1U << (Dim * levels); ++n) {
    auto cell = base;
    for (std::size_t k = 0; k < Dim; ++k) {
      cell[k] += n >> (k * static_cast<std::size_t>(levels)) & ((1U << levels) - 1);
    }
    visit(cell);
  }
}

// Within an aligned cube, anywhere, the curve visits each cell once, without leaving, from neighbour to
// neighbour.
TYPED_TEST(Hilbert, NeighboursOnTheCurveAreNeighboursInSpace) {
  constexpr int Dim = TypeParam::value;
  using Curve = HilbertCurve<Dim>;
  using Cell = std::array<std::uint32_t, Dim>;
  constexpr int kLevels = 3;
  Random random(1);
  for (int trial = 0; trial < 300; ++trial) {
    Cell base;
    for (std::uint32_t& x : base)
      x = static_cast<std::uint32_t>(random() % (1U << (Curve::kLevels - kLevels))) << kLevels;
    std::map<std::uint32_t, Cell> by_index;
    for_all_cells<Dim>(base, kLevels, [&](const Cell& cell) { by_index[Curve::index(cell)] = cell; });
    constexpr std::uint32_t kCells = 1U << (Dim * kLevels);
    ASSERT_EQ(by_index.size(), kCells);
    ASSERT_EQ(by_index.begin()->first % kCells, 0U);
    ASSERT_EQ(by_index.rbegin()->first, by_index.begin()->first + kCells - 1);
    for (auto it = std::next(by_index.begin()); it != by_index.end(); ++it) {
      ASSERT_EQ(distance<Dim>(it->second, std::prev(it)->second), 1U);
    }
  }
}

// From the coarse end: a cube of any size is one interval of the curve, and the intervals are neighbours too.
TYPED_TEST(Hilbert, IsTheSameCurveAtEveryLevel) {
  constexpr int Dim = TypeParam::value;
  using Curve = HilbertCurve<Dim>;
  using Cell = std::array<std::uint32_t, Dim>;
  Random random(2);
  for (int levels = 1; levels <= 4; ++levels) {
    const int rest = Curve::kLevels - levels;
    std::map<std::uint32_t, Cell> by_place;
    for_all_cells<Dim>(Cell{}, levels, [&](const Cell& coarse) {
      Cell cell = coarse;
      for (std::uint32_t& x : cell) x = x << rest | static_cast<std::uint32_t>(random() % (1U << rest));
      by_place[Curve::index(cell) >> (Dim * rest)] = coarse;
    });
    ASSERT_EQ(by_place.size(), std::size_t{1} << (Dim * levels));
    for (auto it = std::next(by_place.begin()); it != by_place.end(); ++it) {
      ASSERT_EQ(distance<Dim>(it->second, std::prev(it)->second), 1U) << "level " << levels;
    }
  }
}

template <class Dimension>
class SpatialOrder : public testing::Test {};
TYPED_TEST_SUITE(SpatialOrder, Dimensions, DimensionNames);

template <int Dim>
Box<Dim> box_of(const std::vector<Point<Dim>>& points) {
  Box<Dim> box;
  for (const auto& p : points) box.include(p);
  return box;
}

/// Uniform, on a coarse grid with many copies, and in clusters within clusters.
template <int Dim>
std::vector<std::vector<Point<Dim>>> order_clouds() {
  Random random(3);
  std::vector<std::vector<Point<Dim>>> clouds(4);
  for (int i = 0; i < 10000; ++i) {
    for (double& x : clouds[0].emplace_back()) x = uniform(random, -1, 1);
    for (double& x : clouds[1].emplace_back()) x = uniform_int(random, 0, 9);
    const int depth = uniform_int(random, 0, 100);
    for (double& x : clouds[2].emplace_back()) x = std::ldexp(uniform(random, 0, 1), -depth);
  }
  // All but one in a single cell, and again within it; copies of a point among them.
  for (int i = 0; i < 3000; ++i) {
    const double scale = i % 2 != 0 ? 0x1p-40 : 0x1p-80;
    for (double& x : clouds[3].emplace_back()) x = 0.25 + scale * uniform_int(random, 0, 1000);
  }
  clouds[3].push_back({});
  clouds[3][0].fill(1);
  return clouds;
}

TYPED_TEST(SpatialOrder, HoldsEveryPointOnceAndMapsCopiesToTheFirst) {
  constexpr int Dim = TypeParam::value;
  for (const auto& points : order_clouds<Dim>()) {
    const InsertionOrder result = insertion_order<Dim>(points, box_of<Dim>(points));
    std::map<Point<Dim>, std::uint32_t> first;
    std::vector<std::uint32_t> expected_order;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> expected_copies;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const auto [found, is_new] = first.try_emplace(points[i], i);
      if (is_new) {
        expected_order.push_back(i);
      } else {
        expected_copies.emplace_back(i, found->second);
      }
    }
    auto order = result.order;
    std::sort(order.begin(), order.end());
    EXPECT_TRUE(order == expected_order);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> copies;
    for (const auto& [copy, original] : result.duplicates) copies.emplace_back(copy, original);
    EXPECT_TRUE(copies == expected_copies);
  }
}

TYPED_TEST(SpatialOrder, IsAFunctionOfTheSetOfPoints) {
  constexpr int Dim = TypeParam::value;
  Random random(4);
  for (auto points : order_clouds<Dim>()) {
    const auto sequence = [&points] {
      std::vector<Point<Dim>> result;
      for (const std::uint32_t i : insertion_order<Dim>(points, box_of<Dim>(points)).order)
        result.push_back(points[i]);
      return result;
    };
    const auto expected = sequence();
    for (int trial = 0; trial < 3; ++trial) {
      std::shuffle(points.begin(), points.end(), random);
      EXPECT_TRUE(sequence() == expected);
    }
  }
}

// Points in the middle of cells of the curve, distinct cells: the order is by round, then by place. Small sets
// and large ones take different ways to sort.
TYPED_TEST(SpatialOrder, FollowsTheCurveWithinEachRound) {
  constexpr int Dim = TypeParam::value;
  using Curve = HilbertCurve<Dim>;
  Random random(5);
  for (const int n : {50, 2000, 2100, 30000}) {
    SCOPED_TRACE(n);
    Box<Dim> box;
    box.include({});
    Point<Dim> far;
    far.fill(std::ldexp(1.0, Curve::kLevels));
    box.include(far);
    std::map<std::uint32_t, Point<Dim>> by_place;
    while (by_place.size() < static_cast<std::size_t>(n)) {
      std::array<std::uint32_t, Dim> cell;
      Point<Dim> p;
      for (std::size_t k = 0; k < Dim; ++k) {
        cell[k] = static_cast<std::uint32_t>(random() % (1U << Curve::kLevels));
        p[k] = cell[k] + 0.5;
      }
      by_place[Curve::index(cell)] = p;
    }
    std::vector<Point<Dim>> expected;
    std::vector<std::size_t> size(16);
    for (int zeros = 15; zeros >= 0; --zeros) {
      for (const auto& [place, p] : by_place) {
        if (std::min(std::countr_zero(hash_point<Dim>(p)) / 3, 15) != zeros) continue;
        expected.push_back(p);
        ++size[static_cast<std::size_t>(zeros)];
      }
    }
    auto points = expected;
    std::shuffle(points.begin(), points.end(), random);
    std::vector<Point<Dim>> sequence;
    for (const std::uint32_t i : insertion_order<Dim>(points, box).order) sequence.push_back(points[i]);
    EXPECT_TRUE(sequence == expected);
    if (n == 30000) {
      EXPECT_NEAR(static_cast<double>(size[0]) / n, 7.0 / 8, 0.01) << "points of the last round";
      EXPECT_NEAR(static_cast<double>(size[1]) / n, 7.0 / 64, 0.01);
    }
  }
}

// A cluster of relative size 2^-100 is followed as a curve of its own: its steps are short in its own scale.
TYPED_TEST(SpatialOrder, FollowsACurveThroughDeepClusters) {
  constexpr int Dim = TypeParam::value;
  Random random(6);
  std::vector<Point<Dim>> points;
  for (int i = 0; i < 8000; ++i) {
    for (double& x : points.emplace_back()) x = 0x1p-100 * uniform(random, 0, 1);
  }
  points.emplace_back().fill(1);
  const auto order = insertion_order<Dim>(points, box_of<Dim>(points)).order;
  double length = 0;
  std::size_t steps = 0;
  for (std::size_t i = order.size() / 2; i + 1 < order.size(); ++i) {  // within the last round
    double square = 0;
    for (std::size_t k = 0; k < Dim; ++k) {
      const double d = (points[order[i]][k] - points[order[i + 1]][k]) * 0x1p100;
      square += d * d;
    }
    if (square > 4 * Dim) continue;  // to and from the far point
    length += std::sqrt(square);
    ++steps;
  }
  // A cell of n equal ones has side n^(-1/Dim); random order would make steps of about 0.5.
  EXPECT_LT(length / static_cast<double>(steps), 2 * std::pow(7000.0, -1.0 / Dim));
}

TYPED_TEST(SpatialOrder, TakesNoPointsAndEqualPoints) {
  constexpr int Dim = TypeParam::value;
  const std::vector<Point<Dim>> none;
  EXPECT_TRUE(insertion_order<Dim>(none, Box<Dim>{}).order.empty());
  const std::vector<Point<Dim>> equal(5000);
  const InsertionOrder result = insertion_order<Dim>(equal, box_of<Dim>(equal));
  EXPECT_EQ(result.order, std::vector<std::uint32_t>{0});
  ASSERT_EQ(result.duplicates.size(), 4999U);
  for (std::uint32_t i = 0; i < 4999; ++i) {
    EXPECT_EQ(result.duplicates[i].copy, i + 1);
    EXPECT_EQ(result.duplicates[i].original, 0U);
  }
}

}  // namespace
}  // namespace sinkmesh
