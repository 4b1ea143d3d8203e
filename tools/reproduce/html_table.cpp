// SPDX-License-Identifier: MIT
#include "tools/reproduce/html_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tools/reproduce/paper.h"
#include "tools/text/numbers.h"

namespace sinkmesh::reproduce {
namespace {

using Cells = std::vector<std::string>;

constexpr const char* kNone = "–";

using text::grouped;

// As many digits as the paper prints.
std::string measure(double value) {
  if (!std::isfinite(value)) return "∞";
  return fmt::format("{:.{}f}", value, std::abs(value) < 1 ? 3 : std::abs(value) < 10 ? 2 : 1);
}

// The first cell is a heading.
std::string row(const Cells& cells, const char* of_row = "") {
  std::string html = fmt::format("<tr{}>", of_row);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    html += i == 0 ? fmt::format("<th scope=\"row\">{}</th>", cells[i]) : fmt::format("<td>{}</td>", cells[i]);
  }
  return html + "</tr>\n";
}

std::string table(const std::string& caption, const std::string& head, const std::string& body) {
  return fmt::format(
      "<div class=\"scroll\"><table><caption>{}</caption><thead>{}</thead><tbody>\n{}</tbody></table></div>\n",
      caption, head, body);
}

std::string optional_count(const std::optional<std::size_t>& number) {
  return number ? grouped(*number) : kNone;
}

// A value of the paper and ours.
struct Pair {
  std::string paper;
  std::string ours;
};
void add(Cells& cells, const Pair& pair) {
  cells.push_back(pair.paper);
  cells.push_back("<b>" + pair.ours + "</b>");
}

// Three digits, since a run takes from a millisecond to a minute.
std::string seconds_text(double seconds) {
  return fmt::format("{:.{}f}", seconds, seconds < 0.1 ? 4 : seconds < 1 ? 3 : seconds < 10 ? 2 : 1);
}

struct PaperMesh {
  std::string simplices = kNone, low = kNone, min = kNone, avg = kNone, max = kNone;

  PaperMesh() = default;
  template <class Row>
  explicit PaperMesh(const Row& row)
      : simplices(grouped(row.simplices)),
        low(optional_count(row.low_quality)),
        min(measure(row.ratio_min)),
        avg(measure(row.ratio_avg)),
        max(measure(row.ratio_max)) {}
  explicit PaperMesh(const PaperSurface& surface)
      : simplices(grouped(surface.facets)),
        min(measure(surface.ratio_min)),
        avg(measure(surface.ratio_avg)),
        max(measure(surface.ratio_max)) {}
};

std::string mesh_row(const std::string& heading, const PaperMesh& paper, const MeshNumbers& ours) {
  Cells cells = {heading};
  add(cells, {paper.simplices, grouped(ours.simplices)});
  add(cells, {paper.low, grouped(ours.low_quality)});
  add(cells, {paper.min, measure(ours.ratio_min)});
  add(cells, {paper.avg, measure(ours.ratio_avg)});
  add(cells, {paper.max, measure(ours.ratio_max)});
  return row(cells);
}

const PaperRow* paper_row(const PaperModel& paper, const Plan& plan) {
  const auto found = std::find_if(paper.rows.begin(), paper.rows.end(), [&](const PaperRow& r) {
    return r.insert == plan.insert && r.schedule == plan.schedule;
  });
  return found == paper.rows.end() ? nullptr : &*found;
}

double ratio(double circumcenter, double sink) { return sink > 0 ? circumcenter / sink : HUGE_VAL; }
double ratio(std::size_t circumcenter, std::size_t sink) {
  return ratio(static_cast<double>(circumcenter), static_cast<double>(sink));
}

// The plans of a study, each once, without the kind of points.
std::vector<Plan> schedules(const Study& study) {
  std::vector<Plan> plans;
  for (const Run& run : study.runs) {
    if (run.plan.insert == Insert::sink) plans.push_back(run.plan);
  }
  return plans;
}

const Run& with(const Study& study, Plan plan, Insert insert) {
  plan.insert = insert;
  return study.run(plan);
}

double time_ratio(const Study& study, const Plan& plan) {
  return ratio(with(study, plan, Insert::circumcenter).cpu_seconds,
               with(study, plan, Insert::sink).cpu_seconds);
}

std::string paper_time_ratio(const PaperModel& paper, Schedule schedule) {
  const PaperRow* const sink = paper_row(paper, {Insert::sink, schedule});
  const PaperRow* const circumcenter = paper_row(paper, {Insert::circumcenter, schedule});
  if (sink == nullptr || circumcenter == nullptr || !sink->minutes || !circumcenter->minutes) return kNone;
  return measure(ratio(static_cast<double>(*circumcenter->minutes), static_cast<double>(*sink->minutes)));
}

}  // namespace

