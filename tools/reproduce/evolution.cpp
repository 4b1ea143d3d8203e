// SPDX-License-Identifier: MIT
#include "tools/reproduce/evolution.h"

#include <algorithm>

#include "tools/reproduce/chart.h"
#include "tools/reproduce/paper.h"

namespace sinkmesh::reproduce {
namespace {

template <class Value>
Curve curve(const Run& run, int colour, std::size_t first_round, Value&& value) {
  Curve result{colour, run.plan.insert == Insert::circumcenter, {}};
  for (std::size_t k = first_round; k < run.rounds.size(); ++k) {
    result.points.push_back({static_cast<double>(k), static_cast<double>(value(run.rounds[k]))});
  }
  return result;
}

const PaperRow* paper_row(const PaperModel& paper, Schedule schedule) {
  const auto found = std::find_if(paper.rows.begin(), paper.rows.end(), [&](const PaperRow& row) {
    return row.insert == Insert::sink && row.schedule == schedule;
  });
  return found == paper.rows.end() ? nullptr : &*found;
}

}  // namespace

std::vector<std::string> evolution_charts(const Study& study, Schedule schedule) {
  const Run& sinks = study.run({Insert::sink, schedule, true});
  const Run& circumcenters = study.run({Insert::circumcenter, schedule, true});
  const PaperModel& paper = paper_model(study.model);
  const PaperRow* const row = paper_row(paper, schedule);
  const auto last = static_cast<double>(sinks.rounds.size() - 1);
  const std::string simplices = study.dimension == 2 ? "triangles" : "tetrahedra";

  const auto begin = [&](const std::string& name, const std::string& title, const std::string& description) {
    Chart chart;
    chart.id = study.model + "-" + name;
    chart.title = title;
    chart.description = description;
    chart.x_label = "round";
    chart.solid_name = "sinks";
    chart.dashed_name = "circumcenters";
    return chart;
  };
  const auto add = [&](Chart& chart, std::size_t first_round, auto value) {
    const int colour = static_cast<int>(chart.curves.size() / 2);
    chart.curves.push_back(curve(sinks, colour, first_round, value));
    chart.curves.push_back(curve(circumcenters, colour, first_round, value));
  };

  Chart size = begin("size", "Size", "All " + simplices + " and those of low quality after each round.");
  size.y_label = simplices;
  size.colour_names = {"all", "low quality"};
  add(size, 0, [](const Round& r) { return r.mesh.simplices; });
  add(size, 0, [](const Round& r) { return r.mesh.low_quality; });
  size.paper.push_back({0, static_cast<double>(paper.initial.simplices)});
  if (row != nullptr) size.paper.push_back({last, static_cast<double>(row->simplices)});
  if (paper.initial.low_quality) size.paper.push_back({0, static_cast<double>(*paper.initial.low_quality)});
  if (row != nullptr && row->low_quality) {
    size.paper.push_back({last, static_cast<double>(*row->low_quality)});
  }

  Chart candidates = begin("candidates", "Candidates",
                           "Candidates of each round, those that pass the boundary test, and those inserted.");
  candidates.y_label = "points, logarithmic";
  candidates.y_scale = AxisScale::logarithmic;
  candidates.colour_names = {"candidates", "pass the test",
                             schedule == Schedule::block ? "in the block" : "independent"};
  add(candidates, 1, [](const Round& r) { return r.candidates; });
  add(candidates, 1, [](const Round& r) { return r.passed_boundary; });
  add(candidates, 1, [](const Round& r) { return r.inserted; });

  Chart ratio = begin("ratio", "Quality", "Largest, average and smallest ratio r/l after each round.");
  ratio.y_label = "r/l, logarithmic";
  ratio.y_scale = AxisScale::logarithmic;
  ratio.colour_names = {"largest", "average", "smallest"};
  add(ratio, 0, [](const Round& r) { return r.mesh.ratio_max; });
  add(ratio, 0, [](const Round& r) { return r.mesh.ratio_avg; });
  add(ratio, 0, [](const Round& r) { return r.mesh.ratio_min; });
  ratio.paper = {{0, paper.initial.ratio_max}, {0, paper.initial.ratio_avg}, {0, paper.initial.ratio_min}};
  if (row != nullptr) {
    ratio.paper.insert(ratio.paper.end(),
                       {{last, row->ratio_max}, {last, row->ratio_avg}, {last, row->ratio_min}});
  }
  return {draw(size), draw(candidates), draw(ratio)};
}

}  // namespace sinkmesh::reproduce
