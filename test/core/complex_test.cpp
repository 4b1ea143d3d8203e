// SPDX-License-Identifier: MIT
//
// The building blocks of the complex, before any geometry.
#include "core/complex.h"

#include <gtest/gtest.h>

#include <concepts>
#include <set>
#include <sstream>
#include <type_traits>

#include "core/validation.h"
#include "test/support/complexes.h"

namespace sinkmesh {
namespace {

using namespace test;

// -- handles

static_assert(!std::equality_comparable_with<Simplex, HalfFacet>);
static_assert(!std::equality_comparable_with<Simplex, Vertex>);
static_assert(!std::is_convertible_v<std::uint32_t, Simplex> && !std::is_convertible_v<Simplex, HalfFacet>);
static_assert(!std::is_convertible_v<std::uint32_t, Vertex> && !std::is_convertible_v<Vertex, std::uint32_t>);
static_assert(sizeof(Simplex) == 4 && sizeof(HalfFacet) == 4 && sizeof(Vertex) == 4);
static_assert(std::is_trivially_copyable_v<Simplex> && std::is_trivially_copyable_v<Vertex>);
static_assert(sizeof(Complex<3>::Record) == 32);

template <class T>
std::string text_of(T handle) {
  std::ostringstream text;
  text << handle;
  return text.str();
}

TEST(Handles, PrintWhatTheyAre) {
  EXPECT_EQ(text_of(Vertex(3)), "v3");
  EXPECT_EQ(text_of(Vertex::infinite()), "infinity");
  EXPECT_EQ(text_of(Vertex()), "no vertex");
  EXPECT_EQ(text_of(Simplex(3)), "s3");
  EXPECT_EQ(text_of(Simplex()), "no simplex");
  EXPECT_EQ(text_of(HalfFacet(3)), "h3");
  EXPECT_EQ(text_of(HalfFacet()), "no half-facet");
}

TEST(Handles, KeepInfinityAndNullApartFromVertices) {
  EXPECT_TRUE(Vertex().is_null() && !Vertex().is_infinite());
  EXPECT_TRUE(Vertex::infinite().is_infinite() && !Vertex::infinite().is_null());
  EXPECT_FALSE(Vertex(0).is_infinite() || Vertex(0).is_null());
  EXPECT_EQ(Vertex::at_slot(Vertex(5).slot()), Vertex(5));
  EXPECT_EQ(Vertex(5).index(), 5U);
  EXPECT_LT(Vertex::infinite(), Vertex(0));
  EXPECT_TRUE(Simplex().is_null());
  EXPECT_FALSE(Simplex(0).is_null());
}

template <class Dimension>
class ComplexOf : public testing::Test {};
TYPED_TEST_SUITE(ComplexOf, Dimensions, DimensionNames);

TYPED_TEST(ComplexOf, HalfFacetsAreNumberedBySimplexAndCorner) {
  constexpr int Dim = TypeParam::value;
  std::uint32_t next = 0;
  for (std::uint32_t s = 0; s < 5; ++s) {
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet h = Complex<Dim>::half_facet(Simplex(s), i);
      EXPECT_EQ(h, HalfFacet(next++));
      EXPECT_EQ(Complex<Dim>::simplex_of(h), Simplex(s));
      EXPECT_EQ(Complex<Dim>::corner_of(h), i);
    }
  }
}

TYPED_TEST(ComplexOf, FacetsListTheOtherCornersInPositiveOrder) {
  constexpr int Dim = TypeParam::value;
  for (std::size_t i = 0; i <= Dim; ++i) {
    std::array<std::size_t, Dim + 1> order{i};
    for (std::size_t k = 0; k < Dim; ++k) order[k + 1] = Complex<Dim>::kFacet[i][k];
    int inversions = 0;
    for (std::size_t a = 0; a <= Dim; ++a) {
      for (std::size_t b = a + 1; b <= Dim; ++b) inversions += order[a] > order[b] ? 1 : 0;
    }
    EXPECT_EQ(inversions % 2, 0) << "facet " << i;
    EXPECT_EQ(std::set(order.begin(), order.end()).size(), order.size());
    // Star substitution in space puts an apex in front and leaves infinity in the last place.
    if (Dim == 3 && i != Dim) {
      EXPECT_EQ(Complex<Dim>::kFacet[i][Dim - 1], Dim);
    }
  }
}

/// The unit simplex, its first two corners exchanged if they must be, and its ghosts.
template <int Dim>
Complex<Dim> sphere_complex() {
  Complex<Dim> complex;
  std::array<Vertex, Dim + 1> corners;
  corners[0] = complex.add_vertex({});
  for (std::size_t k = 0; k < Dim; ++k) {
    Point<Dim> p{};
    p[k] = 1;
    corners[k + 1] = complex.add_vertex(p);
  }
  complex.make_sphere(corners);
  return complex;
}

TYPED_TEST(ComplexOf, OneSimplexAndItsGhostsIsASphere) {
  constexpr int Dim = TypeParam::value;
  const Complex<Dim> complex = sphere_complex<Dim>();
  EXPECT_EQ(complex.num_simplices(), static_cast<std::size_t>(Dim + 2));
  EXPECT_EQ(complex.num_vertices(), static_cast<std::size_t>(Dim + 1));
  Box<Dim> box;
  box.include(Point<Dim>{});
  for (std::uint32_t i = 0; i <= Dim; ++i) box.include(complex.point(Vertex(i)));
  const Predicates<Dim> predicates(box, 0);
  EXPECT_TRUE(validate(complex, predicates).ok()) << validate(complex, predicates);
  EXPECT_TRUE(is_delaunay(complex, predicates));

  // All subsets of Dim+1 of the Dim+2 vertices, infinity included, once; each is adjacent to each other one.
  std::vector<IdSet<Dim + 1>> expected;
  for_all_subsets<Dim + 1>(Dim + 2, [&](IdSet<Dim + 1> set) {
    for (std::uint32_t& id : set) id = id == Dim + 1 ? Vertex::infinite().index() : id;
    expected.push_back(set);
  });
  EXPECT_EQ(simplex_sets(complex), expected);
  for (const Simplex s : complex.simplices()) {
    std::set<Simplex> neighbors;
    for (int i = 0; i <= Dim; ++i) neighbors.insert(complex.neighbor(s, i));
    EXPECT_EQ(neighbors.size(), static_cast<std::size_t>(Dim + 1));
    EXPECT_FALSE(neighbors.contains(s));
  }
}

// Counterclockwise seen from outside: the outer normal of a facet is the cross product of its edges (in the
// plane, the edge turned to the right), and a ghost with a point beyond in the place of infinity is positive.
TYPED_TEST(ComplexOf, FacetsAndGhostsAreSeenFromOutside) {
  constexpr int Dim = TypeParam::value;
  const Complex<Dim> complex = sphere_complex<Dim>();
  for (const Simplex s : complex.simplices()) {
    if (complex.is_ghost(s)) {
      std::array<Point<Dim>, Dim + 1> p;
      for (int i = 0; i < Dim; ++i) p[static_cast<std::size_t>(i)] = complex.point(complex.corner(s, i));
      // Far beyond the facet: away from the corner that it misses.
      const Vertex missed = complex.apex(complex.mate(Complex<Dim>::half_facet(s, Dim)));
      for (std::size_t k = 0; k < Dim; ++k) p[Dim][k] = 5 - 19 * complex.point(missed)[k];
      if (missed == Vertex(0)) p[Dim].fill(5);
      if (missed != Vertex(0)) {
        EXPECT_LT(p[Dim][missed.index() - 1], 0);
      }
      EXPECT_GT(integer_volume<Dim>(p), 0);
      continue;
    }
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet h = Complex<Dim>::half_facet(s, i);
      const auto f = complex.facet(h);
      const auto edge = [&](std::size_t a, std::size_t k) {
        return complex.point(f[a])[k] - complex.point(f[0])[k];
      };
      Point<Dim> normal;
      if constexpr (Dim == 2) {
        normal = {edge(1, 1), -edge(1, 0)};
      } else {
        normal = {edge(1, 1) * edge(2, 2) - edge(1, 2) * edge(2, 1),
                  edge(1, 2) * edge(2, 0) - edge(1, 0) * edge(2, 2),
                  edge(1, 0) * edge(2, 1) - edge(1, 1) * edge(2, 0)};
      }
      double towards_apex = 0;
      for (std::size_t k = 0; k < Dim; ++k) {
        towards_apex += normal[k] * (complex.point(complex.apex(h))[k] - complex.point(f[0])[k]);
      }
      EXPECT_LT(towards_apex, 0);
    }
  }
}

