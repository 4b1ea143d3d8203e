// SPDX-License-Identifier: MIT
//
// What must hold for one set of points of one polynomial.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "predicates/detail/stages.h"
#include "test/stress/predicates/calls.h"
#include "test/stress/predicates/regimes.h"
#include "test/stress/predicates/symmetries.h"
#include "test/stress/suite.h"
#include "test/stress/text.h"
#include "test/support/exact_signs.h"
#include "test/support/integer_signs.h"

namespace sinkmesh::stress {

/// Places in Counters::named.
constexpr std::size_t raw_counter(detail::Stage stage) { return static_cast<std::size_t>(stage); }
constexpr std::size_t staged_counter(detail::Stage stage) {
  return detail::kStages + static_cast<std::size_t>(stage);
}
inline constexpr std::size_t kFirstOrderCounter = 2 * detail::kStages;

/// Every failure is a CheckFailed.
template <class P>
class SignCheck {
 public:
  static constexpr int kDim = static_cast<int>(P::kDim);
  static constexpr bool kIsPerturbed =
      kIsInSphere<P> || std::is_same_v<P, Diametral<kDim>>;  // there is a function with a tie rule

  /// @param choice  random bits, for what is not done with every case.
  SignCheck(std::vector<Point<kDim>> points, std::uint64_t choice, Counters& counters)
      : points_(std::move(points)), choice_(choice), counters_(counters) {
    for (std::size_t i = 0; i < P::kPoints; ++i) p_[i] = &points_[i];
  }

  /// Anything finite: an integer stage answers right or not at all.
  void run_beyond() {
    const int s64 = detail::by_integers<P, detail::kBits64>(p_);
    const int s128 = detail::by_integers<P, detail::kBits128>(p_);
    counters_.comparisons += 2;
    if (s64 == detail::kUndecided && s128 == detail::kUndecided) return;
    // Whatever the integer stages can do, the oracle can.
    if (kIsOrthogonality<P> && has_flat_simplex()) return;
    exact_ = test::integer_sign<P>(p_);
    if (s64 != detail::kUndecided) expect_equal("stage integer64", s64, exact_);
    if (s128 != detail::kUndecided) expect_equal("stage integer128", s128, exact_);
  }

  void run(bool is_gated) {
    if (kIsOrthogonality<P> && has_flat_simplex()) return;
    const auto integers = test::to_integers(p_);
    exact_ = test::integer_sign(P{}, integers);
    value_sign_ = exact_;
    if constexpr (kIsOrthogonality<P>) {
      value_sign_ *= test::volume(integers, 0).sign() * test::volume(integers, kDim + 1).sign();
    }
    if (exact_ == 0 && !kIsPerturbed) ++counters_.ties;
    check_raw();
    check_stages(is_gated);
    check_symmetries();
    check_laws();
    const std::optional<GatedSet> set = gated_set();
    if (set) check_staged(*set);
    if constexpr (kIsPerturbed) check_perturbed(integers, set);
  }

 private:
  struct GatedSet {
    std::vector<Point<kDim>> points;
    Predicates<kDim> predicates;
    int granularity;
  };

  void expect(const char* kind, int found, int expected) {
    ++counters_.comparisons;
    if (found != expected) expect_equal(kind, found, expected);
  }
  void expect_if_decided(const char* kind, int found) {
    ++counters_.comparisons;
    if (found != detail::kUndecided && found != exact_) expect_equal(kind, found, exact_);
  }

  bool has_flat_simplex() const {
    if constexpr (kIsOrthogonality<P>) {
      const auto integers = test::to_integers(p_);
      return test::volume(integers, 0).sign() == 0 || test::volume(integers, kDim + 1).sign() == 0;
    }
    return false;
  }

  void check_raw() {
    const detail::Verdict verdict = detail::decide<P>(p_);
    ++counters_.named[raw_counter(verdict.stage)];
    expect("raw verdict", verdict.sign, exact_);
    expect("raw", raw_sign(P{}, p_), value_sign_);
  }

