// SPDX-License-Identifier: MIT
//
// What is promised of every model, at several sizes; and how close it is to the paper's.
#include "tools/models/models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "test/models/model_facts.h"

namespace sinkmesh::test {
namespace {

using models::Model;

struct Case {
  const char* name;
  double scale;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name << " times " << c.scale; }

class ModelAtScale : public testing::TestWithParam<Case> {};

template <int Dim>
void expect_promises(const Surface<Dim>& surface, std::size_t wanted, std::int64_t genus) {
  const ModelFacts<Dim> facts = facts_of(surface);
  if (!facts.defects.empty()) ADD_FAILURE() << facts.defects.front().message;  // notes, too: not inside out
  EXPECT_TRUE(facts.summary.is_manifold);
  EXPECT_EQ(facts.summary.components, 1U);
  EXPECT_EQ(facts.summary.genus, genus);
  EXPECT_GT(facts.summary.signed_volume, 0);
  EXPECT_EQ(facts.interior_points, 0U);
  EXPECT_EQ(facts.missing_facets, 0U);
  EXPECT_EQ(facts.peeled, 0U);
  EXPECT_EQ(facts.circumcenters_outside, 0U);
  const double triangles = static_cast<double>(Dim == 2 ? facts.quality.simplices() : surface.facets.size());
  EXPECT_NEAR(triangles, static_cast<double>(wanted), 0.02 * static_cast<double>(wanted));
}

TEST_P(ModelAtScale, IsClosedDelaunayAndStable) {
  const Model* const model = models::find_model(GetParam().name);
  ASSERT_NE(model, nullptr);
  const auto wanted =
      static_cast<std::size_t>(std::ceil(GetParam().scale * static_cast<double>(model->triangles) - 1e-6));
  ASSERT_GE(wanted, model->least_triangles());
  ASSERT_LE(wanted, model->most_triangles());
  const std::int64_t genus = model->name == "head" ? 1 : 0;
  std::visit([&](auto* make) { expect_promises(make(wanted), wanted, genus); }, model->make);
}

INSTANTIATE_TEST_SUITE_P(All, ModelAtScale,
                         testing::Values(Case{"usa", 0.1}, Case{"usa", 0.1837}, Case{"usa", 1},
                                         Case{"usa", 1.27}, Case{"usa", 3.331}, Case{"usa", 10},
                                         Case{"cuboctahedron", 0.1}, Case{"cuboctahedron", 0.377},
                                         Case{"cuboctahedron", 1}, Case{"cuboctahedron", 1.7},
                                         Case{"paraboloid", 0.1}, Case{"paraboloid", 0.2718},
                                         Case{"paraboloid", 1}, Case{"paraboloid", 2.3}, Case{"star", 0.1},
                                         Case{"star", 0.1101}, Case{"star", 0.2345}, Case{"star", 1},
                                         Case{"star", 1.618}, Case{"star", 10}, Case{"head", 0.1},
                                         Case{"head", 0.1061}, Case{"head", 0.5432}, Case{"head", 1}));

struct PaperRow {
  const char* name;
  double simplices;
  Ratios surface;
  Ratios inside;
  double tolerance;          // relative
  double minimum_tolerance;  // of the smallest ratio inside
};

class ModelOfThePaper : public testing::TestWithParam<PaperRow> {};

void expect_near(const Ratios& ours, const Ratios& paper, const PaperRow& row, double minimum_tolerance) {
  EXPECT_NEAR(ours.min, paper.min, minimum_tolerance * paper.min);
  EXPECT_NEAR(ours.average, paper.average, row.tolerance * paper.average);
  EXPECT_NEAR(ours.max, paper.max, row.tolerance * paper.max);
}

template <int Dim>
void expect_near_paper(const Surface<Dim>& surface, const PaperRow& row) {
  const ModelFacts<Dim> facts = facts_of(surface);
  EXPECT_NEAR(static_cast<double>(facts.quality.simplices()), row.simplices, row.tolerance * row.simplices);
  if constexpr (Dim == 3) expect_near(facts.surface, row.surface, row, 0.02);
  const QualityStatistics& inside = facts.quality;
  expect_near({inside.min_ratio(), inside.average_ratio(), inside.max_ratio()}, row.inside, row,
              row.minimum_tolerance);
}

TEST_P(ModelOfThePaper, HasItsRatios) {
  const Model& model = *models::find_model(GetParam().name);
  std::visit([&](auto* make) { expect_near_paper(make(model.triangles), GetParam()); }, model.make);
}

// [EG01, figures 7-11]; but the paper's USA, of which only the number of triangles is known besides the ratios,
// 0.61, 2.36 and 17.23, is another outline: here are those of ours. The smallest ratio of the paper's
// paraboloid is larger than ours, 0.65.
INSTANTIATE_TEST_SUITE_P(
    All, ModelOfThePaper,
    testing::Values(PaperRow{"usa", 229, {}, {0.584, 1.947, 11.98}, 0.001, 0.001},
                    PaperRow{"cuboctahedron", 14670, {0.58, 0.70, 1.05}, {0.71, 7.29, 22.80}, 0.08, 0.03},
                    PaperRow{"paraboloid", 10050, {0.58, 0.80, 1.31}, {0.87, 18.77, 90.75}, 0.13, 0.27},
                    PaperRow{"star", 78114, {0.578, 1.315, 1.601}, {0.68, 2.40, 14.09}, 0.03, 0.05},
                    PaperRow{"head", 100454, {0.577, 1.206, 1.601}, {0.67, 4.11, 8.67}, 0.05, 0.15}),
    [](const auto& row) { return row.param.name; });

TEST(Models, AreTheSameEveryTime) {
  for (const Model& model : models::all_models()) {
    SCOPED_TRACE(model.name);
    std::visit(
        [&](auto* make) {
          const auto first = make(model.least_triangles());
          const auto second = make(model.least_triangles());
          EXPECT_EQ(first.points, second.points);
          EXPECT_EQ(first.facets, second.facets);
        },
        model.make);
  }
}

TEST(Models, AreFoundByName) {
  EXPECT_EQ(models::all_models().size(), 5U);
  EXPECT_EQ(models::find_model("Star"), nullptr);
  EXPECT_EQ(models::find_model(""), nullptr);
}

}  // namespace
}  // namespace sinkmesh::test
