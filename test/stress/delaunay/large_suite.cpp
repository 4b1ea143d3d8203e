// SPDX-License-Identifier: MIT
#include <chrono>
#include <cmath>
#include <utility>

#include "test/stress/delaunay/suites.h"
#include "test/stress/delaunay/triangulate.h"
#include "test/support/shapes.h"

namespace sinkmesh::stress {
namespace {

using test::Shape;

constexpr std::size_t kPoints = 1'000'000;
constexpr std::uint64_t kMostSeconds = 300;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One case: the points follow from its settings, so that its file is small.
class LargeSuite : public Suite {
 public:
  LargeSuite(std::string name, Shape shape) : name_(std::move(name)), shape_(shape) {}

  std::string name() const override { return name_; }
  bool is_large() const override { return true; }
  std::uint64_t num_cases() const override { return 1; }
  unsigned seconds_per_case() const override { return 6 * kMostSeconds; }

  void generate(Random& random, Case& c) override {
    c.rows.clear();
    c.set("points", kPoints);
    c.set("random", random());
  }

  bool accepts(const Case& c) const override { return c.rows.empty() && c.number_setting("points") > 0; }

  std::string check(const Case& c, Counters& counters) override {
    Random random(c.number_setting("random"));
    auto points = test::make_shape<3>(shape_, c.number_setting("points"), random);
    const auto start = std::chrono::steady_clock::now();
    std::uint64_t hash = 0;
    std::size_t simplices = 0;
    {
      const Triangulation3 built(points);
      const double seconds = seconds_since(start);
      counters.named[0] = static_cast<std::uint64_t>(std::ceil(seconds));
      if (seconds > kMostSeconds) return differ("too slow", std::to_string(seconds) + " s", kMostSeconds);
      hash = built.hash();
      simplices = built.num_solid();
      counters.named[1] = simplices;
      expect_valid<3>(built, "star");
      if (!built.is_delaunay()) return "delaunay: a facet is not Delaunay";
    }
    std::shuffle(points.begin(), points.end(), random);
    const Triangulation3 again(points);
    expect_equal("hash in another order", again.hash(), hash);
    expect_equal("number of simplices in another order", again.num_solid(), simplices);
    counters.comparisons += 2 * simplices;
    return "";
  }

  std::vector<NamedCounter> counters() const override { return {{"seconds-to-build"}, {"simplices"}}; }

 private:
  std::string name_;
  Shape shape_;
};

}  // namespace

Suites make_large_suites() {
  Suites suites;
  const auto add = [&](const char* name, Shape shape) {
    suites.push_back(std::make_unique<LargeSuite>(name, shape));
  };
  add("large-plane-plus-one", Shape::kFlatPlusOne);
  add("large-line-plus-three", Shape::kLinePlusFew);
  add("large-sphere", Shape::kSphere);
  add("large-grid", Shape::kGrid);
  add("large-fine-grid", Shape::kFineSpacing);
  add("large-clusters", Shape::kClusters);
  add("large-uniform", Shape::kUniform);
  return suites;
}

}  // namespace sinkmesh::stress
