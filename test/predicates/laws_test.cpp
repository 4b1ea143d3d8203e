// SPDX-License-Identifier: MIT
//
// Algebraic laws that hold for every input, and so need no oracle.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "predicates/detail/stages.h"
#include "predicates/predicates.h"
#include "test/support/clouds.h"
#include "test/support/polynomial_oracle.h"

namespace sinkmesh {
namespace {

using namespace detail;
using namespace test;

constexpr int kSamplesPerCloud = 60;

/// -1 for odd permutations of 0..n-1.
template <std::size_t N>
int parity(const std::array<std::size_t, N>& order) {
  int sign = 1;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = i + 1; j < N; ++j) {
      if (order[i] > order[j]) sign = -sign;
    }
  }
  return sign;
}

/// Calls visit(points in permuted order, parity) for all permutations of the first kMoved points.
template <class P, std::size_t kMoved, class Visit>
void for_all_permutations(const std::vector<Point<P::kDim>>& points, Visit visit) {
  std::array<std::size_t, kMoved> order;
  std::iota(order.begin(), order.end(), std::size_t{0});
  do {
    auto permuted = points;
    for (std::size_t i = 0; i < kMoved; ++i) permuted[i] = points[order[i]];
    visit(permuted, parity(order));
  } while (std::next_permutation(order.begin(), order.end()));
}

template <class P, class Check>
void for_all_clouds(Check check) {
  Random random(4);
  for (const Cloud kind : kAllClouds) {
    for (int i = 0; i < kSamplesPerCloud; ++i) {
      check(make_cloud<P::kDim>(kind, P::kPoints, random));
      if (::testing::Test::HasFailure()) return;
    }
  }
}

template <class P, std::size_t kMoved>
void expect_antisymmetry() {
  for_all_clouds<P>([](const auto& points) {
    const int sign = public_sign(P{}, points);
    for_all_permutations<P, kMoved>(points, [&](const auto& permuted, int p) {
      EXPECT_EQ(public_sign(P{}, permuted), p * sign);
      EXPECT_EQ((by_integers<P, kBits128>(pointers<P>(permuted))), p * sign);
      EXPECT_EQ(by_expansions<P>(pointers<P>(permuted)), p * sign);
    });
  });
}

TEST(Orient2d, IsAntisymmetric) { expect_antisymmetry<Orientation<2>, 3>(); }
TEST(Orient3d, IsAntisymmetric) { expect_antisymmetry<Orientation<3>, 4>(); }
TEST(Incircle, IsAntisymmetricInAllPoints) { expect_antisymmetry<InSphere<2>, 4>(); }
TEST(Insphere, IsAntisymmetricInAllPoints) { expect_antisymmetry<InSphere<3>, 5>(); }

template <class P>
void expect_symmetry_in_the_facet() {
  for_all_clouds<P>([](const auto& points) {
    const int sign = public_sign(P{}, points);
    const bool is_simplex = exact_volume<P::kDim>(ExactPoints<P::kDim>(points), 0) != 0;
    const int perturbed = is_simplex ? public_sos(points, P{}) : 0;
    for_all_permutations<P, P::kDim>(points, [&](const auto& permuted, int) {
      EXPECT_EQ(public_sign(P{}, permuted), sign);
      if (is_simplex) {
        EXPECT_EQ(public_sos(permuted, P{}), perturbed);
      }
    });
  });
}

TEST(DiametralSide, IsSymmetricInTheEdge) { expect_symmetry_in_the_facet<Diametral<2>>(); }
TEST(DiametralSide, IsSymmetricInTheFacet) { expect_symmetry_in_the_facet<Diametral<3>>(); }

// Even permutations keep the simplex positive; the perturbed answer belongs to the set of its corners.
TEST(InsphereSos, DependsOnTheSetOfCornersOnly) {
  for_all_clouds<InSphere<3>>([](auto points) {
    const int volume = orient3d(points[0], points[1], points[2], points[3]);
    if (volume == 0) return;
    if (volume < 0) std::swap(points[0], points[1]);
    const int sign = public_sos(points, InSphere<3>{});
    for_all_permutations<InSphere<3>, 4>(points, [&](const auto& permuted, int p) {
      if (p > 0) {
        EXPECT_EQ(public_sos(permuted, InSphere<3>{}), sign);
      }
    });
  });
}

