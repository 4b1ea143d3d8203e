// SPDX-License-Identifier: MIT
//
// Every predicate against exact integers: on raw doubles, and behind the gate with the filters of a point set.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "predicates/detail/stages.h"
#include "predicates/input_gate.h"
#include "predicates/predicates.h"
#include "predicates/staged.h"
#include "test/support/clouds.h"
#include "test/support/polynomial_oracle.h"

namespace sinkmesh {
namespace {

using namespace detail;
using namespace test;

constexpr int kSamplesPerCloud = 4400;  // 23 kinds: more than 10^5 per predicate

template <class P>
constexpr bool kIsOrientation = std::is_same_v<P, Orientation<P::kDim>>;

/// All kinds, and more often those that are degenerate for P.
template <class P>
std::vector<Cloud> clouds_for() {
  std::vector<Cloud> kinds(kAllClouds.begin(), kAllClouds.end());
  for (int i = 0; i < 3; ++i) {
    if (kIsOrientation<P>) {
      kinds.insert(kinds.end(), {Cloud::kFlatInteger, Cloud::kFlatScaled, Cloud::kFlatNeighbours});
    } else {
      kinds.insert(kinds.end(), {Cloud::kIntegerSphere, Cloud::kScaledSphere, Cloud::kNeighbours});
    }
  }
  return kinds;
}

struct Tally {
  long total = 0;
  long near = 0;  // within 4 u permanent of zero
  long zero = 0;
  std::array<long, kStages> raw{};
  std::array<long, kStages> staged{};

