// SPDX-License-Identifier: MIT
//
// Labels of solids made of cubes, where the material of each simplex is known beforehand.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "refine/domain.h"
#include "test/support/dimensions.h"
#include "test/support/voxels.h"

namespace sinkmesh {
namespace {

template <class T>
class DomainRegions : public testing::Test {
 public:
  static constexpr int kSpace = T::value;
  using Domain = sinkmesh::Domain<kSpace>;
  using Voxels = test::Voxels<kSpace>;
  static constexpr int kSize = kSpace == 2 ? 8 : 6;

  static Point<kSpace> all(double x) {
    Point<kSpace> p;
    p.fill(x);
    return p;
  }
  static Point<kSpace> with_first(double first, double others) {
    Point<kSpace> p = all(others);
    p[0] = first;
    return p;
  }

  /// What must be inside, by component of equal material; each component that is becomes a region.
  static void expect_labels(const Voxels& voxels, const Domain& domain, const std::vector<bool>& is_inside) {
    const Complex<kSpace>& complex = voxels.triangulation().complex();
    const auto component = voxels.components();
    std::map<std::uint32_t, std::set<std::uint32_t>> regions;  // by component
    std::map<std::uint32_t, Point<kSpace>> least;              // by region
    for (const Simplex s : complex.simplices()) {
      if (complex.is_ghost(s)) {
        ASSERT_FALSE(domain.is_inside(s));
        continue;
      }
      const std::uint32_t c = component[voxels.voxel_of(s)];
      ASSERT_EQ(domain.is_inside(s), is_inside[c]) << s << " in component " << c;
      if (!is_inside[c]) continue;
      regions[c].insert(domain.region(s));
      for (const Point<kSpace>* p : complex.corners(s)) {
        const auto known = least.try_emplace(domain.region(s), *p).first;
        known->second = std::min(known->second, *p);
      }
    }
    std::set<std::uint32_t> all_regions;
    for (const auto& [c, numbers] : regions) {
      ASSERT_EQ(numbers.size(), 1U) << "component " << c << " has several regions";
      ASSERT_TRUE(all_regions.insert(*numbers.begin()).second) << "one region for two components";
    }
    EXPECT_EQ(domain.num_regions(), all_regions.size());
    EXPECT_EQ(*all_regions.begin(), 1U);
    EXPECT_EQ(*all_regions.rbegin(), all_regions.size());
    Point<kSpace> before = all(-HUGE_VAL);
    for (const auto& [region, p] : least) {
      EXPECT_LE(before, p) << "regions are not numbered by their least vertices";
      before = p;
    }
  }
  static std::vector<bool> by_material(const Voxels& voxels) {
    std::vector<bool> is_inside(voxels.num_voxels(), false);
    const auto component = voxels.components();
    for (std::size_t v = 0; v < voxels.num_voxels(); ++v) is_inside[component[v]] = voxels.material(v) != 0;
    return is_inside;
  }
  static Domain labelled(const Voxels& voxels, std::vector<HalfFacet> interfaces,
                         const Seeds<kSpace>& seeds = {}) {
    Domain domain(voxels.triangulation());
    EXPECT_TRUE(domain.label_facets(voxels.facets(interfaces), seeds).empty());
    return domain;
  }
  static void expect_materials(const Voxels& voxels) {
    expect_labels(voxels, labelled(voxels, voxels.interfaces()), by_material(voxels));
  }
  static void expect_refused(const Voxels& voxels, const std::vector<HalfFacet>& interfaces,
                             const Seeds<kSpace>& seeds = {}) {
    Domain domain(voxels.triangulation());
    EXPECT_THROW((void)domain.label_facets(voxels.facets(interfaces), seeds), InputError);
    EXPECT_TRUE(domain.simplices().empty());
  }
};
TYPED_TEST_SUITE(DomainRegions, test::PlaneAndSpace, test::DimensionName);

TYPED_TEST(DomainRegions, NestedBoxesAlternate) {
  typename TestFixture::Voxels voxels(8);
  voxels.fill(this->all(1), this->all(7), 1);
  voxels.fill(this->all(2), this->all(6), 0);
  voxels.fill(this->all(3), this->all(5), 1);
  this->expect_materials(voxels);
}

TYPED_TEST(DomainRegions, BoxesThatShareASideAreTwoRegions) {
  typename TestFixture::Voxels voxels(6);
  voxels.fill(this->with_first(1, 1), this->with_first(3, 4), 1);
  voxels.fill(this->with_first(3, 1), this->with_first(5, 4), 2);
  this->expect_materials(voxels);
  // One of them smaller: the shared side is a part of the other's.
  voxels.fill(this->with_first(3, 3), this->with_first(5, 4), 0);
  this->expect_materials(voxels);
}

TYPED_TEST(DomainRegions, PartsThatTouchInAVertexOrAnEdgeStayApart) {
  typename TestFixture::Voxels voxels(6);
  voxels.fill(this->all(1), this->all(3), 1);
  voxels.fill(this->all(3), this->all(5), 1);
  this->expect_materials(voxels);
  voxels.fill(this->all(1), this->all(5), 0);
  voxels.fill(this->all(1), this->all(3), 1);
  auto low = this->all(3);
  low[TestFixture::kSpace - 1] = 1;
  voxels.fill(low, this->all(5), 1);
  this->expect_materials(voxels);
}

TYPED_TEST(DomainRegions, RingsAndCavitiesThatTouchTheOutsideAreCrossedByParity) {
  typename TestFixture::Voxels voxels(6);
  voxels.fill(this->all(1), this->all(5), 1);
  // In space a tunnel, in the plane a bay: both open to the outside.
  auto low = this->all(2);
  auto high = this->all(4);
  low[0] = 0;
  high[0] = TestFixture::kSpace == 3 ? 6 : 4;
  voxels.fill(low, high, 0);
  this->expect_materials(voxels);
  // A cavity that touches the outside in a vertex only.
  voxels.fill(this->all(1), this->all(5), 1);
  voxels.fill(this->all(1), this->all(2), 0);
  voxels.fill(this->all(2), this->all(3), 0);
  this->expect_materials(voxels);
}

// Rings, cavities, touching parts in any combination; with one material every ridge has an even number of
// facets.
TYPED_TEST(DomainRegions, RandomCubesAreTheirMaterial) {
  test::Random random(3);
  typename TestFixture::Voxels voxels(TestFixture::kSize);
  for (int round = 0; round < 30; ++round) {
    SCOPED_TRACE(round);
    voxels.fill_at_random(1, random);
    voxels.material(voxels.num_voxels() / 2 + 3) = 1;
    this->expect_materials(voxels);
  }
}

// Any number of materials, if nothing is enclosed by them that is none.
TYPED_TEST(DomainRegions, RandomMaterialsAreRegions) {
  test::Random random(4);
  typename TestFixture::Voxels voxels(TestFixture::kSize);
  for (int round = 0; round < 20; ++round) {
    SCOPED_TRACE(round);
    voxels.fill_at_random(3, random);
    const auto component = voxels.components();
    for (std::size_t v = 0; v < voxels.num_voxels(); ++v) {
      if (voxels.material(v) == 0 && component[v] != component[0]) voxels.material(v) = 1;
    }
    this->expect_materials(voxels);
  }
}

TYPED_TEST(DomainRegions, NumbersAndLabelsDoNotDependOnTheOrderOfFacets) {
  test::Random random(5);
  typename TestFixture::Voxels voxels(TestFixture::kSize);
  for (int round = 0; round < 5; ++round) {
    voxels.fill_at_random(1, random);
    auto interfaces = voxels.interfaces();
    const auto first = this->labelled(voxels, interfaces);
    std::shuffle(interfaces.begin(), interfaces.end(), random);
    for (HalfFacet& h : interfaces) h = random() % 2 ? h : voxels.triangulation().complex().mate(h);
    const auto second = this->labelled(voxels, interfaces);
    for (const Simplex s : voxels.triangulation().complex().simplices()) {
      ASSERT_EQ(first.region(s), second.region(s)) << s;
    }
  }
}

// Free in the inside of a region, and attached to its border.
TYPED_TEST(DomainRegions, MembranesDivideNothing) {
  constexpr int kDim = TypeParam::value;
  typename TestFixture::Voxels voxels(6);
  voxels.fill(this->all(1), this->all(5), 1);
  const Complex<kDim>& complex = voxels.triangulation().complex();
  for (const bool is_attached : {false, true}) {
    SCOPED_TRACE(is_attached);
    auto interfaces = voxels.interfaces();
    const std::size_t border = interfaces.size();
    for (const Simplex s : complex.simplices()) {
      for (int i = 0; i <= kDim; ++i) {
        const Simplex t = complex.neighbor(s, i);
        if (t < s || voxels.material_of(s) == 0 || voxels.material_of(t) == 0) continue;
        // In the plane x = 3, either near the middle or up to the border.
        const auto facet = complex.facet(Complex<kDim>::half_facet(s, i));
        const bool is_membrane = std::all_of(facet.begin(), facet.end(), [&](Vertex v) {
          const Point<kDim> p = voxels.triangulation().point(v);
          return p[0] == 3 && std::all_of(p.begin() + 1, p.end(),
                                          [&](double x) { return is_attached ? x <= 4 : x >= 2 && x <= 4; });
        });
        if (is_membrane) interfaces.push_back(Complex<kDim>::half_facet(s, i));
      }
    }
    ASSERT_GT(interfaces.size(), border + 1);
    const auto domain = this->labelled(voxels, interfaces);
    this->expect_labels(voxels, domain, this->by_material(voxels));
    EXPECT_EQ(domain.boundary().size(), interfaces.size());
    for (const HalfFacet h : interfaces) {
      EXPECT_TRUE(domain.is_wall(h));
      EXPECT_TRUE(domain.is_wall(complex.mate(h)));
    }
  }
}

// With seeds every bounded part is inside but those with a hole; tags go with the regions.
TYPED_TEST(DomainRegions, SeedsDecideInsteadOfParity) {
  constexpr int kDim = TypeParam::value;
  test::Random random(6);
  typename TestFixture::Voxels voxels(TestFixture::kSize);
  for (int round = 0; round < 20; ++round) {
    SCOPED_TRACE(round);
    voxels.fill_at_random(2, random);
    const auto component = voxels.components();
    std::vector<bool> is_inside(voxels.num_voxels(), true);
    is_inside[component[0]] = false;
    Seeds<kDim> seeds;
    std::map<std::uint32_t, std::int64_t> tag_of;  // by component
    for (std::size_t v = 0; v < voxels.num_voxels(); ++v) {
      if (component[v] == component[0] || random() % 4 != 0 || tag_of.contains(component[v])) continue;
      if (random() % 2 == 0 && is_inside[component[v]]) {
        seeds.holes.push_back(voxels.middle(v));
        is_inside[component[v]] = false;
      } else if (is_inside[component[v]]) {
        tag_of[component[v]] = static_cast<std::int64_t>(random() % 100) - 50;
        seeds.regions.push_back({voxels.middle(v), tag_of[component[v]]});
      }
    }
    if (seeds.empty() || std::count(is_inside.begin(), is_inside.end(), true) == 0) continue;
    const auto domain = this->labelled(voxels, voxels.interfaces(), seeds);
    this->expect_labels(voxels, domain, is_inside);
    for (const Simplex s : domain.simplices()) {
      const auto known = tag_of.find(component[voxels.voxel_of(s)]);
      ASSERT_EQ(domain.tag(domain.region(s)), known == tag_of.end() ? 0 : known->second);
    }
  }
}

// The boundary: each wall with the inside on a side once, the half-facet of the smaller region.
TYPED_TEST(DomainRegions, BoundaryListsEveryWallOfTheInsideOnce) {
  constexpr int kDim = TypeParam::value;
  test::Random random(7);
  typename TestFixture::Voxels voxels(TestFixture::kSize);
  const Complex<kDim>& complex = voxels.triangulation().complex();
  for (int round = 0; round < 10; ++round) {
    voxels.fill_at_random(3, random);
    const auto component = voxels.components();
    Seeds<kDim> seeds;
    for (std::size_t v = 0; v < voxels.num_voxels() && seeds.holes.size() < 2; ++v) {
      if (component[v] != component[0]) seeds.holes.push_back(voxels.middle(v));
    }
    const auto interfaces = voxels.interfaces();
    const auto domain = this->labelled(voxels, interfaces, seeds);
    std::vector<HalfFacet> expected;
    for (const HalfFacet h : interfaces) {
      const auto one = domain.region(Complex<kDim>::simplex_of(h));
      const auto other = domain.region(Complex<kDim>::simplex_of(complex.mate(h)));
      if (one == 0 && other == 0) continue;
      expected.push_back(other == 0 || (one != 0 && one < other) ? h : complex.mate(h));
    }
    auto boundary = domain.boundary();
    std::sort(boundary.begin(), boundary.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(boundary, expected);
  }
}

TYPED_TEST(DomainRegions, WhatEnclosesNothingIsRefused) {
  constexpr int kDim = TypeParam::value;
  typename TestFixture::Voxels voxels(6);
  voxels.fill(this->all(1), this->all(5), 1);
  const auto closed = voxels.interfaces();
  auto open = closed;
  open.pop_back();
  this->expect_refused(voxels, open);
  this->expect_refused(voxels, std::vector<HalfFacet>(closed.begin(), closed.begin() + 3));

  Seeds<kDim> hole;
  hole.holes.push_back(this->all(2.4));
  this->expect_refused(voxels, closed, hole);
  for (const double outside : {0.4, -3.0, 1e30}) {
    Seeds<kDim> region;
    region.regions.push_back({this->all(outside), 7});
    this->expect_refused(voxels, closed, region);
    Seeds<kDim> seeds;
    seeds.holes.push_back(this->all(outside));
    this->expect_refused(voxels, closed, seeds);
  }
}

// A point on the surface belongs to neither side, and one region has one tag.
TYPED_TEST(DomainRegions, SeedsMustBeUnambiguous) {
  constexpr int kDim = TypeParam::value;
  typename TestFixture::Voxels voxels(6);
  voxels.fill(this->all(1), this->all(5), 1);
  const auto closed = voxels.interfaces();
  Point<kDim> on_edge = this->all(1);
  on_edge[0] = 2.4;
  for (const Point<kDim>& on : {this->all(1), on_edge, this->with_first(1, 2.4), this->with_first(5, 3)}) {
    Seeds<kDim> region;
    region.regions.push_back({on, 7});
    this->expect_refused(voxels, closed, region);
    Seeds<kDim> hole;
    hole.holes.push_back(on);
    this->expect_refused(voxels, closed, hole);
  }
  for (const Point<kDim>& inside : {this->all(2), this->with_first(2, 2.4), this->with_first(3, 3.4)}) {
    Seeds<kDim> seeds;
    seeds.regions.push_back({inside, 7});
    EXPECT_EQ(this->labelled(voxels, closed, seeds).tag(1), 7);
    seeds.regions.push_back({this->all(4.4), 7});
    EXPECT_EQ(this->labelled(voxels, closed, seeds).tag(1), 7);
    seeds.regions.push_back({this->all(4.1), 8});
    this->expect_refused(voxels, closed, seeds);
  }
}

}  // namespace
}  // namespace sinkmesh
