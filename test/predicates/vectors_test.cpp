// SPDX-License-Identifier: MIT
//
// The worked examples of [PS, 12], by hand and by formula verified apart from this code.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

#include "predicates/circumcenter.h"
#include "predicates/predicates.h"

namespace sinkmesh {
namespace {

using Tet = std::array<Point3, 4>;
using Signs = std::array<int, 4>;

/// The facet opposite corner i of a tetrahedron.
std::array<Point3, 3> facet(const Tet& t, std::size_t i) {
  return {t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]};
}
Signs diametral_sides(const Tet& t) {
  Signs s{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto f = facet(t, i);
    s[i] = diametral_side(f[0], f[1], f[2], t[i]);
  }
  return s;
}
Signs flow_sides(const Tet& t) {
  Signs s{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto f = facet(t, i);
    s[i] = diametral_side_sos(f[0], f[1], f[2], t[i]);
  }
  return s;
}

TEST(Orientation, IsPositiveForTheUnitSimplex) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), -1);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}), 0);
}

struct FlowExample {
  Tet tet;
  int volume;
  Signs unperturbed;
  Signs perturbed;
};
const std::vector<FlowExample> kFlowExamples = {
    {{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1}}}, 1, {1, 1, 1, -1}, {1, 1, 1, -1}},
    {{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}}, 1, {-1, 1, 1, 1}, {-1, 1, 1, 1}},
    {{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 5}}}, 1, {0, 1, 1, 1}, {1, 1, 1, 1}},
    {{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}}, 1, {1, 0, 0, 1}, {1, -1, -1, 1}},
    {{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}}, -1, {1, 1, 1, 1}, {1, 1, 1, 1}},
    {{{{1000000, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, -1, -1}}}, -1, {1, -1, -1, 1}, {1, -1, -1, 1}},
    {{{{1, 0, 1}, {-1, 0, 1}, {0, 1, -1}, {0, -1, -1}}}, 1, {1, 1, 1, 1}, {1, 1, 1, 1}}};

TEST(Flow, HasTheSignsOfTheWorkedExamples) {
  for (const FlowExample& e : kFlowExamples) {
    const auto& [a, b, c, d] = e.tet;
    EXPECT_EQ(orient3d(a, b, c, d), e.volume);
    EXPECT_EQ(diametral_sides(e.tet), e.unperturbed);
  }
}

// The examples rank by number; the library ranks by coordinates. The numbers of these three are in that order.
TEST(Flow, HasThePerturbedSignsOfTheWorkedExamples) {
  for (const FlowExample& e : kFlowExamples) {
    if (e.unperturbed[0] * e.unperturbed[1] * e.unperturbed[2] * e.unperturbed[3] != 0) {
      EXPECT_EQ(flow_sides(e.tet), e.unperturbed);
    }
  }
  EXPECT_EQ(flow_sides(kFlowExamples[3].tet), kFlowExamples[3].perturbed);
  // Facet (0,1,7) of the cube, opposite 3; facet (0,3,7), opposite 1: both flow.
  const Point3 p0{0, 0, 0}, p1{0, 0, 1}, p3{0, 1, 1}, p7{1, 1, 1};
  EXPECT_EQ(diametral_side(p0, p1, p7, p3), 0);
  EXPECT_EQ(diametral_side_sos(p0, p1, p7, p3), -1);
  EXPECT_EQ(diametral_side(p0, p3, p7, p1), 0);
  EXPECT_EQ(diametral_side_sos(p0, p3, p7, p1), -1);
}

struct InsphereExample {
  Tet tet;
  Point3 x;
  int unperturbed;
  int perturbed;
};

TEST(Insphere, HasTheSignsOfTheWorkedExamples) {
  const std::vector<InsphereExample> examples = {
      {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {1, 1, 1}, 0, -1},
      {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {1, 1, 0}, 0, -1},
      {{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}}, {1, 1, 1}, 1, 1},
      {{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}}, {5, 5, 5}, -1, -1}};
  for (const InsphereExample& e : examples) {
    const auto& [a, b, c, d] = e.tet;
    EXPECT_EQ(orient3d(a, b, c, d), 1);
    EXPECT_EQ(insphere(a, b, c, d, e.x), e.unperturbed);
    EXPECT_EQ(insphere_sos(a, b, c, d, e.x), e.perturbed);
  }
  EXPECT_EQ(insphere({3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {2, 2, 1}, {-1, 2, 2}), 0);
  // Ranked first by its coordinates, the query point is not in conflict.
  EXPECT_EQ(insphere_sos({3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {2, 2, 1}, {-1, 2, 2}), -1);
}

TEST(Orthogonality, HasTheSignsOfTheWorkedExamples) {
  const Tet s{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}};
  EXPECT_EQ(orthogonality(s, {{{3, 1, 1}, {5, 1, 1}, {3, 3, 1}, {3, 1, 3}}}), 1);
  EXPECT_EQ(orthogonality(s, {{{2, 0, 0}, {4, 0, 0}, {2, 2, 0}, {2, 0, 2}}}), -1);
  EXPECT_EQ(orthogonality(s, {{{2, 2, 0}, {0, 2, 0}, {2, 4, 0}, {2, 2, 2}}}), -1);  // negative volume
  EXPECT_EQ(orthogonality(s, s), -1);
}

