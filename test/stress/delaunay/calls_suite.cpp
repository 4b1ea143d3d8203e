// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>

#include "test/stress/delaunay/clouds.h"
#include "test/stress/delaunay/suites.h"
#include "test/stress/delaunay/triangulate.h"

namespace sinkmesh::stress {
namespace {

enum Call : unsigned { kInsertStar, kInsertFlips, kRemove, kLocate, kCopy, kMove, kPrestar, kCompact };
constexpr unsigned kCalls = kCompact + 1;

/// The calls of one case, and the points that the triangulation must be of.
template <int Dim>
class Calls {
 public:
  /// @throws DegenerateInput
  Calls(const std::vector<Point<Dim>>& points, Counters& counters) : subject_(points), counters_(counters) {}

  void call(unsigned what, const Point<Dim>& p) {
    switch (what) {
      case kInsertStar:
        return insert(p, Engine::star);
      case kInsertFlips:
        return insert(p, Engine::flips);
      case kRemove:
        return remove(vertex_for(p));
      case kLocate:
        return locate(p);
      case kCopy:
        return copy(p);
      case kMove: {
        Triangulation<Dim> moved = std::move(subject_);
        subject_ = std::move(moved);
        return;
      }
      case kPrestar:
        return look_at_prestar(p);
      default:
        subject_.compact();
    }
  }

  /// Everything that can be said of it, after each call.
  void expect_sound(const std::string& what) {
    ++counters_.comparisons;
    expect_valid<Dim>(subject_, what);
    expect_equal("Delaunay", subject_.is_delaunay(), true);
    std::vector<Point<Dim>> points;
    for (std::uint32_t i = 0; i < subject_.complex().num_vertices(); ++i) {
      if (is_in(Vertex(i))) points.push_back(subject_.point(Vertex(i)));
    }
    expect_equal("hash", subject_.hash(), Triangulation<Dim>(points).hash());
  }

 private:
  bool is_in(Vertex v) const { return !subject_.complex().incident_simplex(v).is_null(); }

  Vertex vertex_for(const Point<Dim>& p) const {
    const double n = static_cast<double>(subject_.complex().num_vertices());
    return Vertex(static_cast<std::uint32_t>(std::fmod(std::abs(p[0] + 3 * p[1]), n)));
  }

  void insert(const Point<Dim>& p, Engine engine) {
    const std::size_t before = subject_.complex().num_vertices();
    if (!subject_.gate().admits(p)) {
      expect_refused<InputError>("insertion beyond the gate", [&] { subject_.insert(p, engine); });
      return;
    }
    const auto inserted = subject_.insert(p, engine);
    expect_equal("number of vertices", subject_.complex().num_vertices(), before + (inserted.is_new ? 1 : 0));
    const Point<Dim> expected = subject_.gate().out(subject_.gate().in(p));
    expect_equal("position", subject_.point(inserted.vertex) == expected, true);
  }

  void remove(Vertex v) {
    if (!is_in(v)) {
      expect_refused<InputError>("removal of nothing", [&] { subject_.remove(v); });
      return;
    }
    const Point<Dim> p = subject_.point(v);
    const std::uint64_t before = subject_.hash();
    try {
      subject_.remove(v);
    } catch (const DegenerateInput&) {
      expect_equal("hash after a removal that is refused", subject_.hash(), before);
      ++counters_.named[1];
      return;
    }
    expect_equal("removed", is_in(v), false);
    ++counters_.named[0];
    Triangulation<Dim> again = subject_;
    again.insert(p);
    expect_equal("hash after inserting it again", again.hash(), before);
  }

  void locate(const Point<Dim>& p) {
    if (!subject_.gate().admits(p)) return;
    const Point<Dim> x = subject_.gate().in(p);
    subject_.announce(x);
    const Location<Dim> at = subject_.locate(x);
    const auto& complex = subject_.complex();
    expect_equal("ghosts have no support", complex.is_ghost(at.simplex), at.support() == 0);
    for (const Simplex s : complex.simplices()) {
      if (complex.is_ghost(s)) continue;
      Location<Dim> here;
      const bool is_inside = contains(s, x, here);
      if (s == at.simplex) expect_equal("signs of the place", here.sign == at.sign, true);
      if (complex.is_ghost(at.simplex)) expect_equal("inside, and located outside", is_inside, false);
    }
  }

