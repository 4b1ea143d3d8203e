// SPDX-License-Identifier: MIT
//
// The Flower Lemma [EG01, 4.2] as a property of every insertion.
#include <gtest/gtest.h>

#include <cmath>

#include "core/triangulation.h"
#include "test/support/complexes.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class Dimension>
class FlowerLemma : public testing::Test {};
TYPED_TEST_SUITE(FlowerLemma, Dimensions, DimensionNames);

/// Whether y is in a closed circumball, exactly.
template <int Dim>
bool in_ball(const Triangulation<Dim>& triangulation, Simplex s, const PointArg<Dim>& y) {
  std::vector<Point<Dim>> points;
  for (const Point<Dim>* p : triangulation.complex().corners(s)) points.push_back(*p);
  points.push_back(y);
  return exact_in_sphere<Dim>(ExactPoints<Dim>(points)).sign() >= 0;
}

/// Random points in the circumball of a simplex, centres in doubles: the callers check membership exactly.
template <int Dim>
Point<Dim> random_point_in_box_of_ball(const Triangulation<Dim>& triangulation, Simplex s, Random& random) {
  const auto corners = triangulation.complex().corners(s);
  double m[Dim][Dim + 1];  // 2 (p_i - p_0) . c = |p_i - p_0|^2
  for (std::size_t i = 0; i < Dim; ++i) {
    m[i][Dim] = 0;
    for (std::size_t k = 0; k < Dim; ++k) {
      m[i][k] = (*corners[i + 1])[k] - (*corners[0])[k];
      m[i][Dim] += m[i][k] * m[i][k] / 2;
    }
  }
  for (std::size_t i = 0; i < Dim; ++i) {
    std::size_t pivot = i;
    for (std::size_t j = i + 1; j < Dim; ++j) pivot = std::abs(m[j][i]) > std::abs(m[pivot][i]) ? j : pivot;
    for (std::size_t k = 0; k <= Dim; ++k) std::swap(m[i][k], m[pivot][k]);
    for (std::size_t j = 0; j < Dim; ++j) {
      if (j == i) continue;
      const double factor = m[j][i] / m[i][i];
      for (std::size_t k = i; k <= Dim; ++k) m[j][k] -= factor * m[i][k];
    }
  }
  double radius = 0;
  Point<Dim> y;
  for (std::size_t k = 0; k < Dim; ++k) {
    const double c = m[k][Dim] / m[k][k];
    radius += c * c;
    y[k] = (*corners[0])[k] + c;
  }
  radius = std::sqrt(radius);
  for (double& c : y) c += radius * uniform(random, -1, 1);
  return y;
}

// Fl Pt x is contained in Fl St x. Sampling cannot prove it, but a wrong prestar or star fails at once. Points
// on a grid as well, where many spheres coincide.
TYPED_TEST(FlowerLemma, PrestarFlowerLiesInsideStarFlower) {
  constexpr int Dim = TypeParam::value;
  std::size_t checked = 0;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    std::vector<Point<Dim>> points = full_grid<Dim>(Dim == 2 ? 6 : 4);
    if (seed % 2 == 0) {
      for (auto& p : points) {
        for (double& c : p) c = uniform(random, 0, 3);
      }
    }
    Triangulation<Dim> triangulation(points);
    // Inside the hull.
    const std::vector<Simplex> all(triangulation.complex().simplices().begin(),
                                   triangulation.complex().simplices().end());
    Simplex s;
    do {
      s = all[random() % all.size()];
    } while (triangulation.complex().is_ghost(s));
    Point<Dim> x{};
    double sum = 0;
    for (const Point<Dim>* p : triangulation.complex().corners(s)) {
      const double weight = uniform(random, 0.1, 1);
      sum += weight;
      for (std::size_t k = 0; k < Dim; ++k) x[k] += weight * (*p)[k];
    }
    for (double& c : x) c /= sum;

    triangulation.announce(x);
    Cavity<Dim> cavity;
    triangulation.grow_prestar(cavity, x, triangulation.locate(x).simplex);
    triangulation.release(cavity);
    std::vector<Point<Dim>> samples;
    for (std::size_t i = 0; i < cavity.num_simplices(); ++i) {
      if (triangulation.complex().is_ghost(cavity.simplex(i))) continue;
      for (int n = 0; n < 40; ++n) {
        const Point<Dim> y = random_point_in_box_of_ball(triangulation, cavity.simplex(i), random);
        if (in_ball(triangulation, cavity.simplex(i), y)) samples.push_back(y);
      }
    }
    triangulation.grow_prestar(cavity, x, triangulation.locate(x).simplex);
    triangulation.substitute_star(cavity, x);
    for (const Point<Dim>& y : samples) {
      bool found = false;
      for (std::size_t i = 0; i < cavity.num_facets() && !found; ++i) {
        ASSERT_FALSE(triangulation.complex().is_ghost(cavity.star(i)));
        found = in_ball(triangulation, cavity.star(i), y);
      }
      EXPECT_TRUE(found);
    }
    checked += samples.size();
  }
  EXPECT_GT(checked, 2000U);
}

}  // namespace
}  // namespace sinkmesh
