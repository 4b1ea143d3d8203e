// SPDX-License-Identifier: MIT
#include "tools/reproduce/data_files.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tools/reproduce/paper.h"

namespace sinkmesh::reproduce {
namespace {

using Json = nlohmann::ordered_json;

template <class Numbers>
Json ratio_json(const Numbers& numbers) {
  return {{"min", numbers.ratio_min}, {"avg", numbers.ratio_avg}, {"max", numbers.ratio_max}};
}

Json to_json(const MeshNumbers& mesh) {
  return {{"simplices", mesh.simplices}, {"low_quality", mesh.low_quality}, {"ratio", ratio_json(mesh)}};
}

template <class Row>
Json paper_json(const Row& row) {
  return {{"simplices", row.simplices},
          {"low_quality", row.low_quality ? Json(*row.low_quality) : Json()},
          {"ratio", ratio_json(row)}};
}

Json to_json(const PaperModel& paper) {
  Json rows = Json::array();
  for (const PaperRow& row : paper.rows) {
    Json entry = paper_json(row);
    entry["insert"] = name(row.insert);
    entry["schedule"] = name(row.schedule);
    entry["minutes"] = row.minutes ? Json(*row.minutes) : Json();
    rows.push_back(entry);
  }
  return {{"figure", paper.figure}, {"initial", paper_json(paper.initial)}, {"runs", rows}};
}

Json to_json(const Run& run) {
  return {{"insert", name(run.plan.insert)},
          {"schedule", name(run.plan.schedule)},
          {"literal", run.plan.literal},
          {"final", to_json(run.mesh)},
          {"rounds", run.result.rounds},
          {"candidates", run.result.candidates},
          {"prestars", run.result.prestars},
          {"inserted", run.result.inserted},
          {"rejected",
           {{"boundary", run.result.rejected.boundary},
            {"crossing", run.result.rejected.crossing},
            {"separation", run.result.rejected.separation},
            {"dependent", run.result.rejected.dependent}}},
          {"hash", fmt::format("{:016x}", run.hash)},
          {"cpu_seconds", run.cpu_seconds}};
}

std::string plan_csv(const Study& study, const Plan& plan) {
  return fmt::format("{},{},{},{}", study.model, name(plan.insert), name(plan.schedule), plan.literal ? 1 : 0);
}

std::string mesh_csv(const MeshNumbers& mesh) {
  return fmt::format("{},{},{},{},{}", mesh.simplices, mesh.low_quality, mesh.ratio_min, mesh.ratio_avg,
                     mesh.ratio_max);
}

}  // namespace

std::string results_json(const std::vector<Study>& studies, const std::string& machine) {
  Json models = Json::array();
  for (const Study& study : studies) {
    Json runs = Json::array();
    for (const Run& run : study.runs) runs.push_back(to_json(run));
    models.push_back(
        {{"model", study.model},
         {"dimension", study.dimension},
         {"max_ratio", study.max_ratio},
         {"surface", to_json(study.surface)},
         {"initial", to_json(study.initial)},
         {"initial_sinks", study.sinks},
         {"error_of_plain_centers",
          {{"sinks", study.conditioning.sinks}, {"circumcenters", study.conditioning.circumcenters}}},
         {"paper", to_json(paper_model(study.model))},
         {"runs", runs}});
  }
  return Json{{"program", "sinkmesh"}, {"machine", machine}, {"models", models}}.dump(2) + "\n";
}

std::string runs_csv(const std::vector<Study>& studies) {
  std::string csv =
      "model,insert,schedule,literal,simplices,low_quality,ratio_min,ratio_avg,ratio_max,inserted,rounds,"
      "candidates,prestars,cpu_seconds\n";
  for (const Study& study : studies) {
    for (const Run& run : study.runs) {
      csv += fmt::format("{},{},{},{},{},{},{}\n", plan_csv(study, run.plan), mesh_csv(run.mesh),
                         run.result.inserted, run.result.rounds, run.result.candidates, run.result.prestars,
                         run.cpu_seconds);
    }
  }
  return csv;
}

std::string rounds_csv(const std::vector<Study>& studies) {
  std::string csv =
      "model,insert,schedule,literal,round,simplices,low_quality,ratio_min,ratio_avg,ratio_max,candidates,"
      "passed_boundary,inserted\n";
  for (const Study& study : studies) {
    for (const Run& run : study.runs) {
      for (std::size_t k = 0; k < run.rounds.size(); ++k) {
        const Round& round = run.rounds[k];
        csv += fmt::format("{},{},{},{},{},{}\n", plan_csv(study, run.plan), k, mesh_csv(round.mesh),
                           round.candidates, round.passed_boundary, round.inserted);
      }
    }
  }
  return csv;
}

}  // namespace sinkmesh::reproduce
