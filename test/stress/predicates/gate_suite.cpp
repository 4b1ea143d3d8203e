// SPDX-License-Identifier: MIT
#include "test/stress/predicates/gate_suite.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "predicates/error.h"
#include "predicates/input_gate.h"
#include "test/stress/text.h"

namespace sinkmesh::stress {
namespace {

constexpr int kLowestExponent = -800;  // of the largest coordinate

/// x * 2^exponent to the nearest multiple of 2^-kGridBits, ties to even, by integers.
double rounded(double x, int exponent) {
  if (x == 0) return 0;
  int e = 0;
  const auto m = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &e), 53));  // x = m 2^(e-53)
  const int shift = kGridBits + exponent + e - 53;
  if (shift >= 0) return std::ldexp(static_cast<double>(m), shift - kGridBits);
  if (shift < -60) return 0;
  const std::int64_t floor = m >> -shift;
  const std::int64_t rest = m - (floor << -shift);
  const std::int64_t half = std::int64_t{1} << (-shift - 1);
  const bool up = rest > half || (rest == half && floor % 2 != 0);
  return std::ldexp(static_cast<double>(floor + (up ? 1 : 0)), -kGridBits) + 0.0;
}

template <int Dim>
class GateSuite : public Suite {
 public:
  std::string name() const override { return "gate" + std::to_string(Dim) + "d"; }

  void generate(Random& random, Case& c) override {
    const auto n = static_cast<std::size_t>(test::uniform_int(random, 1, 6));
    const auto [low, high] = exponents(random);
    auto points = test::make_wide_cloud<Dim>(low, high, n, random);
    for (auto& p : points) {
      for (double& x : p) {
        if (random() % 16 == 0) x = random() % 2 == 0 ? 0.0 : -0.0;
        if (random() % 4096 == 0) x = std::numeric_limits<double>::quiet_NaN();
        if (random() % 4096 == 0) x = -HUGE_VAL;
      }
    }
    c.set_points<Dim>(points);
  }

  bool accepts(const Case& c) const override {
    return std::all_of(c.rows.begin(), c.rows.end(), [](const auto& row) { return row.size() == Dim; });
  }

  std::string check(const Case& c, Counters& counters) override {
    const auto points = c.points<Dim>();
    bool finite = true;
    double largest = 0;
    for (const auto& p : points) {
      for (const double x : p) {
        finite = finite && std::isfinite(x);
        largest = std::max(largest, std::abs(x));
      }
    }
    ++counters.comparisons;
    std::optional<InputGate<Dim>> gate;
    try {
      gate.emplace(points);
    } catch (const InputError& error) {
      ++counters.named[0];
      const bool too_small = largest > 0 && largest < std::ldexp(1.0, kLowestExponent);
      return !finite || too_small ? "" : std::string("refused: ") + error.what();
    }
    if (!finite) return "accepted: a coordinate that is not finite";
    const int expected_exponent = largest == 0 ? 0 : -std::ilogb(largest);
    if (gate->exponent() != expected_exponent) return differ("exponent", gate->exponent(), expected_exponent);
    return check_points(*gate, points, counters);
  }

  std::vector<NamedCounter> counters() const override {
    return {{"refused", 0.0005}, {"rounded", 0.05}, {"unchanged", 0.05}};
  }

 private:
  static std::pair<int, int> exponents(Random& random) {
    switch (random() % 4) {
      case 0:
        return {-1074, 1023};
      case 1:
        return {-900, -780};
      case 2:
        return {-85, 5};
      default:
        return {-40, 45};
    }
  }

  static std::string check_points(const InputGate<Dim>& gate, const std::vector<Point<Dim>>& points,
                                  Counters& counters) {
    std::size_t num_rounded = 0;
    Box<Dim> box;
    for (const auto& p : points) {
      Point<Dim> expected;
      bool changed = false;
      for (std::size_t k = 0; k < Dim; ++k) {
        expected[k] = rounded(p[k], gate.exponent());
        changed = changed || std::ldexp(expected[k], -gate.exponent()) != p[k];
        const double units = std::ldexp(expected[k], gate.granularity());
        if (units != std::nearbyint(units)) return differ("granularity", gate.granularity(), text(p));
      }
      ++counters.comparisons;
      if (!gate.admits(p)) return "not admitted: " + text(p);
      const Point<Dim> gated = gate.in(p);
      if (!same_bits(gated, expected)) return differ("gated", text(gated), text(expected));
      if (!changed && gate.out(gated) != p) return differ("back", text(gate.out(gated)), text(p));
      num_rounded += changed ? 1U : 0U;
      box.include(expected);
    }
    if (gate.granularity() > kGridBits) return differ("granularity", gate.granularity(), kGridBits);
    if (gate.rounded_points() != num_rounded)
      return differ("number of rounded points", gate.rounded_points(), num_rounded);
    if (!points.empty() && (gate.box().low != box.low || gate.box().high != box.high)) return "box: wrong";
    ++counters.named[num_rounded > 0 ? 1 : 2];
    return "";
  }

  static bool same_bits(const Point<Dim>& p, const Point<Dim>& q) {
    return std::equal(p.begin(), p.end(), q.begin(), [](double x, double y) {
      return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    });
  }
};

}  // namespace

template <int Dim>
std::unique_ptr<Suite> make_gate_suite() {
  return std::make_unique<GateSuite<Dim>>();
}
template std::unique_ptr<Suite> make_gate_suite<2>();
template std::unique_ptr<Suite> make_gate_suite<3>();

}  // namespace sinkmesh::stress