  void check_stages(bool is_gated) {
    const auto v = detail::rounded_vectors<P>(p_);
    const double value = P::value(v);
    expect_if_decided("stage local", detail::by_error(value, detail::local_error<P>(v)));
    expect_if_decided("stage permanent", detail::by_error(value, detail::permanent_error<P>(v)));
    expect_if_decided("stage box", detail::by_box<P>(p_));
    expect_if_decided("stage integer64", detail::by_integers<P, detail::kBits64>(p_));
    const int s128 = detail::by_integers<P, detail::kBits128>(p_);
    expect_if_decided("stage integer128", s128);
    if (is_gated && s128 == detail::kUndecided) expect_equal("stage integer128 behind the gate", s128, exact_);
    const int first_order = detail::by_first_order<P>(p_);
    expect_if_decided("stage first order", first_order);
    if (first_order != detail::kUndecided) ++counters_.named[kFirstOrderCounter];
    expect("stage expansions", detail::by_expansions<P>(p_), exact_);
  }

  /// All of them for one case in 16, six for the others.
  void check_symmetries() {
    static const auto kAll = symmetries(P{});
    const std::size_t n = kAll.size();
    const std::size_t some = choice_ % 16 == 0 ? n : std::min<std::size_t>(n, 6);
    for (std::size_t i = 0; i < some; ++i) {
      const auto& symmetry = kAll[(choice_ / 16 + i * (n / some)) % n];
      const auto permuted = symmetry(p_);
      expect("permuted", raw_sign(P{}, permuted), kIsOrthogonality<P> ? value_sign_ : symmetry.sign * exact_);
      expect("permuted verdict", detail::decide<P>(permuted).sign, symmetry.sign * exact_);
    }
  }

  /// Maps of the plane and of space that keep the sign, or change it.
  void check_laws() {
    constexpr bool kOdd = kIsInSphere<P> || std::is_same_v<P, Orientation<kDim>>;
    const auto expect_mapped = [&](const char* kind, const std::vector<Point<kDim>>& mapped, int expected) {
      if (!in_range(mapped, P::kDegree)) return;
      Points<P> q;
      for (std::size_t i = 0; i < P::kPoints; ++i) q[i] = &mapped[i];
      expect(kind, raw_sign(P{}, q), expected);
    };
    auto mapped = points_;
    const int e = static_cast<int>(choice_ >> 32 & 127) - 64;
    for (auto& p : mapped) {
      for (double& x : p) x = std::ldexp(x, e);
    }
    expect_mapped("scaled by a power of two", mapped, value_sign_);

    mapped = points_;
    const std::size_t axis = choice_ >> 40 & 1;
    for (auto& p : mapped) p[axis] = 0 - p[axis];
    expect_mapped("mirrored", mapped, kOdd ? -value_sign_ : value_sign_);

    mapped = points_;
    for (auto& p : mapped) std::swap(p[0], p[1]);
    expect_mapped("axes exchanged", mapped, kOdd ? -value_sign_ : value_sign_);

    mapped = points_;
    const double offset = choice_ >> 41 & 1 ? points_[0][0] : std::ldexp(1.0, e);
    bool is_exact = true;
    for (auto& p : mapped) {
      for (double& x : p) {
        const double sum = x + offset;
        is_exact = is_exact && sum - x == offset && sum - offset == x;
        x = sum;
      }
    }
    if (is_exact) expect_mapped("translated", mapped, value_sign_);
  }