  bool contains(Simplex s, const Point<Dim>& x, Location<Dim>& at) const {
    bool is_inside = true;
    for (std::size_t i = 0; i <= Dim; ++i) {
      Corners<Dim> seen = subject_.complex().corners(s);
      seen[i] = &x;
      at.sign[i] = static_cast<std::int8_t>(subject_.predicates().orient(seen));
      is_inside = is_inside && at.sign[i] >= 0;
    }
    return is_inside;
  }

  void copy(const Point<Dim>& p) {
    const std::uint64_t before = subject_.hash();
    Triangulation<Dim> other = subject_;
    if (other.gate().admits(p)) other.insert(p);
    expect_equal("hash of the original", subject_.hash(), before);
    if (p[0] > 0) subject_ = std::move(other);
  }

  void look_at_prestar(const Point<Dim>& p) {
    if (!subject_.gate().admits(p)) return;
    const Point<Dim> x = subject_.gate().in(p);
    subject_.announce(x);
    const Location<Dim> at = subject_.locate(x);
    if (at.is_at_corner()) return;
    Cavity<Dim> cavity;
    expect_equal("prestar", subject_.grow_prestar(cavity, x, at.simplex), true);
    subject_.release(cavity);
  }

  template <class Error, class Step>
  void expect_refused(const std::string& what, Step step) {
    const std::uint64_t before = subject_.hash();
    bool is_refused = false;
    try {
      step();
    } catch (const Error&) {
      is_refused = true;
    }
    expect_equal(what + " refused", is_refused, true);
    expect_equal(what + " changed", subject_.hash(), before);
  }

  Triangulation<Dim> subject_;
  Counters& counters_;
};

/// Rows are points and what is to be done with each; the first ones are triangulated.
template <int Dim>
class CallsSuite : public Suite {
 public:
  std::string name() const override { return "calls" + std::to_string(Dim) + "d"; }

  void generate(Random& random, Case& c) override {
    const auto points = cloud<Dim>(static_cast<std::size_t>(test::uniform_int(random, 8, 40)), random);
    c.rows.clear();
    for (const Point<Dim>& p : points) {
      auto& row = c.rows.emplace_back(p.begin(), p.end());
      const auto any = static_cast<unsigned>(random() % kCalls);
      row.push_back(random() % 3 == 0 ? unsigned{kRemove} : any);
    }
    c.set("first", random() % (points.size() + 1));
  }

  bool accepts(const Case& c) const override {
    return std::all_of(c.rows.begin(), c.rows.end(), [](const auto& row) {
      return row.size() == Dim + 1 &&
             std::all_of(row.begin(), row.end(), [](double x) { return std::isfinite(x); }) && row[Dim] >= 0 &&
             row[Dim] < kCalls;
    });
  }

  std::string check(const Case& c, Counters& counters) override {
    const auto points = c.points<Dim>();
    const std::size_t first = std::min<std::size_t>(c.number_setting("first"), points.size());
    std::optional<Calls<Dim>> calls;
    try {
      calls.emplace(
          std::vector<Point<Dim>>(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first)),
          counters);
    } catch (const InputError&) {
      ++counters.named[2];
      return "";
    }
    calls->expect_sound("at first");
    for (std::size_t i = first; i < points.size(); ++i) {
      calls->call(static_cast<unsigned>(c.rows[i][Dim]), points[i]);
      calls->expect_sound("after call " + std::to_string(i));
    }
    return "";
  }

  std::vector<NamedCounter> counters() const override {
    return {{"removed", 0.5}, {"kept", 0.01}, {"degenerate", 0.005}};
  }
};

}  // namespace

template <int Dim>
std::unique_ptr<Suite> make_calls_suite() {
  return std::make_unique<CallsSuite<Dim>>();
}
template std::unique_ptr<Suite> make_calls_suite<2>();
template std::unique_ptr<Suite> make_calls_suite<3>();

}  // namespace sinkmesh::stress
