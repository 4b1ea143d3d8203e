// SPDX-License-Identifier: MIT
//
// Removal of vertices: against a triangulation of what is left, and as the inverse of insertion.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/triangulation.h"
#include "test/support/complexes.h"
#include "test/support/data_files.h"
#include "test/support/shapes.h"
#include "tools/io/read.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class Dimension>
class Removal : public testing::Test {};
TYPED_TEST_SUITE(Removal, Dimensions, DimensionNames);

template <int Dim>
bool is_in(const Triangulation<Dim>& triangulation, Vertex v) {
  return !triangulation.complex().incident_simplex(v).is_null();
}

template <int Dim>
std::vector<Point<Dim>> points_in(const Triangulation<Dim>& triangulation) {
  std::vector<Point<Dim>> points;
  for (std::uint32_t i = 0; i < triangulation.complex().num_vertices(); ++i) {
    if (is_in(triangulation, Vertex(i))) points.push_back(triangulation.point(Vertex(i)));
  }
  return points;
}

template <int Dim>
void expect_valid(const Triangulation<Dim>& triangulation) {
  const auto report = triangulation.validate();
  ASSERT_TRUE(report.ok()) << report;
  ASSERT_TRUE(triangulation.is_delaunay());
}

// Removes vertices in random order as long as that is possible, and compares after each.
template <int Dim>
void take_apart(const std::vector<Point<Dim>>& points, Random& random) {
  Triangulation<Dim> triangulation(points);
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  for (const std::uint32_t i : order) {
    SCOPED_TRACE(testing::Message() << "vertex " << i);
    if (!is_in(triangulation, Vertex(i))) continue;  // a copy of another
    const std::uint64_t before = triangulation.hash();
    auto rest = points_in(triangulation);
    std::erase(rest, triangulation.point(Vertex(i)));
    const auto expected = triangulate<Dim>(rest);
    if (!expected) {
      ASSERT_THROW(triangulation.remove(Vertex(i)), DegenerateInput);
      ASSERT_EQ(triangulation.hash(), before);
    } else {
      triangulation.remove(Vertex(i));
      ASSERT_FALSE(is_in(triangulation, Vertex(i)));
      ASSERT_EQ(triangulation.hash(), expected->hash());
    }
    ASSERT_NO_FATAL_FAILURE(expect_valid(triangulation));
  }
  // What is left is a simplex: without any other vertex it would be flat.
  EXPECT_EQ(triangulation.num_solid(), 1U);
}

TYPED_TEST(Removal, LeavesTheComplexOfTheOtherPoints) {
  constexpr int Dim = TypeParam::value;
  Random random(1);
  int taken_apart = 0;
  for (int trial = 0; trial < 120; ++trial) {
    for (const Cloud kind : kAllClouds) {
      SCOPED_TRACE(testing::Message() << "cloud " << static_cast<int>(kind) << ", trial " << trial);
      const auto points = make_cloud<Dim>(kind, 6 + static_cast<std::size_t>(trial) % 9, random);
      if (!triangulate<Dim>(points)) continue;
      ASSERT_NO_FATAL_FAILURE(take_apart<Dim>(points, random));
      ++taken_apart;
    }
  }
  EXPECT_GT(taken_apart, 500);
}

TYPED_TEST(Removal, OfHalfOfAShapeLeavesTheComplexOfTheOtherHalf) {
  constexpr int Dim = TypeParam::value;
  Random random(2);
  for (const Shape shape : kShapes) {
    SCOPED_TRACE(testing::Message() << "shape " << static_cast<int>(shape));
    const auto points = make_shape<Dim>(shape, 400, random);
    Triangulation<Dim> triangulation(points);
    std::size_t kept = 0;
    for (std::uint32_t i = 0; i < points.size(); i += 2) {
      if (!is_in(triangulation, Vertex(i))) continue;
      try {
        triangulation.remove(Vertex(i));
      } catch (const DegenerateInput&) {
        ++kept;  // the others are in a hyperplane
      }
    }
    EXPECT_LE(kept, 2U);
    ASSERT_NO_FATAL_FAILURE(expect_valid(triangulation));
    EXPECT_EQ(triangulation.hash(), Triangulation<Dim>(points_in(triangulation)).hash());
  }
}

// Everywhere in the box, and on and beyond what is there: midpoints of edges and corners of the box.
template <int Dim>
void insert_and_remove(Triangulation<Dim>& triangulation, Random& random) {
  const std::uint64_t before = triangulation.hash();
  const Box<Dim> box = triangulation.gate().box();
  const auto& complex = triangulation.complex();
  for (int i = 0; i < 100; ++i) {
    Point<Dim> p;
    if (i % 2 == 0) {
      for (std::size_t k = 0; k < Dim; ++k) p[k] = uniform(random, box.low[k], box.high[k]);
      if (i % 10 == 0) p[0] = box.high[0];
    } else {
      const Vertex u(static_cast<std::uint32_t>(random() % complex.num_vertices()));
      const Simplex s = complex.incident_simplex(u);
      if (s.is_null()) continue;
      for (std::size_t k = 0; k < Dim; ++k) p[k] = complex.point(u)[k];
      const Vertex w = complex.corner(s, 0);
      for (std::size_t k = 0; k < Dim; ++k) p[k] = (p[k] + complex.point(w)[k]) / 2;
    }
    const auto [vertex, is_new] = triangulation.insert(triangulation.gate().out(p));
    if (!is_new) continue;
    ASSERT_NE(triangulation.hash(), before);
    triangulation.remove(vertex);
    ASSERT_EQ(triangulation.hash(), before);
  }
  expect_valid(triangulation);
}