TEST(Orthogonality, RecognizesOrthogonalSpheres) {
  // Squared radii 9 and 9, squared distance of the centers 18.
  const Tet s{{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {-1, -2, -2}}};
  Tet t = s;
  for (Point3& p : t) p = {p[0] + 4, p[1] + 1, p[2] + 1};
  EXPECT_EQ(orthogonality(s, t), 0);
  const std::array<Point2, 3> u{{{5, 0}, {3, 4}, {-4, -3}}};
  std::array<Point2, 3> v = u;
  for (Point2& p : v) p = {p[0] + 7, p[1] + 1};
  EXPECT_EQ(orthogonality(u, v), 0);
}

// The unit cube, numbered 4x + 2y + z, has one sink; the flow of the other tetrahedra is that of the table.
TEST(Flow, LeavesOneSinkInTheUnitCube) {
  const auto corner = [](int i) {
    return Point3{static_cast<double>(i / 4), static_cast<double>(i / 2 % 2), static_cast<double>(i % 2)};
  };
  struct Row {
    std::array<int, 4> tet;
    std::vector<int> apexes;  // opposite the facets with outflow
  };
  const std::vector<Row> rows = {{{0, 1, 2, 4}, {0}},    {{1, 3, 4, 5}, {5}}, {{2, 3, 4, 6}, {6}},
                                 {{3, 4, 5, 6}, {5, 6}}, {{3, 5, 6, 7}, {7}}, {{1, 2, 3, 4}, {}}};
  for (const Row& row : rows) {
    Tet t;
    for (std::size_t i = 0; i < 4; ++i) t[i] = corner(row.tet[i]);
    const Signs s = flow_sides(t);
    for (std::size_t i = 0; i < 4; ++i) {
      const bool flows = std::find(row.apexes.begin(), row.apexes.end(), row.tet[i]) != row.apexes.end();
      EXPECT_EQ(s[i], flows ? -1 : 1) << row.tet[0] << row.tet[1] << row.tet[2] << row.tet[3] << " "
                                      << row.tet[i];
    }
    // Its six tetrahedra are Delaunay: no corner of the cube is in conflict.
    auto [a, b, c, d] = t;
    if (orient3d(a, b, c, d) < 0) std::swap(a, b);
    for (int i = 0; i < 8; ++i) {
      if (std::find(row.tet.begin(), row.tet.end(), i) == row.tet.end()) {
        EXPECT_EQ(insphere_sos(a, b, c, d, corner(i)), -1);
      }
    }
  }
}

TEST(Flow, SeparatesNeighbouringDoublesOfTheWorkedExamples) {
  const Point3 a{0.1, 0.2, 0.3}, b{1.1, 0.7, 0.4}, c{0.5, 1.3, 0.9};
  struct Row {
    double x, y;
    std::vector<double> inside, outside;
  };
  const std::vector<Row> rows = {{0x1.b22deb6708457p-1,
                                  0x1.726c903118156p-1,
                                  {0x1.17eb82fa04b69p+0, 0x1.17eb82fa04b6ap+0},
                                  {0x1.17eb82fa04b6bp+0, 0x1.17eb82fa04b6cp+0, 0x1.17eb82fa04b6dp+0}},
                                 {0x1.5600335598882p-1,
                                  0x1.2c6f6e2e57b75p+0,
                                  {0x1.00e014f5a8c74p+0, 0x1.00e014f5a8c75p+0},
                                  {0x1.00e014f5a8c76p+0, 0x1.00e014f5a8c77p+0, 0x1.00e014f5a8c78p+0}},
                                 {0x1.5f37f8f0f0818p-1,
                                  0x1.0c2c3a8ea3ceap+0,
                                  {0x1.17eb82fa04b69p+0, 0x1.17eb82fa04b6ap+0, 0x1.17eb82fa04b6bp+0},
                                  {0x1.17eb82fa04b6cp+0, 0x1.17eb82fa04b6dp+0}}};
  for (const Row& row : rows) {
    for (const double z : row.inside) EXPECT_EQ(diametral_side(a, b, c, {row.x, row.y, z}), -1);
    for (const double z : row.outside) EXPECT_EQ(diametral_side(a, b, c, {row.x, row.y, z}), 1);
  }
}

TEST(Circumcenter, IsThatOfTheWorkedExamples) {
  const auto center_of = [](const Tet& t) {
    Point3 z{9, 9, 9};
    EXPECT_TRUE(circumcenter({&t[0], &t[1], &t[2], &t[3]}, z));
    return z;
  };
  EXPECT_EQ(center_of({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}}), (Point3{2, 2, 2}));
  EXPECT_EQ(center_of({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}}), (Point3{0.5, 0.5, 0.5}));
  EXPECT_EQ(center_of({{{1, 0, 1}, {-1, 0, 1}, {0, 1, -1}, {0, -1, -1}}}), (Point3{0, 0, 0}));
  EXPECT_EQ(center_of({{{0, 0, 0}, {0.25, 0, 0}, {0, 0.25, 0}, {0.0625, 0.0625, 0.0625}}}),
            (Point3{0.125, 0.125, -0.15625}));
}

}  // namespace
}  // namespace sinkmesh