TYPED_TEST(ComplexOf, RecordsAreReusedLastInFirstOut) {
  constexpr int Dim = TypeParam::value;
  Complex<Dim> complex;
  EXPECT_EQ(complex.num_simplices(), 0U);
  EXPECT_EQ(complex.num_vertices(), 0U);
  complex.reserve(4);
  std::array<Simplex, 4> s;
  for (Simplex& t : s) {
    t = complex.allocate();
    complex.records()[t.index()].corner.fill(1);
  }
  complex.release(s[1]);
  complex.release(s[3]);
  EXPECT_EQ(complex.num_simplices(), 2U);
  EXPECT_EQ(complex.num_slots(), 4U);
  EXPECT_EQ(std::vector(complex.simplices().begin(), complex.simplices().end()), (std::vector{s[0], s[2]}));
  EXPECT_EQ(complex.allocate(), s[3]);
  EXPECT_EQ(complex.allocate(), s[1]);
  complex.reserve(1);
  EXPECT_EQ(complex.allocate(), Simplex(4));
}

TYPED_TEST(ComplexOf, TheRangeOfSimplicesSkipsTheDeadAtEitherEnd) {
  constexpr int Dim = TypeParam::value;
  Complex<Dim> complex;
  EXPECT_TRUE(complex.simplices().begin() == complex.simplices().end());
  complex.reserve(3);
  for (int i = 0; i < 3; ++i) complex.records()[complex.allocate().index()].corner.fill(1);
  complex.release(Simplex(0));
  complex.release(Simplex(2));
  auto it = complex.simplices().begin();
  EXPECT_EQ(*it++, Simplex(1));
  EXPECT_TRUE(it == complex.simplices().end());
  complex.release(Simplex(1));
  EXPECT_TRUE(complex.simplices().begin() == complex.simplices().end());
}