  void expect_hard_enough() const {
    EXPECT_GE(total, 100000);
    EXPECT_GE(near * 10, total * 3);
    EXPECT_GE(zero * 10, total);
  }
};

/// The predicates of a gated set around the points: tight, or with the points far apart from the rest of it.
template <int Dim>
Predicates<Dim> predicates_around(std::vector<Point<Dim>>& points, Random& random) {
  const InputGate<Dim> gate(points);
  for (auto& p : points) p = gate.in(p);
  Box<Dim> box = gate.box();
  int granularity = gate.granularity();
  if (random() % 3 == 0 && granularity <= kGridBits - 12) {
    for (auto& p : points) {
      for (double& x : p) x *= 0x1p-12;
    }
    granularity += 12;
    Point<Dim> corner;
    corner.fill(1.5);
    box.include(corner);
    corner.fill(-1.5);
    box.include(corner);
  }
  return Predicates<Dim>(box, granularity);
}

/// The functions of a set, unperturbed. Orthogonality: of the value, not of the polynomial.
template <int Dim>
int staged_sign(const Predicates<Dim>& predicates, const std::vector<Point<Dim>>& p, Orientation<Dim>) {
  return predicates.orient(pointers<Orientation<Dim>>(p));
}
template <int Dim>
int staged_sign(const Predicates<Dim>& predicates, const std::vector<Point<Dim>>& p, InSphere<Dim>) {
  return predicates.in_sphere_unperturbed(pointers<Orientation<Dim>>(p), p[Dim + 1]);
}
template <int Dim>
int staged_sign(const Predicates<Dim>& predicates, const std::vector<Point<Dim>>& p, Diametral<Dim>) {
  FacetCorners<Dim> facet;
  for (std::size_t i = 0; i < Dim; ++i) facet[i] = &p[i];
  return predicates.diametral_side(facet, p[Dim]);
}
template <int Dim>
int staged_sign(const Predicates<Dim>& predicates, const std::vector<Point<Dim>>& p, Orthogonality<Dim>) {
  const Points<Orthogonality<Dim>> all = pointers<Orthogonality<Dim>>(p);
  Corners<Dim> s;
  Corners<Dim> t;
  std::copy_n(all.begin(), Dim + 1, s.begin());
  std::copy_n(all.begin() + Dim + 1, Dim + 1, t.begin());
  return predicates.orthogonality(s, t);
}

/// What the functions must return, from the sign of the polynomial.
template <class P>
int function_sign(int sign, const std::vector<Point<P::kDim>>& points) {
  if constexpr (kIsOrthogonality<P>) {
    const ExactPoints<P::kDim> p(points);
    sign *= sgn(exact_volume<P::kDim>(p, 0)) * sgn(exact_volume<P::kDim>(p, P::kDim + 1));
  }
  return sign;
}

template <class P>
Tally compare_with_oracle(std::uint64_t seed) {
  constexpr int kDim = P::kDim;
  Random random(seed);
  Tally tally;
  for (const Cloud kind : clouds_for<P>()) {
    for (int sample = 0; sample < kSamplesPerCloud; ++sample) {
      auto points = make_cloud<kDim>(kind, P::kPoints, random);
      if (!in_domain<P>(points)) {
        points = make_cloud<kDim>(Cloud::kUniform, P::kPoints, random);
      }
      const ExactValue exact = exact_value<P>(points);
      const Verdict raw = decide<P>(pointers<P>(points));
      ++tally.total;
      ++tally.raw[static_cast<std::size_t>(raw.stage)];
      tally.zero += exact.sign == 0;
      tally.near += exact.magnitude <= 4 * kUnit * permanent_of<P>(rounded_vectors<P>(pointers<P>(points)));
      EXPECT_EQ(raw.sign, exact.sign) << "kind " << static_cast<int>(kind) << " sample " << sample;
      const int expected = function_sign<P>(exact.sign, points);
      EXPECT_EQ(public_sign(P{}, points), expected);

      auto gated = points;
      const Predicates<kDim> predicates = predicates_around<kDim>(gated, random);
      const Verdict staged = predicates.template verdict<P>(pointers<P>(gated));
      ++tally.staged[static_cast<std::size_t>(staged.stage)];
      EXPECT_EQ(staged.sign, exact.sign) << "kind " << static_cast<int>(kind) << " sample " << sample;
      EXPECT_EQ(staged_sign<kDim>(predicates, gated, P{}), expected);
      if (::testing::Test::HasFailure()) return tally;
    }
  }
  return tally;
}

void expect_each_decides(const std::array<long, kStages>& counts, const std::vector<Stage>& stages) {
  constexpr long kFloor = 100;
  for (const Stage s : stages) {
    EXPECT_GE(counts[static_cast<std::size_t>(s)], kFloor) << "stage " << static_cast<int>(s);
  }
}

template <class P>
class OracleTest : public ::testing::Test {};
using AllPolynomials = ::testing::Types<Orientation<2>, Orientation<3>, InSphere<2>, InSphere<3>, Diametral<2>,
                                        Diametral<3>, Orthogonality<2>, Orthogonality<3>>;
TYPED_TEST_SUITE(OracleTest, AllPolynomials);

TYPED_TEST(OracleTest, SignsAreExact) {
  const Tally tally = compare_with_oracle<TypeParam>(1);
  if (this->HasFailure()) return;
  tally.expect_hard_enough();
  std::vector<Stage> raw{Stage::kLocal, Stage::kPermanent, Stage::kInteger64, Stage::kInteger128};
  std::vector<Stage> staged{Stage::kStatic,      Stage::kLocal,     Stage::kPermanent,
                            Stage::kGranularity, Stage::kInteger64, Stage::kInteger128};
  if (requires(const Points<TypeParam>& p) { TypeParam::is_zero(p); }) {
    raw.push_back(Stage::kBox);
    if (!kIsOrientation<TypeParam>) staged.push_back(Stage::kBox);  // there the filters see the zeros
  }
  expect_each_decides(tally.raw, raw);
  expect_each_decides(tally.staged, staged);
}

/// Raw doubles anywhere in the range of [PS, 11], where expansions are needed.
template <class P>
std::pair<int, int> exponent_range() {
  constexpr std::pair<int, int> kRanges[] = {{-485, 509}, {-306, 338}, {-216, 252}, {-162, 201},
                                             {-127, 167}, {0, 0},      {-82, 124}};
  return kRanges[P::kDegree - 2];
}

TYPED_TEST(OracleTest, SignsAreExactOverTheRangeOfExponents) {
  using P = TypeParam;
  constexpr int kDim = P::kDim;
  const auto [low, high] = exponent_range<P>();
  Random random(2);
  std::array<long, kStages> stages{};
  for (int sample = 0; sample < 10000; ++sample) {
    auto points = make_wide_cloud<kDim>(low, high, P::kPoints, random);
    const int exact = exact_value<P>(points).sign;
    if (!in_domain<P>(points)) continue;
    const Verdict v = decide<P>(pointers<P>(points));
    ++stages[static_cast<std::size_t>(v.stage)];
    ASSERT_EQ(v.sign, exact) << sample;
    ASSERT_EQ(by_expansions<P>(pointers<P>(points)), exact) << sample;
    const int first_order = by_first_order<P>(pointers<P>(points));
    ASSERT_TRUE(first_order == exact || first_order == kUndecided) << sample;
  }
  expect_each_decides(stages, {Stage::kLocal, Stage::kPermanent});
  if (P::kDegree > 2 || kIsOrientation<P>) expect_each_decides(stages, {Stage::kExpansion});
}

// --------------------------------------------------------------------------------------------------- perturbed

template <class P>
class PerturbedTest : public ::testing::Test {};
using PerturbedPolynomials = ::testing::Types<InSphere<2>, InSphere<3>, Diametral<2>, Diametral<3>>;
TYPED_TEST_SUITE(PerturbedTest, PerturbedPolynomials);

template <class P>
int exact_perturbed(const std::vector<Point<P::kDim>>& points) {
  const ExactPoints<P::kDim> p(points);
  if constexpr (P::kPoints == P::kDim + 2) {
    return exact_in_sphere<P::kDim>(p, true).sign();
  } else {
    return exact_perturbed_flow<P::kDim>(p);
  }
}

template <int Dim>
int staged_perturbed(const Predicates<Dim>& predicates, const std::vector<Point<Dim>>& p, InSphere<Dim>) {
  Corners<Dim> s;
  for (std::size_t i = 0; i <= Dim; ++i) s[i] = &p[i];
  return predicates.in_sphere(s, p[Dim + 1]);
}
template <int Dim>
int staged_perturbed(const Predicates<Dim>& predicates, const std::vector<Point<Dim>>& p, Diametral<Dim>) {
  FacetCorners<Dim> facet;
  for (std::size_t i = 0; i < Dim; ++i) facet[i] = &p[i];
  return predicates.flow_side(facet, p[Dim]);
}

TYPED_TEST(PerturbedTest, SignsAreThoseOfTinyWeights) {
  using P = TypeParam;
  constexpr int kDim = P::kDim;
  Random random(3);
  long ties = 0;
  for (const Cloud kind : kAllClouds) {
    for (int sample = 0; sample < 1500; ++sample) {
      auto points = make_cloud<kDim>(kind, P::kPoints, random);
      const int volume = sgn(exact_volume<kDim>(ExactPoints<kDim>(points), 0));
      if (volume == 0) continue;
      if (volume < 0) std::swap(points[0], points[1]);
      const int unperturbed = exact_value<P>(points).sign;
      const int exact = exact_perturbed<P>(points);
      ties += unperturbed == 0;
      ASSERT_NE(exact, 0);
      ASSERT_TRUE(unperturbed == 0 || exact == unperturbed);
      ASSERT_EQ(public_sos(points, P{}), exact) << "kind " << static_cast<int>(kind) << " sample " << sample;
      auto gated = points;
      const Predicates<kDim> predicates = predicates_around<kDim>(gated, random);
      ASSERT_EQ(staged_perturbed<kDim>(predicates, gated, P{}), exact);
    }
  }
  EXPECT_GE(ties, 1500);
}

}  // namespace
}  // namespace sinkmesh
