// SPDX-License-Identifier: MIT
#include "refine/sub_facets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "test/support/brute_force.h"
#include "test/support/clouds.h"
#include "test/support/dimensions.h"

namespace sinkmesh {
namespace {

template <class T>
class RandomSubFacets : public testing::Test {
 public:
  static constexpr int kSpace = T::value;
  static constexpr std::uint32_t kVertices = kSpace == 2 ? 12 : 8;
  using SubFacets = sinkmesh::SubFacets<kSpace>;
  using Corners = typename SubFacets::Corners;
  using Edge = std::pair<Vertex, Vertex>;

  static Edge edge(Vertex u, Vertex v) { return std::minmax(u, v); }
  static Edge side(const Corners& c, std::size_t k) { return edge(c[(k + 1) % kSpace], c[(k + 2) % kSpace]); }
  /// Some edges are parts of segments, the same whoever asks.
  static std::uint32_t segment_at(const Edge& e) {
    const std::uint32_t sum = 5 * e.first.index() + 3 * e.second.index();
    return sum % 3 == 0 ? sum : SubFacets::kNone;
  }
};
TYPED_TEST_SUITE(RandomSubFacets, test::PlaneAndSpace, test::DimensionName);

// So few vertices that edges have up to six sub-facets.
TYPED_TEST(RandomSubFacets, AgreeWithASetOfTheirCorners) {
  constexpr int kDim = TypeParam::value;
  using Facets = SubFacets<kDim>;
  using Set = typename Facets::Corners;
  std::vector<Set> all;
  test::for_all_subsets<kDim>(TestFixture::kVertices, [&](const test::IdSet<kDim>& ids) {
    all.emplace_back();
    for (std::size_t k = 0; k < kDim; ++k) all.back()[k] = Vertex(ids[k]);
  });

  test::Random random(8);
  Facets facets;
  std::map<Set, std::pair<SubFacet, typename Facets::Record>> model;  // by sorted corners
  std::set<std::pair<SubFacet, std::uint32_t>> past;                  // with births
  std::size_t crowded = 0;
  for (int step = 0; step < 600; ++step) {
    SCOPED_TRACE(step);
    // Fills up, then empties, three times.
    const bool adds = random() % 10 < (step % 200 < 100 ? 8U : 2U);
    const Set& corners = all[random() % all.size()];
    if (adds && !model.contains(corners)) {
      typename Facets::Record record;
      record.corners = corners;
      std::shuffle(record.corners.begin(), record.corners.end(), random);
      record.owner = static_cast<std::uint32_t>(random() % 9);
      record.parent = static_cast<std::uint32_t>(random() % 99);
      record.at = HalfFacet(static_cast<std::uint32_t>(random() % 1000));
      for (std::size_t k = 0; k < kDim; ++k) {
        record.segment[k] = this->segment_at(this->side(record.corners, k));
      }
      const SubFacet f = facets.add(record);
      ASSERT_TRUE(past.insert({f, facets[f].birth}).second) << "a birth twice";
      record.birth = facets[f].birth;
      model[corners] = {f, record};
    } else if (!adds && !model.empty()) {
      const auto victim = std::next(model.begin(), static_cast<std::ptrdiff_t>(random() % model.size()));
      facets.remove(victim->second.first);
      EXPECT_FALSE(facets.is_alive(victim->second.first));
      model.erase(victim);
    }

    ASSERT_EQ(facets.size(), model.size());
    std::map<typename TestFixture::Edge, std::vector<std::pair<SubFacet, std::size_t>>> around;
    for (const auto& [sorted, entry] : model) {
      const auto& [f, record] = entry;
      ASSERT_TRUE(facets.is_current(f, record.birth));
      ASSERT_EQ(facets[f].corners, record.corners);
      ASSERT_EQ(facets[f].owner, record.owner);
      ASSERT_EQ(facets[f].parent, record.parent);
      ASSERT_EQ(facets[f].at, record.at);
      for (std::size_t k = 0; k < kDim; ++k) around[this->side(record.corners, k)].emplace_back(f, k);
    }
    for (const Set& c : all) {
      Set turned = c;
      std::shuffle(turned.begin(), turned.end(), random);
      const auto known = model.find(c);
      ASSERT_EQ(facets.find(turned), known == model.end() ? SubFacet() : known->second.first);
    }
    std::vector<SubFacet> listed;
    facets.for_each([&](SubFacet f) { listed.push_back(f); });
    std::vector<SubFacet> expected;
    for (const auto& [sorted, entry] : model) expected.push_back(entry.first);
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(listed, expected);
    for (const auto& [f, birth] : past) {
      const bool is_current = std::any_of(model.begin(), model.end(), [&, f = f, birth = birth](const auto& m) {
        return m.second.first == f && m.second.second.birth == birth;
      });
      ASSERT_EQ(facets.is_current(f, birth), is_current);
    }
    if constexpr (kDim == 3) {
      test::for_all_subsets<2>(TestFixture::kVertices, [&](const test::IdSet<2>& ids) {
        const Vertex u(ids[step % 2 == 0 ? 0 : 1]);
        const Vertex v(ids[step % 2 == 0 ? 1 : 0]);
        const auto known = around.find(this->edge(u, v));
        std::vector<std::pair<SubFacet, std::size_t>> found;
        for (const auto& side : facets.around(u, v)) found.emplace_back(side.facet, side.k);
        std::sort(found.begin(), found.end());
        if (known == around.end()) {
          ASSERT_TRUE(found.empty());
          ASSERT_TRUE(facets.find_edge(u, v).is_null());
          ASSERT_EQ(facets.segment_of(u, v), Facets::kNone);
          return;
        }
        std::sort(known->second.begin(), known->second.end());
        ASSERT_EQ(found, known->second);
        crowded = std::max(crowded, found.size());
        ASSERT_TRUE(std::any_of(found.begin(), found.end(),
                                [&](const auto& x) { return x.first == facets.find_edge(u, v); }));
        ASSERT_EQ(facets.segment_of(u, v), this->segment_at(this->edge(u, v)));
      });
      for (const auto& [e, sides] : around) {
        for (std::size_t i = 0; i < sides.size(); ++i) {
          const auto across = facets.across(sides[i].first, sides[i].second);
          const auto other = sides.size() == 2 ? sides[1 - i] : std::pair(SubFacet(), std::size_t{0});
          ASSERT_EQ(across.facet, other.first);
          if (sides.size() == 2) {
            ASSERT_EQ(across.k, other.second);
          }
        }
      }
    } else {
      for (const Set& c : all) {
        const auto known = model.find(c);
        ASSERT_EQ(facets.segment_of(c[1], c[0]),
                  known == model.end() ? Facets::kNone : known->second.second.owner);
      }
    }
  }
  EXPECT_GE(crowded, kDim == 3 ? 5U : 0U);
}

}  // namespace
}  // namespace sinkmesh