// Of two simplices on a common facet, each contains the other's apex or neither does, also at ties.
TEST(InsphereSos, IsTheSameFromBothSidesOfAFacet) {
  for_all_clouds<InSphere<3>>([](const auto& p) {
    const int first = orient3d(p[0], p[1], p[2], p[3]);
    const int second = orient3d(p[0], p[1], p[2], p[4]);
    if (first * second >= 0) return;
    const auto in_sphere = [&](const Point3& apex, int volume, const Point3& x) {
      return volume > 0 ? insphere_sos(p[0], p[1], p[2], apex, x) : insphere_sos(p[1], p[0], p[2], apex, x);
    };
    EXPECT_EQ(in_sphere(p[3], first, p[4]), in_sphere(p[4], second, p[3]));
  });
}

TEST(Flow, CannotLeaveThroughAllFacets) {
  for_all_clouds<Diametral<3>>([](const auto& p) {
    if (orient3d(p[0], p[1], p[2], p[3]) == 0) return;
    const int sum = diametral_side_sos(p[1], p[2], p[3], p[0]) + diametral_side_sos(p[0], p[2], p[3], p[1]) +
                    diametral_side_sos(p[0], p[1], p[3], p[2]) + diametral_side_sos(p[0], p[1], p[2], p[3]);
    EXPECT_GE(sum, -2);
  });
}

template <int Dim>
void expect_symmetric_orthogonality() {
  for_all_clouds<Orthogonality<Dim>>([](const auto& p) {
    std::array<Point<Dim>, Dim + 1> s;
    std::array<Point<Dim>, Dim + 1> t;
    std::copy_n(p.begin(), Dim + 1, s.begin());
    std::copy_n(p.begin() + Dim + 1, Dim + 1, t.begin());
    const int sign = orthogonality(s, t);
    EXPECT_EQ(orthogonality(t, s), sign);
    auto order = std::array<std::size_t, Dim + 1>{};
    std::iota(order.begin(), order.end(), std::size_t{0});
    while (std::next_permutation(order.begin(), order.end())) {
      auto permuted = s;
      for (std::size_t i = 0; i <= Dim; ++i) permuted[i] = s[order[i]];
      EXPECT_EQ(orthogonality(permuted, t), sign);
    }
  });
}

TEST(Orthogonality, IsSymmetricInThePlane) { expect_symmetric_orthogonality<2>(); }
TEST(Orthogonality, IsSymmetricInSpace) { expect_symmetric_orthogonality<3>(); }

template <class P>
class EveryPolynomial : public ::testing::Test {};
using AllPolynomials = ::testing::Types<Orientation<2>, Orientation<3>, InSphere<2>, InSphere<3>, Diametral<2>,
                                        Diametral<3>, Orthogonality<2>, Orthogonality<3>>;
TYPED_TEST_SUITE(EveryPolynomial, AllPolynomials);

TYPED_TEST(EveryPolynomial, KeepsItsSignUnderPowersOfTwo) {
  for_all_clouds<TypeParam>([](const auto& points) {
    const int sign = public_sign(TypeParam{}, points);
    for (const int e : {-20, -3, 1, 17, 50}) {
      auto scaled = points;
      for (auto& p : scaled) {
        for (double& x : p) x = std::ldexp(x, e);
      }
      EXPECT_EQ(public_sign(TypeParam{}, scaled), sign);
    }
  });
}

TYPED_TEST(EveryPolynomial, KeepsItsSignUnderExactTranslation) {
  for_all_clouds<TypeParam>([](const auto& points) {
    const int sign = public_sign(TypeParam{}, points);
    for (const double offset : {1.0, -64.0, 0x1p20}) {
      auto moved = points;
      bool exact = true;
      for (auto& p : moved) {
        for (double& x : p) {
          const TwoTerms sum = two_sum(x, offset);
          exact &= sum.tail == 0;
          x = sum.head;
        }
      }
      if (exact) {
        EXPECT_EQ(public_sign(TypeParam{}, moved), sign);
      }
    }
  });
}

TYPED_TEST(EveryPolynomial, KeepsItsSignUpToParityUnderReflection) {
  constexpr bool kOdd = std::is_same_v<TypeParam, Orientation<TypeParam::kDim>> ||
                        std::is_same_v<TypeParam, InSphere<TypeParam::kDim>>;
  for_all_clouds<TypeParam>([&](const auto& points) {
    auto mirrored = points;
    for (auto& p : mirrored) p[0] = 0.0 - p[0];
    EXPECT_EQ(public_sign(TypeParam{}, mirrored), (kOdd ? -1 : 1) * public_sign(TypeParam{}, points));
  });
}

}  // namespace
}  // namespace sinkmesh
