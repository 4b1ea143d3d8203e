// SPDX-License-Identifier: MIT
#include "tools/reproduce/page.h"

#include <fmt/format.h>

#include "tools/reproduce/claims.h"
#include "tools/reproduce/evolution.h"
#include "tools/reproduce/html_table.h"
#include "tools/reproduce/paper.h"
#include "tools/reproduce/svg_canvas.h"
#include "tools/text/numbers.h"

namespace sinkmesh::reproduce {
namespace {

constexpr const char* kStyle = R"css(
:root { --ink: #1d2733; --paper: #ffffff; --accent: #c2410c; --muted: #64707d; --line: #d5dce3;
  --fill-1: #dfe8f1; --fill-2: #a9c1da; --fill-3: #4d7aa8; color-scheme: light dark; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6eaee; --paper: #14181d; --accent: #ff8f52; --muted: #9aa6b2; --line: #313a44;
    --fill-1: #25313e; --fill-2: #3e5873; --fill-3: #7fa9d4; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 1320px; padding: 2rem 1.5rem 5rem; background: var(--paper);
  color: var(--ink);
  font: 17px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
h1 { font-size: 2.1rem; line-height: 1.2; margin: 0 0 .5rem; }
h2 { font-size: 1.5rem; margin: 3.5rem 0 .5rem; border-top: 1px solid var(--line); padding-top: 1.5rem; }
p { max-width: 76ch; }
a { color: var(--accent); }
nav { display: flex; flex-wrap: wrap; gap: .3rem 1.2rem; margin: 1.5rem 0; }
figure { margin: 1.5rem 0; }
figure svg, figure img { display: block; width: 100%; height: auto; }
figcaption { color: var(--muted); font-size: .93rem; max-width: 90ch; margin-top: .4rem; }
.row { display: grid; grid-template-columns: repeat(auto-fit, minmax(380px, 1fr)); gap: 1.5rem;
  align-items: start; }
.charts { grid-template-columns: repeat(auto-fit, minmax(390px, 1fr)); }
.wide > * { min-width: 0; }
.scroll { overflow-x: auto; margin: 1.5rem 0; }
table { border-collapse: collapse; font-size: .92rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; color: var(--muted); padding-bottom: .4rem; }
th, td { padding: .22rem .7rem; text-align: right; white-space: nowrap; }
th { font-weight: 500; color: var(--muted); }
tbody th { text-align: left; color: var(--ink); }
tbody tr { border-top: 1px solid var(--line); }
tr.ratio td, tr.ratio th { color: var(--accent); font-weight: 600; }
.claims { list-style: none; padding: 0; }
.claims li { border-top: 1px solid var(--line); padding: .8rem 0; }
.claims b { display: block; }
.verdict { color: var(--accent); font-weight: 600; }
.muted { color: var(--muted); }
)css";

std::string figure(const Picture& picture) {
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", picture.html, picture.caption);
}

std::string heading(const Study& study) {
  std::string name = study.model == "usa" ? "USA" : study.model;
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return fmt::format("Figure {}: {}", paper_model(study.model).figure, name);
}

std::string navigation(const PageContent& content) {
  std::string html =
      "<nav aria-label=\"Contents\"><a href=\"#claims\">Claims</a><a href=\"#figures\">Figures 1–6</a>";
  for (const StudyPage& s : content.studies) {
    html += fmt::format("<a href=\"#{0}\">{1}</a>", s.study.model, heading(s.study));
  }
  return html + "<a href=\"#off-sinks\">Off-sinks</a></nav>\n";
}

std::string claims_section(const std::vector<Study>& studies) {
  std::string html = "<h2 id=\"claims\">What holds, and what does not</h2>\n<ul class=\"claims\">\n";
  for (const Claim& claim : weigh_claims(studies)) {
    html += fmt::format("<li><b>{}</b> <span class=\"verdict\">{}.</span> {}</li>\n", escape(claim.claim),
                        escape(claim.verdict), escape(claim.finding));
  }
  return html + "</ul>\n" + comparison_table(studies);
}

std::string off_sink_section(const std::vector<Study>& studies) {
  return "<section><h2 id=\"off-sinks\">Beyond the paper: off-sinks</h2>\n"
         "<p>A sink lies as far along the flow as possible, which is not where the smallest mesh is. An "
         "off-sink is "
         "the first point on the way from the shortest edge of a bad simplex to its sink whose distance from "
         "the "
         "vertices is a given multiple of that edge.</p>\n" +
         off_sink_table(studies) + "</section>\n";
}

std::string study_section(const StudyPage& content) {
  const Study& study = content.study;
  const bool plane = study.dimension == 2;
  std::string html = fmt::format("<section><h2 id=\"{}\">{}</h2>\n", study.model, heading(study));
  html += fmt::format(
      "<p>Our stand-in has {} boundary {}; its stable subcomplex starts with {} {}, {} of them with r/ℓ above "
      "{:g}, "
      "and {}.</p>\n",
      text::grouped(study.facets), plane ? "edges" : "triangles", text::grouped(study.initial.simplices),
      plane ? "triangles" : "tetrahedra", text::grouped(study.initial.low_quality), study.max_ratio,
      text::count(study.sinks, "sink", "sinks"));
  if (plane) {
    html += "<p>The outline is not the paper's, so absolute counts differ from its.</p>\n";
  }
  html += fmt::format("<div class=\"{}\">\n", plane ? "wide" : "row");
  for (const Picture& picture : content.pictures) html += figure(picture);
  html += "</div>\n" + mesh_table(study) + cost_table(study) + "<div class=\"row charts\">\n";
  for (const std::string& chart : evolution_charts(study, plane ? Schedule::block : Schedule::parallel)) {
    html += "<figure>" + chart + "</figure>\n";
  }
  return html + "</div></section>\n";
}

}  // namespace

std::string page(const PageContent& content) {
  std::vector<Study> studies;
  for (const StudyPage& s : content.studies) studies.push_back(s.study);
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
      "<title>Sink-insertion for mesh improvement, reproduced</title><style>{}</style></head><body>\n"
      "<h1>Sink-insertion for mesh improvement, reproduced</h1>\n"
      "<p>Every table and figure of H. Edelsbrunner and D. Guoy, <cite>Sink-insertion for mesh "
      "improvement</cite> "
      "(SoCG 2001), computed anew by <code>sinkmesh reproduce</code> on stand-ins for its five data sets. "
      "Numbers of "
      "the paper stand beside ours; all others come from the runs.</p>\n"
      "<p class=\"muted\">Machine: {}. The paper's: Pentium II, 450 MHz. CPU times are of the refinement "
      "alone, one "
      "thread. Everything on this page took {:.0f} s.</p>\n",
      kStyle, escape(content.machine), content.total_seconds);
  html += navigation(content) + claims_section(studies);
  html += "<section><h2 id=\"figures\">Figures 1 to 6: the ideas, in the plane</h2>\n<div class=\"wide\">\n";
  for (const Picture& picture : content.figures) html += figure(picture);
  html += "</div></section>\n";
  for (const StudyPage& s : content.studies) html += study_section(s);
  return html + off_sink_section(studies) + "</body></html>\n";
}

}  // namespace sinkmesh::reproduce
