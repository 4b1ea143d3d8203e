// SPDX-License-Identifier: MIT
//
// Each invariant broken on purpose, and nothing else; then everything at random.
#include "core/validation.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <set>
#include <sstream>
#include <string>

#include "core/retriangulator.h"
#include "core/triangulation.h"
#include "test/support/complexes.h"

namespace sinkmesh {
namespace {

using namespace test;

template <class Dimension>
class Validation : public testing::Test {
 protected:
  static constexpr int kDim = Dimension::value;

  /// A grid with the middle of its cells: many interior simplices, no slot unused.
  static std::vector<Point<kDim>> points() {
    auto points = full_grid<kDim>(3);
    for (auto p : full_grid<kDim>(2)) {
      for (double& x : p) x += 0.5;
      points.push_back(p);
    }
    return points;
  }
  Validation() : triangulation_(points()), complex_(triangulation_.mutable_complex()) { complex_.compact(); }

  std::set<std::string> violated() const {
    std::set<std::string> invariants;
    for (const auto& violation : triangulation_.validate().violations) invariants.insert(violation.invariant);
    return invariants;
  }
  using Names = std::set<std::string>;

  Simplex some_solid(std::size_t skip = 0) const {
    for (const Simplex s : complex_.simplices()) {
      if (complex_.is_solid(s) && skip-- == 0) return s;
    }
    return {};
  }
  Simplex some_ghost() const {
    for (const Simplex s : complex_.simplices()) {
      if (complex_.is_ghost(s)) return s;
    }
    return {};
  }
  std::uint32_t& corner(Simplex s, std::size_t i) { return complex_.records()[s.index()].corner[i]; }
  std::uint32_t& mate(Simplex s, std::size_t i) { return complex_.records()[s.index()].mate[i]; }

