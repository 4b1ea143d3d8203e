// SPDX-License-Identifier: MIT
#include <cmath>

#include "test/stress/delaunay/clouds.h"
#include "test/stress/delaunay/suites.h"
#include "test/stress/delaunay/triangulate.h"

namespace sinkmesh::stress {
namespace {

template <int Dim>
class OrderSuite : public Suite {
 public:
  std::string name() const override { return "order" + std::to_string(Dim) + "d"; }

  void generate(Random& random, Case& c) override {
    // Mostly hundreds; sometimes thousands, so that bulk loading has several rounds.
    const int most = random() % 8 == 0 ? 4000 : 400;
    c.set_points<Dim>(cloud<Dim>(static_cast<std::size_t>(test::uniform_int(random, 20, most)), random));
    c.set("order", random());
  }

  bool accepts(const Case& c) const override { return !c.rows.empty() && are_points<Dim>(c); }

  std::string check(const Case& c, Counters& counters) override {
    auto points = c.points<Dim>();
    const auto star = triangulate<Dim>(points, Engine::star);
    const auto flips = triangulate<Dim>(points, Engine::flips);
    ++counters.comparisons;
    expect_equal("spans the space", flips.has_value(), star.has_value());
    if (!star) {
      ++counters.named[0];
      return "";
    }
    expect_valid<Dim>(*star, "star");
    expect_valid<Dim>(*flips, "flips");
    const auto sets = test::simplex_sets(star->complex());
    expect_same_sets("flips against star", test::simplex_sets(flips->complex()), sets);
    expect_equal("hash", flips->hash(), star->hash());
    expect_equal("number of duplicates", flips->duplicates().size(), star->duplicates().size());
    if (!star->duplicates().empty()) ++counters.named[1];
    check_scaled(points, sets, c.number_setting("order"), counters);
    Random order(c.number_setting("order"));
    for (const Engine engine : test::kEngines) {
      std::shuffle(points.begin(), points.end(), order);
      ++counters.comparisons;
      expect_equal(std::string("hash in another order, by ") + name_of(engine),
                   triangulate<Dim>(points, engine).value().hash(), star->hash());
    }
    return "";
  }

  std::vector<NamedCounter> counters() const override {
    return {{"degenerate", 0.005}, {"with-duplicates", 0.1}};
  }

 private:
  /// In other units, ids and all are the same; away from the smallest and the largest numbers.
  static void check_scaled(std::vector<Point<Dim>> points, const std::vector<test::IdSet<Dim + 1>>& sets,
                           std::uint64_t choice, Counters& counters) {
    const int e = static_cast<int>(choice % 601) - 300;
    for (auto& p : points) {
      for (double& x : p) {
        const double scaled = std::ldexp(x, e);
        if (std::ldexp(scaled, -e) != x) return;
        x = scaled;
      }
    }
    const auto built = triangulate<Dim>(points, Engine::star);
    ++counters.comparisons;
    expect_same_sets("scaled by a power of two", test::simplex_sets(built.value().complex()), sets);
  }
};

}  // namespace

template <int Dim>
std::unique_ptr<Suite> make_order_suite() {
  return std::make_unique<OrderSuite<Dim>>();
}
template std::unique_ptr<Suite> make_order_suite<2>();
template std::unique_ptr<Suite> make_order_suite<3>();

}  // namespace sinkmesh::stress
