// SPDX-License-Identifier: MIT
#include "test/stress/delaunay/clouds.h"
#include "test/stress/delaunay/suites.h"
#include "test/stress/delaunay/triangulate.h"
#include "test/support/brute_force_doubles.h"

namespace sinkmesh::stress {
namespace {

constexpr std::size_t kMost = 12;

template <int Dim>
class OracleSuite : public Suite {
 public:
  std::string name() const override { return "oracle" + std::to_string(Dim) + "d"; }

  void generate(Random& random, Case& c) override {
    const int most = Dim == 2 ? kMost : 9;
    c.set_points<Dim>(
        small_cloud<Dim>(static_cast<std::size_t>(test::uniform_int(random, Dim + 1, most)), random));
  }

  // The gate changes the units, and only the units.
  bool accepts(const Case& c) const override {
    if (c.rows.empty() || c.rows.size() > kMost || !are_points<Dim>(c)) return false;
    const auto points = c.points<Dim>();
    return are_distinct<Dim>(points) && InputGate<Dim>(points).rounded_points() == 0;
  }

  std::string check(const Case& c, Counters& counters) override {
    auto points = c.points<Dim>();
    const auto expected = test::brute_force_delaunay_of_doubles<Dim>(points);
    const auto with_ghosts = test::with_ghosts(expected);
    if (expected.empty()) ++counters.named[0];
    if (2 * with_ghosts.size() > 3 * points.size()) ++counters.named[1];
    for (const Engine engine : test::kEngines) compare(points, engine, with_ghosts, counters);
    // The other way round the ids are mirrored.
    std::reverse(points.begin(), points.end());
    std::vector<test::IdSet<Dim + 1>> mirrored;
    const auto last = static_cast<std::uint32_t>(points.size()) - 1;
    for (auto ids : expected) {
      for (std::uint32_t& id : ids) id = last - id;
      std::sort(ids.begin(), ids.end());
      mirrored.push_back(ids);
    }
    compare(points, test::kEngines[points.size() % 2], test::with_ghosts(mirrored), counters);
    return "";
  }

  std::vector<NamedCounter> counters() const override {
    return {{"degenerate", 0.005}, {"many-simplices", 0.05}};
  }

 private:
  static void compare(const std::vector<Point<Dim>>& points, Engine engine,
                      const std::vector<test::IdSet<Dim + 1>>& expected, Counters& counters) {
    ++counters.comparisons;
    const auto built = triangulate<Dim>(points, engine);
    expect_equal("spans the space", built.has_value(), !expected.empty());
    if (!built) return;
    expect_valid<Dim>(*built, name_of(engine));
    expect_same_sets(name_of(engine), test::simplex_sets(built->complex()), expected);
  }
};

}  // namespace

template <int Dim>
std::unique_ptr<Suite> make_oracle_suite() {
  return std::make_unique<OracleSuite<Dim>>();
}
template std::unique_ptr<Suite> make_oracle_suite<2>();
template std::unique_ptr<Suite> make_oracle_suite<3>();

}  // namespace sinkmesh::stress