  /// Behind the gate, if it does not round: tight; in a large box; or included one by one.
  std::optional<GatedSet> gated_set() const {
    if (!in_gate_range()) return std::nullopt;
    const InputGate<kDim> gate(points_);
    if (gate.rounded_points() != 0) return std::nullopt;
    auto points = points_;
    for (auto& p : points) p = gate.in(p);
    Box<kDim> box = gate.box();
    switch (choice_ >> 42 & 3) {
      case 0: {
        Predicates<kDim> predicates(Box<kDim>{}, 0);
        for (const auto& p : points) predicates.include(p);
        return GatedSet{std::move(points), predicates, gate.granularity()};
      }
      case 1: {
        Point<kDim> corner;
        corner.fill(2);
        box.include(corner);
        corner.fill(-2);
        box.include(corner);
        break;
      }
      default:
        break;
    }
    return GatedSet{std::move(points), Predicates<kDim>(box, gate.granularity()), gate.granularity()};
  }

  /// The gate refuses sets that are too small for it.
  bool in_gate_range() const {
    double largest = 0;
    for (const auto& p : points_) {
      for (const double x : p) largest = std::max(largest, std::abs(x));
    }
    return largest == 0 || largest >= 0x1p-800;
  }

  void check_staged(const GatedSet& set) {
    const Points<P> q = pointers(set);
    const detail::Verdict verdict = set.predicates.template verdict<P>(q);
    ++counters_.named[staged_counter(verdict.stage)];
    expect("staged verdict", verdict.sign, exact_);
    expect("staged", staged_sign(P{}, set.predicates, q), value_sign_);
    const auto v = detail::rounded_vectors<P>(q);
    const int bits = P::kDegree * set.granularity;
    if (bits > 1022) return;
    const double unit = std::ldexp(1.0, -bits);
    expect_if_decided("stage granularity",
                      detail::by_granularity(P::value(v), detail::permanent_error<P>(v), unit));
  }

  static Points<P> pointers(const GatedSet& set) {
    Points<P> q;
    for (std::size_t i = 0; i < P::kPoints; ++i) q[i] = &set.points[i];
    return q;
  }

  /// The answer at a tie, by real weights that are tiny enough; requires a positive volume.
  static int exact_perturbed(const Points<P>& p) {
    std::vector<Point<kDim>> points;
    for (const Point<kDim>* q : p) points.push_back(*q);
    const test::ExactPoints<kDim> exact(points);
    if constexpr (kIsInSphere<P>) {
      return test::exact_in_sphere<kDim>(exact, true).sign();
    } else {
      return test::exact_perturbed_flow<kDim>(exact);
    }
  }

  bool are_distinct() const {
    auto sorted = points_;
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  }

  void check_perturbed(const auto& integers, const std::optional<GatedSet>& set) {
    const int volume = test::volume(integers).sign();
    if (volume == 0 || !are_distinct()) return;
    if (exact_ == 0) ++counters_.ties;
    const bool turn = kIsInSphere<P> && volume < 0;
    const auto positive = [&](Points<P> q) {
      if (turn) std::swap(q[0], q[1]);
      return q;
    };
    const Points<P> p = positive(p_);
    const int expected = exact_ != 0 ? (turn ? -exact_ : exact_) : exact_perturbed(p);
    expect("perturbed", raw_sos(P{}, p), expected);
    if (set) expect("perturbed, staged", staged_sos(P{}, set->predicates, positive(pointers(*set))), expected);
    // The answer belongs to the set of corners: even permutations keep a simplex positive.
    static const auto kAll = permutations<P::kPoints>(0, kIsInSphere<P> ? kDim + 1 : kDim, kIsInSphere<P>);
    const std::size_t step = choice_ % 16 == 0 || exact_ == 0 ? 1 : 5;
    for (std::size_t i = choice_ / 16 % step; i < kAll.size(); i += step) {
      if (kAll[i].sign > 0) expect("perturbed, permuted", raw_sos(P{}, kAll[i](p)), expected);
    }
  }

  std::vector<Point<kDim>> points_;
  std::uint64_t choice_;
  Counters& counters_;
  Points<P> p_;
  int exact_ = 0;       // of the polynomial
  int value_sign_ = 0;  // of what the function returns
};

}  // namespace sinkmesh::stress
