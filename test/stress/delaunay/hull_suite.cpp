// SPDX-License-Identifier: MIT
//
// A certificate of the hull by integers alone: every hull facet has all points on one side, every simplex has a
// positive volume, and the volumes of the simplices add up to those of the cones from one point to the hull
// facets, which is the volume that the hull encloses.
#include <cmath>

#include "test/stress/delaunay/clouds.h"
#include "test/stress/delaunay/suites.h"
#include "test/stress/delaunay/triangulate.h"

namespace sinkmesh::stress {
namespace {

__extension__ using Wide = __int128;

/// Volumes of integers up to this have fewer than 3 * 41 + 3 bits.
constexpr double kLargest = 0x1p40;

template <int Dim>
using Integers = std::array<std::int64_t, Dim>;

Wide volume(const std::array<Integers<2>, 3>& p) {
  const auto d = [&](std::size_t i, std::size_t k) { return static_cast<Wide>(p[i][k] - p[0][k]); };
  return d(1, 0) * d(2, 1) - d(1, 1) * d(2, 0);
}
Wide volume(const std::array<Integers<3>, 4>& p) {
  const auto d = [&](std::size_t i, std::size_t k) { return static_cast<Wide>(p[i][k] - p[0][k]); };
  Wide sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3;
    const std::size_t m = (k + 2) % 3;
    sum += d(1, k) * (d(2, l) * d(3, m) - d(2, m) * d(3, l));
  }
  return sum;
}

template <int Dim>
class HullSuite : public Suite {
 public:
  std::string name() const override { return "hull" + std::to_string(Dim) + "d"; }

  void generate(Random& random, Case& c) override {
    auto points = cloud<Dim>(static_cast<std::size_t>(test::uniform_int(random, 4, 150)), random);
    double largest = 0;
    for (const auto& p : points) {
      for (const double x : p) largest = std::max(largest, std::abs(x));
    }
    // Small integers have many coplanar points on their hull, large ones keep the shape.
    const int bits = test::uniform_int(random, 2, 38);
    for (auto& p : points) {
      for (double& x : p)
        x = std::nearbyint(std::ldexp(x, largest == 0 ? 0 : bits - std::ilogb(largest))) + 0.0;
    }
    make_distinct<Dim>(points, random);
    c.set_points<Dim>(points);
  }

  bool accepts(const Case& c) const override {
    if (!are_points<Dim>(c) || c.rows.empty()) return false;
    for (const auto& row : c.rows) {
      for (const double x : row) {
        if (x != std::nearbyint(x) || std::abs(x) > kLargest) return false;
      }
    }
    return are_distinct<Dim>(c.points<Dim>());
  }

  std::string check(const Case& c, Counters& counters) override {
    const auto points = c.points<Dim>();
    const Engine engine = test::kEngines[c.rows.size() % 2];
    const auto built = triangulate<Dim>(points, engine);
    if (!built) {
      ++counters.named[0];
      return "";
    }
    std::vector<Integers<Dim>> integers(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t k = 0; k < Dim; ++k) integers[i][k] = static_cast<std::int64_t>(points[i][k]);
    }
    ++counters.comparisons;
    expect_valid<Dim>(*built, name_of(engine));
    const Wide inside = volume_of_simplices(built->complex(), integers);
    const Wide enclosed = volume_of_hull(built->complex(), integers, counters);
    if (inside != enclosed) return "volume: the simplices do not fill the hull";
    return "";
  }

  std::vector<NamedCounter> counters() const override { return {{"degenerate", 0.002}, {"flat-hulls", 0.05}}; }

 private:
  static Wide volume_of_simplices(const Complex<Dim>& complex, const std::vector<Integers<Dim>>& points) {
    Wide sum = 0;
    for (const Simplex s : complex.simplices()) {
      if (complex.is_ghost(s)) continue;
      std::array<Integers<Dim>, Dim + 1> corners;
      for (int i = 0; i <= Dim; ++i)
        corners[static_cast<std::size_t>(i)] = points[complex.corner(s, i).index()];
      const Wide v = volume(corners);
      if (v <= 0) throw CheckFailed("orientation: a simplex without positive volume");
      sum += v;
    }
    return sum;
  }

  static Wide volume_of_hull(const Complex<Dim>& complex, const std::vector<Integers<Dim>>& points,
                             Counters& counters) {
    Wide sum = 0;
    bool has_coplanar = false;
    for (const Simplex s : complex.simplices()) {
      if (!complex.is_ghost(s)) continue;
      std::array<Integers<Dim>, Dim + 1> corners;
      for (int i = 0; i < Dim; ++i) corners[static_cast<std::size_t>(i)] = points[complex.corner(s, i).index()];
      int side = 0;
      std::size_t on = 0;
      for (const auto& p : points) {
        corners[Dim] = p;
        const Wide v = volume(corners);
        const int here = (v > 0) - (v < 0);
        if (here * side < 0) throw CheckFailed("hull: a hull facet with points on both sides");
        if (here != 0) side = here;
        if (here == 0) ++on;
      }
      has_coplanar = has_coplanar || on > Dim;
      corners[Dim] = points[0];
      const Wide cone = volume(corners);
      sum += cone < 0 ? -cone : cone;
    }
    if (has_coplanar) ++counters.named[1];
    return sum;
  }
};

}  // namespace

template <int Dim>
std::unique_ptr<Suite> make_hull_suite() {
  return std::make_unique<HullSuite<Dim>>();
}
template std::unique_ptr<Suite> make_hull_suite<2>();
template std::unique_ptr<Suite> make_hull_suite<3>();

}  // namespace sinkmesh::stress
