// SPDX-License-Identifier: MIT
//
// The error bounds of the polynomials, against a count of the roundings that their expressions make. No sample
// comes near the worst case: a bound that is too small would never be noticed by signs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "predicates/detail/stages.h"
#include "predicates/polynomials.h"

namespace sinkmesh::detail {
namespace {

/// Roundings on the longest path to a number: each monomial of it has at most so many factors 1 + d, |d| <= u.
struct Roundings {
  int count = 0;

  friend Roundings operator+(Roundings a, Roundings b) { return {std::max(a.count, b.count) + 1}; }
  friend Roundings operator-(Roundings a, Roundings b) { return a + b; }
  friend Roundings operator*(Roundings a, Roundings b) { return {a.count + b.count + 1}; }
};

/// The same for Dual.
struct DualRoundings {
  Roundings value;
  Roundings slope;

  friend DualRoundings operator+(DualRoundings a, DualRoundings b) {
    return {a.value + b.value, a.slope + b.slope};
  }
  friend DualRoundings operator-(DualRoundings a, DualRoundings b) { return a + b; }
  friend DualRoundings operator*(DualRoundings a, DualRoundings b) {
    return {a.value * b.value, a.value * b.slope + a.slope * b.value};
  }
};

/// The expression of P, where every coordinate of a vector is x.
template <class P, class T>
T value_at(const T& x) {
  Vectors<P, T> v;
  for (auto& vector : v) vector.fill(x);
  return P::value(v);
}

template <class P>
class ErrorBounds : public testing::Test {};

using Polynomials =
    testing::Types<Orientation<2>, Orientation<3>, InSphere<2>, InSphere<3>, Diametral<2>, Diametral<3>,
                   FacetNormals<2>, FacetNormals<3>, Orthogonality<2>, Orthogonality<3>>;
TYPED_TEST_SUITE(ErrorBounds, Polynomials);

// The last rounding does not change the sign. Something is left for terms of second order; not so much that
// calls leave the filter without need.
TYPED_TEST(ErrorBounds, CoverTheRoundingsOfTheFilters) {
  const int count = value_at<TypeParam>(Roundings{1}).count - 1;  // a difference is rounded, too
  EXPECT_GT(TypeParam::kErrorBound, count * kUnit);
  EXPECT_LE(TypeParam::kErrorBound, 2 * count * kUnit);
}

// Differences are exact there, as head and tail. The derivative has the majorant k u Q.
TYPED_TEST(ErrorBounds, CoverTheRoundingsOfTheFirstOrder) {
  constexpr int k = TypeParam::kDegree;
  const int count = value_at<TypeParam>(DualRoundings{}).slope.count;
  EXPECT_LE(count, 60);
  EXPECT_GT(first_order_error<TypeParam>(), (k * (k - 1) / 2.0 + count * k) * kUnit * kUnit);
}

}  // namespace
}  // namespace sinkmesh::detail