  Triangulation<kDim> triangulation_;
  Complex<kDim>& complex_;
};
TYPED_TEST_SUITE(Validation, Dimensions, DimensionNames);

TYPED_TEST(Validation, FindsNothingInASoundTriangulation) {
  EXPECT_EQ(this->violated(), typename TestFixture::Names{});
  EXPECT_TRUE(this->triangulation_.validate().ok());
  EXPECT_TRUE(this->triangulation_.is_delaunay());
  std::ostringstream text;
  text << this->triangulation_.validate();
  EXPECT_EQ(text.str(), "valid");
}

TYPED_TEST(Validation, ReportsAMateThatDoesNotAnswerAsI1) {
  const Simplex s = this->some_solid();
  const auto good = this->mate(s, 0);
  // One of another half-facet, one of the same simplex, itself, and none.
  for (const std::uint32_t bad :
       {this->mate(s, 1), s.index() * (TypeParam::value + 1) + 1, s.index() * (TypeParam::value + 1),
        ~std::uint32_t{0}, static_cast<std::uint32_t>(this->complex_.num_slots()) * (TypeParam::value + 1)}) {
    this->mate(s, 0) = bad;
    EXPECT_EQ(this->violated(), typename TestFixture::Names{"I1"}) << bad;
    // Named from both sides: the half-facet itself and the one that it has left.
    EXPECT_EQ(this->triangulation_.validate().count("I1"), 2U) << this->triangulation_.validate();
  }
  this->mate(s, 0) = good;
  EXPECT_TRUE(this->triangulation_.validate().ok());
}

TYPED_TEST(Validation, ReportsASimplexReleasedAloneAsI1) {
  this->complex_.release(this->some_ghost());
  EXPECT_GE(this->triangulation_.validate().count("I1"), static_cast<std::size_t>(TypeParam::value + 1));
}

TYPED_TEST(Validation, ReportsAFreeSlotListedTwiceAsI1) {
  // A simplex added and taken away again leaves a sound free list.
  this->complex_.reserve(1);
  const Simplex s = this->complex_.allocate();
  this->complex_.release(s);
  ASSERT_TRUE(this->triangulation_.validate().ok());
  this->complex_.release(s);
  EXPECT_EQ(this->violated(), typename TestFixture::Names{"I1"});
  EXPECT_EQ(this->triangulation_.validate().count("I1"), 2U) << "the slot, and the number of simplices";
}

TYPED_TEST(Validation, ReportsALostSimplexAsI1) {
  // Dead, but not in the free list; all its neighbours have forgotten it.
  this->complex_.reserve(1);
  const Simplex s = this->complex_.allocate();
  this->corner(s, 0) = 0;
  EXPECT_EQ(this->violated(), typename TestFixture::Names{"I1"});
}

TYPED_TEST(Validation, ReportsMatesWithOtherCornersAsI2) {
  constexpr int Dim = TypeParam::value;
  // Two pairs of mates exchange partners: every mate answers.
  const HalfFacet g = Complex<Dim>::half_facet(this->some_solid(0), 0);
  const HalfFacet h = Complex<Dim>::half_facet(this->some_solid(5), 0);
  const HalfFacet g_mate = this->complex_.mate(g);
  const HalfFacet h_mate = this->complex_.mate(h);
  ASSERT_NE(g_mate, h);
  this->complex_.set_mates(g, h_mate);
  this->complex_.set_mates(h, g_mate);
  EXPECT_EQ(this->violated(), typename TestFixture::Names{"I2"});
  EXPECT_EQ(this->triangulation_.validate().count("I2"), 4U);
}

TYPED_TEST(Validation, ReportsATurnedGhostAsI2) {
  // The same corners and mates, in the other orientation: nothing else can see it, since a ghost has no volume.
  const Simplex ghost = this->some_ghost();
  std::swap(this->corner(ghost, 0), this->corner(ghost, 1));
  std::swap(this->mate(ghost, 0), this->mate(ghost, 1));
  for (std::size_t i = 0; i <= TypeParam::value; ++i) {
    this->complex_.set_mates(Complex<TypeParam::value>::half_facet(ghost, static_cast<int>(i)),
                             HalfFacet(this->mate(ghost, i)));
  }
  EXPECT_EQ(this->violated(), typename TestFixture::Names{"I2"});
  EXPECT_EQ(this->triangulation_.validate().count("I2"), 2U * (TypeParam::value + 1));
}

TYPED_TEST(Validation, ReportsBadCornersAsI3) {
  const Simplex s = this->some_solid();
  const auto good = this->corner(s, 1);
  for (const std::uint32_t bad :
       {this->corner(s, 0), 0U, static_cast<std::uint32_t>(this->complex_.vertices().size()), 0x7fffffffU}) {
    this->corner(s, 1) = bad;
    EXPECT_EQ(this->triangulation_.validate().count("I3"), 1U) << bad << '\n'
                                                               << this->triangulation_.validate();
    EXPECT_EQ(this->triangulation_.validate().count("I2"), 0U) << "of a simplex that is not sound";
  }
  this->corner(s, 1) = good;
  EXPECT_TRUE(this->triangulation_.validate().ok());
}

TYPED_TEST(Validation, ReportsAWrongIncidentSimplexAsI4) {
  const Vertex v(0);
  const Simplex good = this->complex_.incident_simplex(v);
  Simplex other;
  for (const Simplex s : this->complex_.simplices()) {
    if (this->complex_.index_of(s, v) < 0) other = s;
  }
  this->complex_.reserve(1);
  const Simplex dead = this->complex_.allocate();
  this->complex_.release(dead);
  const Simplex beyond(static_cast<std::uint32_t>(this->complex_.num_slots()));
  for (const Vertex w : {v, Vertex::infinite()}) {
    const Simplex right = this->complex_.incident_simplex(w);
    for (const Simplex bad : {w == v ? other : this->some_solid(), dead, beyond, Simplex()}) {
      this->complex_.set_incident(w, bad);
      EXPECT_EQ(this->violated(), typename TestFixture::Names{"I4"}) << w << ' ' << bad;
      EXPECT_EQ(this->triangulation_.validate().count("I4"), 1U);
    }
    this->complex_.set_incident(w, right);
  }
  EXPECT_EQ(this->complex_.incident_simplex(v), good);
  EXPECT_TRUE(this->triangulation_.validate().ok());
}

TYPED_TEST(Validation, ReportsAMarkThatWasLeftAsI5) {
  for (const Simplex s : {this->some_solid(), this->some_ghost()}) {
    this->corner(s, 0) |= Complex<TypeParam::value>::kMark;
    EXPECT_EQ(this->violated(), typename TestFixture::Names{"I5"});
    EXPECT_EQ(this->triangulation_.validate().count("I5"), 1U);
    this->corner(s, 0) &= ~Complex<TypeParam::value>::kMark;
  }
}

TYPED_TEST(Validation, ReportsAnInvertedAndAFlatSimplexAsD1) {
  constexpr int Dim = TypeParam::value;
  // The middle vertex of the grid moves: all volumes around it were positive.
  Vertex middle;
  Point<Dim> centre;
  centre.fill(1);
  for (std::uint32_t i = 0; i < this->complex_.num_vertices(); ++i) {
    if (this->triangulation_.point(Vertex(i)) == centre) middle = Vertex(i);
  }
  Point<Dim>& p = this->complex_.vertices()[middle.slot()].point;
  const Point<Dim> good = p;
  p = this->triangulation_.gate().in(Point<Dim>{});
  EXPECT_EQ(this->violated(), typename TestFixture::Names{"D1"});
  // Onto a neighbour: the simplices with both are flat, the others are not.
  const Simplex s = this->complex_.incident_simplex(middle);
  const int i = this->complex_.index_of(s, middle);
  p = this->complex_.point(this->complex_.corner(s, i == 0 ? 1 : 0));
  EXPECT_EQ(this->violated(), typename TestFixture::Names{"D1"});
  p = good;
  EXPECT_TRUE(this->triangulation_.validate().ok());
}

/// Subdivides simplices or ghosts without a flip, and counts what the oracle says is not Delaunay.
template <int Dim>
void expect_d2_from_subdivision(const std::vector<Point<Dim>>& points, const Point<Dim>& p, bool outside) {
  Triangulation<Dim> triangulation(points);
  auto& complex = triangulation.mutable_complex();
  const Point<Dim> x = triangulation.gate().in(p);
  triangulation.announce(x);
  const Location<Dim> at = triangulation.locate(x);
  ASSERT_EQ(at.support(), outside ? 0 : Dim + 1);
  const Vertex v = complex.add_vertex(x);
  std::vector<std::array<Vertex, Dim + 1>> fresh;
  for (int i = 0; i <= Dim; ++i) {
    auto& corners = fresh.emplace_back();
    for (int k = 0; k <= Dim; ++k) {
      corners[static_cast<std::size_t>(k)] = k == i ? v : complex.corner(at.simplex, k);
    }
  }
  Retriangulator<Dim>().replace(complex, std::vector{at.simplex}, fresh);

  const auto report = triangulation.validate();
  EXPECT_GT(report.count("D2"), 0U);
  EXPECT_EQ(report.violations.size(), report.count("D2")) << report;
  EXPECT_FALSE(triangulation.is_delaunay());

  // By the oracle, for solid pairs.
  auto all = points;
  all.push_back(p);
  const LiftedSigns<Dim> signs(all);
  std::vector<std::uint32_t> rank(all.size());
  for (std::uint32_t r = 0; r < all.size(); ++r) rank[signs.id(r)] = r;
  std::size_t expected = 0;
  for (const Simplex s : complex.simplices()) {
    if (complex.is_ghost(s)) continue;
    IdSet<Dim + 1> ranks;
    for (int i = 0; i <= Dim; ++i) ranks[static_cast<std::size_t>(i)] = rank[complex.corner(s, i).index()];
    std::sort(ranks.begin(), ranks.end());
    for (int i = 0; i <= Dim; ++i) {
      const Vertex apex = complex.apex(complex.mate(Complex<Dim>::half_facet(s, i)));
      if (!apex.is_infinite() && signs.is_inside(ranks, rank[apex.index()])) ++expected;
    }
  }
  if (outside) {
    EXPECT_GE(report.count("D2"), expected);
  } else {
    EXPECT_EQ(report.count("D2"), expected);
  }
}

TYPED_TEST(Validation, NamesTheCornersOfASolidSimplexWithTheirCoordinates) {
  const Simplex s = this->some_solid();
  std::swap(this->corner(s, 0), this->corner(s, 1));
  std::string message;
  for (const auto& violation : this->triangulation_.validate().violations) {
    if (violation.invariant == "D1") message = violation.message;
  }
  for (int i = 0; i <= TypeParam::value; ++i) {
    const Vertex v = this->complex_.corner(s, i);
    std::ostringstream line;
    line << v << " =";
    for (const double x : this->complex_.point(v)) {
      char text[40];
      std::snprintf(text, sizeof text, " %a", x);
      line << text;
    }
    line << (i == TypeParam::value ? " has no positive volume" : "\n");
    EXPECT_NE(message.find("\n    " + line.str()), std::string::npos) << line.str() << " in " << message;
  }
}

TYPED_TEST(Validation, ReportsASubdivisionThatIsNotDelaunayAsD2) {
  constexpr int Dim = TypeParam::value;
  Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Point<Dim>> points;
    for (int i = 0; i < 40; ++i) {
      Point<Dim>& p = points.emplace_back();
      for (double& x : p) x = uniform_int(random, 64, 127);
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    // In the simplex of the largest circumsphere there is sure to be something wrong; any that is not tiny will
    // do.
    const Triangulation<Dim> triangulation(points);
    for (const Simplex s : triangulation.complex().simplices()) {
      if (triangulation.complex().is_ghost(s)) continue;
      Point<Dim> p{};
      for (int i = 0; i <= Dim; ++i) {
        const Point<Dim> q = triangulation.point(triangulation.complex().corner(s, i));
        for (std::size_t k = 0; k < Dim; ++k) p[k] += q[k] / (Dim + 1);
      }
      for (double& x : p) x = std::floor(x);
      if (triangulation.locate(triangulation.gate().in(p)).support() != Dim + 1) continue;
      Cavity<Dim> cavity;
      Triangulation<Dim> copy = triangulation;
      copy.announce(copy.gate().in(p));
      copy.grow_prestar(cavity, copy.gate().in(p), copy.locate(copy.gate().in(p)).simplex);
      if (cavity.num_simplices() == 1) continue;
      expect_d2_from_subdivision<Dim>(points, p, false);
      break;
    }
  }
}

// The hull is not convex: only ghosts are in conflict with the new vertex, beyond whose facets it lies.
TYPED_TEST(Validation, ReportsAHullThatIsNotConvexAsD2) {
  constexpr int Dim = TypeParam::value;
  std::vector<Point<Dim>> points = full_grid<Dim>(2);
  for (auto& p : points) {
    for (double& x : p) x = 64 + 60 * x;
  }
  Point<Dim> p;
  p.fill(127);  // beyond a corner: visible from Dim sides
  p[0] = 126;
  expect_d2_from_subdivision<Dim>(points, p, true);
}

// Nothing that a single word can do goes unnoticed, and nothing makes the validator read outside its arrays.
TYPED_TEST(Validation, NoticesEveryCorruptedWord) {
  constexpr int Dim = TypeParam::value;
  Random random(2);
  const Triangulation<Dim> good = this->triangulation_;
  const auto slots = static_cast<std::uint32_t>(good.complex().num_slots());
  const auto vertices = static_cast<std::uint32_t>(good.complex().vertices().size());
  for (int trial = 0; trial < 4000; ++trial) {
    SCOPED_TRACE(trial);
    const std::uint32_t s = static_cast<std::uint32_t>(random() % slots);
    auto& record = this->complex_.records()[s];
    const std::size_t i = random() % (Dim + 1);
    std::uint32_t& word = random() % 2 != 0 ? record.corner[i] : record.mate[i];
    const std::uint32_t old = word;
    switch (random() % 5) {
      case 0:
        word = static_cast<std::uint32_t>(random());
        break;
      case 1:
        word = static_cast<std::uint32_t>(random() % vertices);
        break;
      case 2:
        word = static_cast<std::uint32_t>(random() % (slots * (Dim + 1)));
        break;
      case 3:
        word = 0;
        break;
      default:
        word ^= 1U << random() % 32;
        break;
    }
    ASSERT_EQ(this->triangulation_.validate().ok(), word == old) << old << " -> " << word;
    word = old;
  }
  EXPECT_TRUE(this->triangulation_.validate().ok());
}

TYPED_TEST(Validation, SurvivesAComplexFullOfNoise) {
  constexpr int Dim = TypeParam::value;
  Random random(3);
  for (int trial = 0; trial < 300; ++trial) {
    Triangulation<Dim> broken = this->triangulation_;
    auto& complex = broken.mutable_complex();
    const auto slots = static_cast<std::uint32_t>(complex.num_slots());
    for (int n = uniform_int(random, 2, 200); n > 0; --n) {
      auto& record = complex.records()[random() % slots];
      auto& vertex = complex.vertices()[random() % complex.vertices().size()];
      const auto noise = static_cast<std::uint32_t>(random() >> random() % 64);
      switch (random() % 4) {
        case 0:
          record.corner[random() % (Dim + 1)] = noise;
          break;
        case 1:
          record.mate[random() % (Dim + 1)] = noise;
          break;
        case 2:
          vertex.incident = noise;
          break;
        default:
          complex.release(Simplex(noise % slots));
          break;
      }
    }
    const auto report = broken.validate();
    EXPECT_FALSE(report.ok());
    std::ostringstream text;
    text << report;
    EXPECT_NE(text.str().find(report.violations.front().message), std::string::npos);
  }
}

}  // namespace
}  // namespace sinkmesh
