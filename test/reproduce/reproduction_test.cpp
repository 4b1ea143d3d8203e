// SPDX-License-Identifier: MIT
//
// The whole page, on models a tenth of the paper's size.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <variant>

#include "refine/refine.h"
#include "tools/models/models.h"
#include "tools/reproduce/claims.h"
#include "tools/reproduce/html_table.h"
#include "tools/reproduce/paper.h"
#include "tools/reproduce/reproduce.h"

namespace sinkmesh::reproduce {
namespace {

Models small_models() {
  Models result;
  for (const models::Model& model : models::all_models()) {
    if (const auto* const make = std::get_if<Surface2 (*)(std::size_t)>(&model.make)) {
      result.usa = (*make)(model.triangles);
    } else {
      result.in_space.emplace_back(model.name,
                                   std::get<Surface3 (*)(std::size_t)>(model.make)(model.least_triangles()));
    }
  }
  return result;
}

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(Reproduction, HasEveryFigureTableChartAndRun) {
  std::size_t steps = 0;
  std::map<std::string, std::string> files;
  for (const File& file : reproduce(small_models(), "a machine & more", [&](std::string_view) { ++steps; })) {
    EXPECT_TRUE(files.emplace(file.name, file.bytes).second) << file.name;
  }
  EXPECT_EQ(steps, 12 + 4 * 10 + 5U);
  const std::string& page = files["index.html"];
  for (int figure = 1; figure <= 7; ++figure) {
    EXPECT_EQ(occurrences(page, "id=\"figure-" + std::to_string(figure) + "\""), 1U) << figure;
  }
  EXPECT_EQ(occurrences(page, "<table>"), 1 + 5 * 2 + 1U);
  EXPECT_EQ(occurrences(page, "id=\"off-sinks\""), 1U);
  for (const char* const model : {"usa", "cuboctahedron", "paraboloid", "star", "head"}) {
    for (const char* const chart : {"size", "candidates", "ratio"}) {
      EXPECT_EQ(occurrences(page, "id=\"" + std::string(model) + "-" + chart + "\""), 1U) << model << chart;
    }
  }
  EXPECT_EQ(occurrences(page, "data:image/png;base64,"), 20U);
  EXPECT_EQ(occurrences(page, "a machine &amp; more"), 1U);
  // From disk, without a network.
  EXPECT_EQ(occurrences(page, "<script"), 0U);
  EXPECT_EQ(occurrences(page, "<link"), 0U);
  EXPECT_EQ(occurrences(page, "http://"), occurrences(page, "http://www.w3.org/2000/svg"));
  EXPECT_EQ(occurrences(page, "https://"), 0U);

  EXPECT_EQ(occurrences(files["runs.csv"], "\n"), 1 + 12 + 4 * 10U);
  EXPECT_EQ(occurrences(files["results.json"], "\"cpu_seconds\""), 12 + 4 * 10U);
  EXPECT_EQ(files.size(), 4 + 7 + 20U);
  EXPECT_EQ(files["figure-7.svg"].substr(0, 4), "<svg");
  EXPECT_EQ(files["head-after.png"].substr(1, 3), "PNG");
  EXPECT_GT(occurrences(files["rounds.csv"], "\n"), 200U);
}

// The run is the program's own, and its last round is the final mesh.
TEST(Study, TellsWhatRefinementDid) {
  const Surface3 surface = models::make_cuboctahedron(750);
  const Plan plan{Insert::sink, Schedule::parallel, false};
  const reproduce::Run run = refine_as<3>(surface, 2, plan);
  SurfaceMesher3 mesher(surface);
  mesher.find_domain();
  RefineOptions options;
  options.insert = Insert::sink;
  options.schedule = Schedule::parallel;
  const RefineResult expected = mesher.refine(options);
  EXPECT_EQ(run.hash, mesher.hash());
  EXPECT_EQ(run.result.candidates, expected.candidates);
  EXPECT_EQ(run.rounds.size(), expected.rounds + 1);
  EXPECT_EQ(run.rounds.back().mesh.simplices, run.mesh.simplices);
  std::size_t inserted = 0;
  for (const Round& round : run.rounds) inserted += round.inserted;
  EXPECT_EQ(inserted, expected.inserted);
  EXPECT_GT(run.cpu_seconds, 0);
}

TEST(Study, KnowsTheInitialMesh) {
  const Study study = begin_study<2>("usa", models::make_usa(229), 1);
  EXPECT_EQ(study.facets, 231U);
  EXPECT_EQ(study.initial.simplices, 229U);
  EXPECT_EQ(study.sinks, 80U);
  EXPECT_GT(study.conditioning.circumcenters, 0);
  EXPECT_LT(study.conditioning.circumcenters, 1e-9);
  EXPECT_THROW((void)study.run({}), std::out_of_range);
}

Run made_up(Insert insert, Schedule schedule, bool literal, std::size_t simplices, double seconds) {
  Run run;
  run.plan = {insert, schedule, literal};
  run.mesh = {simplices, 0, 0.6, 1.2, 2};
  run.result.candidates = insert == Insert::sink ? 100 : 500;
  run.rounds.resize(2);
  run.hash = 7;
  run.cpu_seconds = seconds;
  return run;
}

std::vector<Study> made_up_studies(std::size_t circumcenter_simplices, double circumcenter_seconds) {
  Study study;
  study.model = "star";
  study.conditioning = {1e-15, 1e-12};
  for (const Insert insert : {Insert::sink, Insert::circumcenter}) {
    const bool sink = insert == Insert::sink;
    for (const Schedule schedule : {Schedule::incremental, Schedule::block, Schedule::parallel}) {
      study.runs.push_back(made_up(insert, schedule, false, sink ? 1000 : circumcenter_simplices,
                                   sink ? 1 : circumcenter_seconds));
    }
    study.runs.push_back(made_up(insert, Schedule::parallel, true, sink ? 1000 : circumcenter_simplices,
                                 sink ? 1 : circumcenter_seconds));
  }
  return {study};
}

// In the order of weigh_claims(): quality, shared sinks, parallel, every schedule, schedules, conditioning,
// pruned.
std::vector<std::string> verdicts(const std::vector<Study>& studies) {
  std::vector<std::string> result;
  for (const Claim& claim : weigh_claims(studies)) result.push_back(claim.verdict);
  return result;
}

TEST(Claims, AreDecidedByTheNumbers) {
  EXPECT_EQ(verdicts(made_up_studies(1020, 5)), std::vector<std::string>(7, "holds"));
  EXPECT_EQ(verdicts(made_up_studies(2000, 1.1))[0], "does not hold");
  EXPECT_EQ(verdicts(made_up_studies(1020, 1.1))[2], "does not hold");
  EXPECT_EQ(verdicts(made_up_studies(1020, 1.1))[3], "holds in part");
  EXPECT_EQ(verdicts(made_up_studies(1020, 0.9))[3], "does not hold");
  std::vector<Study> studies = made_up_studies(1020, 5);
  studies[0].runs.back().hash = 8;
  EXPECT_EQ(verdicts(studies)[6], "does not hold");
  studies[0].conditioning = {1e-12, 1e-15};
  EXPECT_EQ(verdicts(studies)[5], "does not hold");
}

TEST(Tables, PutThePapersNumbersBesideOurs) {
  const std::vector<Study> studies = made_up_studies(1020, 5);
  const std::string meshes = mesh_table(studies[0]);
  for (const char* const number : {"118,633", "119,442", "481", "1,867", "78,114", "1,000", "1,020"}) {
    EXPECT_NE(meshes.find(number), std::string::npos) << number;
  }
  const std::string costs = cost_table(studies[0]);
  EXPECT_NE(costs.find("<td>5.00</td><td>4.83</td>"), std::string::npos) << costs;  // ours, and 58 min / 12 min
}

TEST(Tables, PutOffSinksBesideTheOthers) {
  std::vector<Study> studies = made_up_studies(1020, 5);
  for (const Schedule schedule : {Schedule::incremental, Schedule::block}) {
    studies[0].runs.push_back(made_up(Insert::off_sink, schedule, false, 900, 2));
  }
  const std::string table = off_sink_table(studies);
  const auto cells = [](const char* simplices) { return "<b>" + std::string(simplices) + "</b>"; };
  EXPECT_EQ(occurrences(table, cells("1,020")), 2U);
  EXPECT_EQ(occurrences(table, cells("1,000")), 2U);
  EXPECT_EQ(occurrences(table, cells("900")), 2U);
  EXPECT_NE(table.find("star, offsink"), std::string::npos);
}

TEST(Paper, KnowsFiveModels) {
  EXPECT_EQ(paper_model("usa").rows.size(), 4U);
  for (const char* const model : {"cuboctahedron", "paraboloid", "star", "head"}) {
    EXPECT_EQ(paper_model(model).rows.size(), 2U);
  }
  EXPECT_THROW((void)paper_model("teapot"), InputError);
}

}  // namespace
}  // namespace sinkmesh::reproduce
