// SPDX-License-Identifier: MIT
//
// Powers, vectors to circumcenters and normals against exact integers.
#include "predicates/constructions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "predicates/input_gate.h"
#include "test/support/clouds.h"
#include "test/support/dimensions.h"
#include "test/support/exact_center.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class T>
class ConstructionsTest : public testing::Test {};
TYPED_TEST_SUITE(ConstructionsTest, PlaneAndSpace, DimensionName);

template <int Dim>
std::vector<Point<Dim>> gated_cloud(Cloud kind, Random& random) {
  std::vector<Point<Dim>> points = make_cloud<Dim>(kind, Dim + 2, random);
  const InputGate<Dim> gate(points);
  for (auto& p : points) p = gate.in(p);
  return points;
}

template <int Dim>
Corners<Dim> corners(const std::vector<Point<Dim>>& points) {
  Corners<Dim> s;
  for (std::size_t i = 0; i <= Dim; ++i) s[i] = &points[i];
  return s;
}

TYPED_TEST(ConstructionsTest, PowerIsTheExactOneRounded) {
  constexpr int kDim = TypeParam::value;
  Random random(1);
  std::size_t zeros = 0;
  std::size_t checked = 0;
  for (const Cloud kind : kAllClouds) {
    for (int trial = 0; trial < 400; ++trial) {
      const auto points = gated_cloud<kDim>(kind, random);
      const ExactPoints<kDim> p(points);
      if (exact_volume<kDim>(p, 0) == 0) continue;
      const mpq_class exact = exact_power<kDim>(p);
      const double value = power<kDim>(corners<kDim>(points), points[kDim + 1]);
      ++checked;
      if (exact == 0) {
        ++zeros;
        ASSERT_EQ(value, 0);
        ASSERT_FALSE(std::signbit(value));
      } else {
        const mpq_class error = (mpq_class(value) - exact) / exact;
        ASSERT_LT(std::abs(error.get_d()), 0x1p-52);
      }
      ASSERT_EQ(power<kDim>(corners<kDim>(points), points[trial % (kDim + 1)]), 0);
    }
  }
  EXPECT_GT(checked, 2000U);
  EXPECT_GT(zeros, 100U);
}

TYPED_TEST(ConstructionsTest, VectorToTheCircumcenterAndRadiusAreTheExactOnesRounded) {
  constexpr int kDim = TypeParam::value;
  Random random(2);
  for (const Cloud kind : kAllClouds) {
    for (int trial = 0; trial < 300; ++trial) {
      auto points = gated_cloud<kDim>(kind, random);
      if (trial % 3 == 0) points[kDim + 1] = {};
      const ExactPoints<kDim> p(points);
      const double radius2 = circumradius2<kDim>(corners<kDim>(points));
      if (exact_volume<kDim>(p, 0) == 0) {
        ASSERT_EQ(radius2, HUGE_VAL);
        continue;
      }
      const auto vector = exact_vector_to_center<kDim>(p, kDim + 1);
      const Point<kDim> value = vector_to_circumcenter<kDim>(corners<kDim>(points), points[kDim + 1]);
      mpq_class exact_radius2 = 0;
      for (const mpq_class& x : exact_vector_to_center<kDim>(p, 0)) exact_radius2 += x * x;
      ASSERT_LE(std::abs(mpq_class(radius2 / exact_radius2 - 1).get_d()), 0x1p-49);
      const double reach = std::sqrt(exact_radius2.get_d());
      for (std::size_t k = 0; k < kDim; ++k) {
        const mpq_class error = mpq_class(value[k]) - vector[k];
        ASSERT_LE(std::abs(error.get_d()), 0x1p-52 * std::abs(vector[k].get_d()) + 0x1p-98 * reach);
      }
    }
  }
}

TYPED_TEST(ConstructionsTest, NormalHasExactSignsAndPointsOutward) {
  constexpr int kDim = TypeParam::value;
  Random random(3);
  for (const Cloud kind : kAllClouds) {
    for (int trial = 0; trial < 300; ++trial) {
      const auto points = gated_cloud<kDim>(kind, random);
      const ExactPoints<kDim> p(points);
      FacetCorners<kDim> facet;
      for (std::size_t i = 0; i < kDim; ++i) facet[i] = &points[i];
      const Point<kDim> normal = facet_normal<kDim>(facet);
      const auto exact = exact_normal<kDim>(p);
      for (std::size_t k = 0; k < kDim; ++k) {
        const mpq_class& n = exact[k];
        if (n == 0) {
          ASSERT_EQ(normal[k], 0);
          ASSERT_FALSE(std::signbit(normal[k]));
        } else {
          const mpq_class error = (mpq_class(normal[k]) - n) / n;
          ASSERT_LT(std::abs(error.get_d()), 0x1p-52);
        }
      }
    }
  }
}

TEST(InputGate, AdmitsWhatPredicatesAreExactFor) {
  const InputGate<2> gate(std::vector<Point2>{{3, 0}, {0, -1}});  // scaled by 1/2
  EXPECT_TRUE(gate.admits({3.999, -3.999}));
  EXPECT_FALSE(gate.admits({4, 0}));
  EXPECT_FALSE(gate.admits({0, -HUGE_VAL}));
  EXPECT_FALSE(gate.admits({std::nan(""), 0}));
}

}  // namespace
}  // namespace sinkmesh