std::string mesh_table(const Study& study) {
  const PaperModel& paper = paper_model(study.model);
  std::string body;
  if (study.dimension == 3) {
    body +=
        mesh_row("surface (triangles)", paper.surface ? PaperMesh(*paper.surface) : PaperMesh(), study.surface);
  }
  body += mesh_row("initial", PaperMesh(paper.initial), study.initial);
  for (const Plan& plan : schedules(study)) {
    // The literal rounds are there for their cost; the mesh is that of the pruned ones.
    if (plan.literal) continue;
    for (const Insert insert : {Insert::sink, Insert::circumcenter}) {
      const Run& run = with(study, plan, insert);
      const PaperRow* const theirs = paper_row(paper, run.plan);
      body += mesh_row(fmt::format("{}, {}", name(insert), schedule_text(plan)),
                       theirs != nullptr ? PaperMesh(*theirs) : PaperMesh(), run.mesh);
    }
  }
  const std::string simplices = study.dimension == 2 ? "triangles" : "tetrahedra";
  const std::string head = fmt::format(
      "<tr><td></td><th colspan=\"2\">{}</th><th colspan=\"2\">low quality</th><th colspan=\"2\">r/ℓ min</th>"
      "<th colspan=\"2\">r/ℓ avg</th><th colspan=\"2\">r/ℓ max</th></tr>\n"
      "<tr><td></td>{}</tr>",
      simplices, [] {
        std::string cells;
        for (int k = 0; k < 5; ++k) cells += "<th>paper</th><th>ours</th>";
        return cells;
      }());
  return table(fmt::format("Meshes with r/ℓ ≤ {:g} as the aim. – : not printed in the paper.", study.max_ratio),
               head, body);
}

std::string cost_table(const Study& study) {
  const PaperModel& paper = paper_model(study.model);
  std::string body;
  for (const Plan& plan : schedules(study)) {
    const Run& sink = with(study, plan, Insert::sink);
    const Run& circumcenter = with(study, plan, Insert::circumcenter);
    for (const Run* const run : {&sink, &circumcenter}) {
      const PaperRow* const theirs = plan.literal ? paper_row(paper, run->plan) : nullptr;
      body += row({fmt::format("{}, {}", name(run->plan.insert), schedule_text(plan)),
                   grouped(run->result.inserted), grouped(run->result.rounds), grouped(run->result.candidates),
                   grouped(run->result.prestars), seconds_text(run->cpu_seconds),
                   theirs != nullptr && theirs->minutes ? std::to_string(*theirs->minutes) : kNone});
    }
    body += row(
        {fmt::format("circumcenter / sink, {}", schedule_text(plan)),
         measure(ratio(circumcenter.result.inserted, sink.result.inserted)),
         measure(ratio(circumcenter.result.rounds, sink.result.rounds)),
         measure(ratio(circumcenter.result.candidates, sink.result.candidates)),
         measure(ratio(circumcenter.result.prestars, sink.result.prestars)), measure(time_ratio(study, plan)),
         plan.literal ? paper_time_ratio(paper, plan.schedule) : std::string(kNone)},
        " class=\"ratio\"");
  }
  return table("What the two kinds of points cost",
               "<tr><td></td><th>inserted</th><th>rounds</th><th>candidates</th><th>prestars</th>"
               "<th>CPU time, s</th><th>paper, min</th></tr>",
               body);
}

std::string comparison_table(const std::vector<Study>& studies) {
  std::string body;
  for (const Study& study : studies) {
    if (study.dimension != 3) continue;
    const Plan literal{Insert::sink, Schedule::parallel, true};
    const Run& sink = with(study, literal, Insert::sink);
    const Run& circumcenter = with(study, literal, Insert::circumcenter);
    body += row({study.model, paper_time_ratio(paper_model(study.model), Schedule::parallel),
                 measure(time_ratio(study, literal)),
                 measure(ratio(circumcenter.result.candidates, sink.result.candidates)),
                 measure(time_ratio(study, {Insert::sink, Schedule::parallel})),
                 measure(time_ratio(study, {Insert::sink, Schedule::block})),
                 measure(time_ratio(study, {Insert::sink, Schedule::incremental}))});
  }
  return table("Circumcenter / sink",
               "<tr><td></td><th>time, paper</th><th>time, parallel literal</th>"
               "<th>candidates, parallel literal</th><th>time, parallel pruned</th><th>time, block</th>"
               "<th>time, incremental</th></tr>",
               body);
}

std::string off_sink_table(const std::vector<Study>& studies) {
  constexpr Insert kKinds[] = {Insert::circumcenter, Insert::sink, Insert::off_sink};
  constexpr Schedule kSchedules[] = {Schedule::incremental, Schedule::block};
  std::string body;
  for (const Study& study : studies) {
    for (const Insert insert : kKinds) {
      Cells cells = {fmt::format("{}, {}", study.model, name(insert))};
      for (const Schedule schedule : kSchedules) {
        const Run& run = study.run({insert, schedule});
        cells.push_back("<b>" + grouped(run.mesh.simplices) + "</b>");
        for (const std::size_t number : {run.mesh.low_quality, run.result.inserted, run.result.candidates}) {
          cells.push_back(grouped(number));
        }
        cells.push_back(measure(run.mesh.ratio_avg));
        cells.push_back(seconds_text(run.cpu_seconds));
      }
      body += row(cells, insert == Insert::off_sink ? " class=\"ratio\"" : "");
    }
  }
  std::string columns;
  for (std::size_t k = 0; k < std::size(kSchedules); ++k) {
    columns +=
        "<th>simplices</th><th>low quality</th><th>inserted</th><th>candidates</th><th>r/ℓ avg</th>"
        "<th>CPU time, s</th>";
  }
  return table(
      "Three kinds of points, the same bound on r/ℓ",
      "<tr><td></td><th colspan=\"6\">one by one</th><th colspan=\"6\">in blocks</th></tr>\n<tr><td></td>" +
          columns + "</tr>",
      body);
}

}  // namespace sinkmesh::reproduce