TYPED_TEST(Removal, UndoesInsertion) {
  constexpr int Dim = TypeParam::value;
  Random random(3);
  for (const Shape shape : kShapes) {
    SCOPED_TRACE(testing::Message() << "shape " << static_cast<int>(shape));
    Triangulation<Dim> triangulation(make_shape<Dim>(shape, 300, random));
    ASSERT_NO_FATAL_FAILURE(insert_and_remove(triangulation, random));
  }
}

TEST(RemovalCorpus, UndoesInsertionIntoTheModelsOfThePaper) {
  Random random(4);
  for (const auto& file : data_files(SINKMESH_TEST_MODELS)) {
    SCOPED_TRACE(file);
    if (file.extension() == ".poly") {
      Triangulation2 triangulation(read_points<2>(file.string()));
      ASSERT_NO_FATAL_FAILURE(insert_and_remove(triangulation, random));
    } else {
      Triangulation3 triangulation(read_points<3>(file.string()));
      ASSERT_NO_FATAL_FAILURE(insert_and_remove(triangulation, random));
    }
  }
}

// The star of the center of a ball, and of the apex of a cone over a grid, have more simplices than any flip.
TYPED_TEST(Removal, OfACenterWithManyNeighbours) {
  constexpr int Dim = TypeParam::value;
  Random random(5);
  auto points = make_shape<Dim>(Shape::kSphere, 700, random);
  const std::uint64_t hollow = Triangulation<Dim>(points).hash();
  points.emplace_back(Point<Dim>{});
  Triangulation<Dim> triangulation(points);
  triangulation.remove(Vertex(static_cast<std::uint32_t>(points.size() - 1)));
  expect_valid(triangulation);
  EXPECT_EQ(triangulation.hash(), hollow);
}

// All neighbours of the tip lie in one plane; what is on the other side of it says which way is up.
TYPED_TEST(Removal, OfTheTipOfAPyramidUsesAVertexBelow) {
  constexpr int Dim = TypeParam::value;
  for (const double height : {0.5, 100.0}) {
    std::vector<Point<Dim>> points;
    for (int x = 0; x < 4; ++x) {
      for (int y = 0; y < (Dim == 2 ? 1 : 4); ++y) {
        Point<Dim> p{};
        p[0] = x;
        if constexpr (Dim == 3) p[1] = y;
        points.push_back(p);
      }
    }
    Point<Dim> tip;
    tip.fill(1.25);
    tip[Dim - 1] = height;
    Point<Dim> below = tip;
    below[Dim - 1] = -height;
    points.push_back(below);
    const std::uint64_t without = Triangulation<Dim>(points).hash();
    points.push_back(tip);
    Triangulation<Dim> triangulation(points);
    triangulation.remove(Vertex(static_cast<std::uint32_t>(points.size() - 1)));
    expect_valid(triangulation);
    EXPECT_EQ(triangulation.hash(), without);
    // Now the other tip: nothing would be left but the plane.
    EXPECT_THROW(triangulation.remove(Vertex(static_cast<std::uint32_t>(points.size() - 2))), DegenerateInput);
    EXPECT_EQ(triangulation.hash(), without);
  }
}

TYPED_TEST(Removal, OfWhatIsNotThereIsRefused) {
  constexpr int Dim = TypeParam::value;
  std::vector<Point<Dim>> points(Dim + 3);
  for (std::size_t k = 0; k < Dim; ++k) points[k + 1][k] = 1;
  points[Dim + 1].fill(0.75);
  points[Dim + 2] = points[1];
  Triangulation<Dim> triangulation(points);
  EXPECT_THROW(triangulation.remove(Vertex(Dim + 2)), InputError);  // a copy
  EXPECT_THROW(triangulation.remove(Vertex(Dim + 3)), InputError);
  EXPECT_THROW(triangulation.remove(Vertex()), InputError);
  EXPECT_THROW(triangulation.remove(Vertex::infinite()), InputError);
  triangulation.remove(Vertex(Dim + 1));
  EXPECT_THROW(triangulation.remove(Vertex(Dim + 1)), InputError);
  // It can be inserted again, under another id.
  const auto [vertex, is_new] = triangulation.insert(points[Dim + 1]);
  EXPECT_TRUE(is_new);
  EXPECT_EQ(vertex, Vertex(Dim + 3));
}

}  // namespace
}  // namespace sinkmesh