TYPED_TEST(ComplexOf, RefusesMoreSimplicesThanHalfFacetsHaveNumbers) {
  constexpr int Dim = TypeParam::value;
  Complex<Dim> complex = sphere_complex<Dim>();
  EXPECT_THROW(complex.reserve(std::size_t{1} << 30), CapacityError);
  EXPECT_EQ(complex.num_simplices(), static_cast<std::size_t>(Dim + 2));
}

// A stamp tells the vertices numbered in this operation from those of all earlier ones, also when stamps start
// again.
TYPED_TEST(ComplexOf, AFreshStampIsHeldByNoVertex) {
  constexpr int Dim = TypeParam::value;
  Complex<Dim> complex = sphere_complex<Dim>();
  Random random(1);
  for (const int bits : {2, 3}) {
    for (int call = 0; call < 40; ++call) {
      const std::uint32_t stamp = complex.fresh_stamp(bits);
      EXPECT_NE(stamp, 0U);
      EXPECT_EQ(stamp >> bits, 0U);
      for (const auto& vertex : complex.vertices()) EXPECT_NE(vertex.scratch >> (32 - bits), stamp);
      for (auto& vertex : complex.vertices()) {
        if (random() % 3 == 0) vertex.scratch = stamp << (32 - bits) | 5U;
      }
    }
    for (auto& vertex : complex.vertices()) vertex.scratch = 0;
    complex.fresh_stamp(2);
  }
}

}  // namespace
}  // namespace sinkmesh
