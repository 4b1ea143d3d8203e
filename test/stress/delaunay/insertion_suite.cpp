// SPDX-License-Identifier: MIT
#include "test/stress/delaunay/clouds.h"
#include "test/stress/delaunay/suites.h"
#include "test/stress/delaunay/triangulate.h"

namespace sinkmesh::stress {
namespace {

/// Moves the point with the largest coordinate, which decides on the gate, to the front.
/// @return how many of the first points span the space; 0 if not even all do.
template <int Dim>
std::size_t first_spanning(std::vector<Point<Dim>>& points) {
  const auto largest = [](const Point<Dim>& p) {
    double most = 0;
    for (const double x : p) most = std::max(most, std::abs(x));
    return most;
  };
  std::iter_swap(points.begin(),
                 std::max_element(points.begin(), points.end(),
                                  [&](const auto& p, const auto& q) { return largest(p) < largest(q); }));
  for (std::size_t n = Dim + 1; n <= points.size(); ++n) {
    if (triangulate<Dim>({points.begin(), points.begin() + static_cast<std::ptrdiff_t>(n)}, Engine::star))
      return n;
  }
  return 0;
}

template <int Dim>
class InsertionSuite : public Suite {
 public:
  std::string name() const override { return "insertion" + std::to_string(Dim) + "d"; }

  void generate(Random& random, Case& c) override {
    c.set_points<Dim>(cloud<Dim>(static_cast<std::size_t>(test::uniform_int(random, 10, 80)), random));
    c.set("engines", random());
  }

  bool accepts(const Case& c) const override { return c.rows.size() > Dim && are_points<Dim>(c); }

  std::string check(const Case& c, Counters& counters) override {
    auto points = c.points<Dim>();
    const std::size_t first = first_spanning<Dim>(points);
    if (first == 0) {
      ++counters.named[0];
      return "";
    }
    Random engines(c.number_setting("engines"));
    auto grown =
        *triangulate<Dim>({points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first)}, Engine::star);
    const InputGate<Dim> gate(points);
    expect_equal("exponent of the gate", grown.gate().exponent(), gate.exponent());
    for (std::size_t i = first; i < points.size(); ++i) {
      const Engine engine = test::kEngines[engines() % 2];
      const std::size_t before = grown.complex().num_vertices();
      const auto inserted = grown.insert(points[i], engine);
      ++counters.comparisons;
      if (!inserted.is_new) ++counters.named[1];
      expect_equal("number of vertices", grown.complex().num_vertices(), before + (inserted.is_new ? 1 : 0));
      expect_equal("position", text(grown.point(inserted.vertex)), text(gate.out(gate.in(points[i]))));
      expect_valid<Dim>(grown, std::string("after insertion ") + std::to_string(i) + " by " + name_of(engine));
    }
    const auto all = *triangulate<Dim>(points, test::kEngines[engines() % 2]);
    expect_equal("hash", grown.hash(), all.hash());
    expect_equal("number of simplices", grown.num_solid(), all.num_solid());
    grown.compact();
    expect_valid<Dim>(grown, "after compact()");
    expect_equal("hash after compact()", grown.hash(), all.hash());
    return "";
  }

  std::vector<NamedCounter> counters() const override { return {{"degenerate", 0.005}, {"duplicates", 0.1}}; }
};

}  // namespace

template <int Dim>
std::unique_ptr<Suite> make_insertion_suite() {
  return std::make_unique<InsertionSuite<Dim>>();
}
template std::unique_ptr<Suite> make_insertion_suite<2>();
template std::unique_ptr<Suite> make_insertion_suite<3>();

}  // namespace sinkmesh::stress
