// SPDX-License-Identifier: MIT
#include "test/stress/predicates/center_suite.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "predicates/circumcenter.h"
#include "predicates/constructions.h"
#include "predicates/detail/circumcenter_stages.h"
#include "test/stress/predicates/regimes.h"
#include "test/stress/predicates/symmetries.h"
#include "test/stress/text.h"
#include "test/support/exact_center.h"

namespace sinkmesh::stress {
namespace {

using detail::CenterResult;

/// Rows: the corners of a simplex, and one more point.
template <int Dim>
class CenterSuite : public Suite {
 public:
  std::string name() const override { return "center" + std::to_string(Dim) + "d"; }

  void generate(Random& random, Case& c) override {
    auto points = random() % 16 == 0 ? test::make_wide_cloud<Dim>(-kGridBits, 0, Dim + 2, random)
                                     : make_position<Dim>(Dim + 2, {}, random);
    const InputGate<Dim> gate(points);
    for (auto& p : points) p = gate.in(p);
    if (random() % 4 == 0) points.back() = {};
    c.set_points<Dim>(points);
  }

  bool accepts(const Case& c) const override {
    const auto is_point = [](const auto& row) { return row.size() == Dim; };
    return c.rows.size() == Dim + 2 && std::all_of(c.rows.begin(), c.rows.end(), is_point) &&
           is_gated(c.points<Dim>());
  }

  std::string check(const Case& c, Counters& counters) override {
    const auto points = c.points<Dim>();
    const test::ExactPoints<Dim> exact(points);
    check_normal(points, exact, counters);
    if (test::exact_volume<Dim>(exact, 0) == 0) return "";
    check_center(points, counters);
    check_vector(points, exact, counters);
    check_power(points, exact, counters);
    return "";
  }

  std::vector<NamedCounter> counters() const override {
    return {
        {"inside", 0.2}, {"outside", 0.02}, {"certified", 0.2}, {"uncertified", 0.002}, {"on-sphere", 0.02}};
  }

 private:
  static constexpr double kRelative = 0x1p-52;

  static Corners<Dim> corners(const std::vector<Point<Dim>>& points, const auto& symmetry) {
    Corners<Dim> s;
    for (std::size_t i = 0; i <= Dim; ++i) s[i] = &points[symmetry.order[i]];
    return s;
  }
  static const auto& orders() {
    static const auto kAll = permutations<Dim + 1>(0, Dim + 1, true);
    return kAll;
  }
  static Corners<Dim> corners(const std::vector<Point<Dim>>& points) {
    return corners(points, orders().front());
  }

  static void expect_center(const char* kind, CenterResult result, const Point<Dim>& center,
                            const std::optional<Point<Dim>>& expected, Counters& counters) {
    ++counters.comparisons;
    const bool is_inside = result == CenterResult::kInside;
    expect_equal(std::string(kind) + " inside", is_inside, expected.has_value());
    if (!is_inside) return;
    for (std::size_t k = 0; k < Dim; ++k) {
      const bool same = std::bit_cast<std::uint64_t>(center[k]) == std::bit_cast<std::uint64_t>((*expected)[k]);
      if (!same) expect_equal(kind, text(center), text(*expected));
    }
  }

  static void check_center(const std::vector<Point<Dim>>& points, Counters& counters) {
    const auto expected = test::exact_center<Dim>(points);
    ++counters.named[expected ? 0 : 1];
    for (const auto& order : orders()) {
      const auto s = corners(points, order);
      Point<Dim> center{};
      const bool is_inside = circumcenter(s, center);
      expect_center("circumcenter", is_inside ? CenterResult::kInside : CenterResult::kOutside, center,
                    expected, counters);
    }
    const auto s = corners(points);
    Point<Dim> center{};
    const CenterResult exact = detail::exact_circumcenter<Dim>(s, center);
    expect_center("exact circumcenter", exact, center, expected, counters);
    const CenterResult certified = detail::certified_circumcenter<Dim>(s, center);
    ++counters.named[certified == CenterResult::kUnknown ? 3 : 2];
    if (certified != CenterResult::kUnknown)
      expect_center("certified circumcenter", certified, center, expected, counters);
  }

  /// A relative error, and no other value than 0 where that is exact.
  static void expect_near(const char* kind, double found, const mpq_class& exact, double slack,
                          Counters& counters) {
    ++counters.comparisons;
    const mpq_class bound = abs(exact) * kRelative + slack;
    if (!std::isfinite(found) || abs(mpq_class(found) - exact) > bound)
      expect_equal(kind, found, exact.get_d());
    if (exact == 0 && slack == 0) expect_equal(std::string(kind) + " of sign", std::signbit(found), false);
  }

  static void check_vector(const std::vector<Point<Dim>>& points, const test::ExactPoints<Dim>& exact,
                           Counters& counters) {
    const auto vector = test::exact_vector_to_center<Dim>(exact, Dim + 1);
    double reach = 0;
    for (const mpq_class& x : test::exact_vector_to_center<Dim>(exact, 0)) reach = std::hypot(reach, x.get_d());
    const Point<Dim> found = vector_to_circumcenter<Dim>(corners(points), points.back());
    const double slack = 0x1p-98 * reach * (1 + 0x1p-40);  // reach is rounded
    for (std::size_t k = 0; k < Dim; ++k) expect_near("vector to center", found[k], vector[k], slack, counters);
  }

  static void check_power(const std::vector<Point<Dim>>& points, const test::ExactPoints<Dim>& exact,
                          Counters& counters) {
    const mpq_class expected = test::exact_power<Dim>(exact);
    if (expected == 0) ++counters.named[4];
    for (const auto& order : orders())
      expect_near("power", power<Dim>(corners(points, order), points.back()), expected, 0, counters);
  }

  static void check_normal(const std::vector<Point<Dim>>& points, const test::ExactPoints<Dim>& exact,
                           Counters& counters) {
    FacetCorners<Dim> facet;
    for (std::size_t i = 0; i < Dim; ++i) facet[i] = &points[i];
    const Point<Dim> found = facet_normal<Dim>(facet);
    const auto expected = test::exact_normal<Dim>(exact);
    for (std::size_t k = 0; k < Dim; ++k) expect_near("normal", found[k], expected[k], 0, counters);
  }
};

}  // namespace

template <int Dim>
std::unique_ptr<Suite> make_center_suite() {
  return std::make_unique<CenterSuite<Dim>>();
}
template std::unique_ptr<Suite> make_center_suite<2>();
template std::unique_ptr<Suite> make_center_suite<3>();

}  // namespace sinkmesh::stress
