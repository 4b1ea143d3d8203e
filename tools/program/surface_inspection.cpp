// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "refine/surface_check.h"
#include "tools/program/inspection.h"
#include "tools/program/surface_fit.h"
#include "tools/program/surface_input.h"
#include "tools/program/text.h"

namespace sinkmesh::program {
namespace {

constexpr std::size_t kFacetsNamed = 20;

template <int Dim>
std::string coordinates(const Point<Dim>& p) {
  return fmt::format("({})", fmt::join(p, ", "));
}

template <int Dim>
Box<Dim> box_of(const Surface<Dim>& surface) {
  Box<Dim> box;
  for (const auto& facet : surface.facets) {
    for (const std::uint32_t v : facet) box.include(surface.points[v]);
  }
  return box;
}

// Without overflow: coordinates may be anything.
template <int Dim>
double distance(const Point<Dim>& a, const Point<Dim>& b) {
  if constexpr (Dim == 2) {
    return std::hypot(a[0] - b[0], a[1] - b[1]);
  } else {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }
}

template <int Dim>
double shortest_edge(const Surface<Dim>& surface) {
  double shortest = HUGE_VAL;
  for (const auto& facet : surface.facets) {
    for (std::size_t i = 0; i < Dim; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        shortest = std::min(shortest, distance<Dim>(surface.points[facet[i]], surface.points[facet[j]]));
      }
    }
  }
  return shortest;
}

const char* name(SurfaceSeverity severity) {
  switch (severity) {
    case SurfaceSeverity::note:
      return "note";
    case SurfaceSeverity::orientation:
      return "orientation";
    case SurfaceSeverity::error:
      return "error";
  }
  return "";
}

bool has(const std::vector<SurfaceDefect>& defects, std::initializer_list<SurfaceDefectKind> kinds) {
  return std::any_of(defects.begin(), defects.end(), [&](const SurfaceDefect& defect) {
    return std::find(kinds.begin(), kinds.end(), defect.kind) != kinds.end();
  });
}

template <int Dim>
void describe_counts(const Surface<Dim>& surface, const std::vector<SurfaceDefect>& defects,
                     Inspection& inspection) {
  const SurfaceSummary counts = summarize_surface(surface);
  Summary& summary = inspection.summary;
  std::string text = fmt::format("{}, ", count(counts.vertices, "vertex", "vertices"));
  if (Dim == 3) text += fmt::format("{}, ", count(counts.edges, "edge", "edges"));
  text += fmt::format("{}, {}", count(surface.facets.size(), "facet", "facets"),
                      count(counts.components, "part", "parts"));
  summary.line("", text);
  text = fmt::format("Euler characteristic {}", counts.euler_characteristic);
  if (Dim == 3 && counts.is_manifold) text += fmt::format(", genus {}", counts.genus);
  if (counts.signed_volume != 0) {
    text += fmt::format(", {} {:.6g}", Dim == 2 ? "area" : "volume", std::abs(counts.signed_volume));
  }
  using Kind = SurfaceDefectKind;
  const bool is_closed = !has(defects, {Kind::open_edge, Kind::dangling_end});
  const bool is_manifold =
      !has(defects, {Kind::nonmanifold_edge, Kind::nonmanifold_vertex, Kind::duplicate_facet});
  const bool is_oriented = !has(defects, {Kind::inconsistent_orientation});
  summary.line("", fmt::format("{}, {}, {}; {}", is_closed ? "closed" : "not closed",
                               is_manifold ? "a manifold" : "no manifold",
                               is_oriented ? "oriented" : "not oriented alike", text));
  const Box<Dim> box = box_of(surface);
  const double shortest = shortest_edge(surface);
  summary.line("box", fmt::format("{} to {}", coordinates<Dim>(box.low), coordinates<Dim>(box.high)));
  summary.line("", fmt::format("shortest edge {}", shortest));

  Json& report = inspection.report;
  report["vertices"] = counts.vertices;
  report["unused_points"] = surface.points.size() - counts.vertices;
  report["edges"] = counts.edges;
  report["facets"] = surface.facets.size();
  report["components"] = counts.components;
  report["euler_characteristic"] = counts.euler_characteristic;
  report["closed"] = is_closed;
  report["manifold"] = is_manifold;
  report["oriented"] = is_oriented;
  report["genus"] = counts.is_manifold && Dim == 3 ? Json(counts.genus) : Json();
  report["signed_volume"] = counts.signed_volume;
  report["box"] = {{"low", box.low}, {"high", box.high}};
  report["shortest_edge"] = shortest;
}

std::string what_refine_does(const SurfaceFit& found, std::string_view otherwise) {
  if (!found.too_sharp) return std::string(otherwise);
  return fmt::format("refine refuses the surface: facets {} and {} meet at less than a thousandth of a degree",
                     found.too_sharp->first, found.too_sharp->second);
}

// Of a surface without errors: what it is good for.
template <int Dim>
std::string_view praise(const std::vector<SurfaceDefect>& defects) {
  using Kind = SurfaceDefectKind;
  if (has(defects, {Kind::nonmanifold_edge, Kind::nonmanifold_vertex, Kind::dangling_end})) {
    return Dim == 2 ? "its segments meet at common ends only"
                    : "its facets meet at common edges and vertices only";
  }
  return Dim == 2 ? "it bounds an area" : "it bounds a solid";
}

std::string with_line(const std::string& message, std::size_t line) {
  return line == 0 ? message : fmt::format("{} [line {}]", message, line);
}

// @param failure  of a surface without errors as such: why it bounds nothing (flat, for instance), or empty.
void describe_defects(const std::vector<SurfaceDefect>& defects, std::string_view praise,
                      const std::string& failure, const SourceLines& lines, Inspection& inspection) {
  Json list = Json::array();
  Json notes = Json::array();
  std::size_t errors = 0;
  if (!failure.empty()) {
    list.push_back({{"kind", "bounds nothing"}, {"message", failure}});
    ++errors;
  }
  for (const SurfaceDefect& defect : defects) {
    const bool is_error = severity(defect.kind) == SurfaceSeverity::error;
    errors += is_error ? 1 : 0;
    Json entry = {{"kind", name_of(defect.kind)},
                  {"severity", name(severity(defect.kind))},
                  {"facets", defect.facets},
                  {"vertices", defect.vertices},
                  {"message", defect.message}};
    if (const std::size_t line = source_line(defect, lines); line != 0) entry["line"] = line;
    (is_error ? list : notes).push_back(std::move(entry));
  }
  inspection.report["defects"] = std::move(list);
  inspection.report["notes"] = std::move(notes);
  inspection.has_defects = errors != 0;
  inspection.report["valid"] = errors == 0;
  inspection.summary.line("valid", errors == 0 ? fmt::format("yes: {}", praise)
                                               : fmt::format("no: {}", count(errors, "error", "errors")));
  if (!failure.empty()) inspection.summary.line("error", failure);
  // Errors first; what to do about them once for each kind.
  for (const bool error_turn : {true, false}) {
    for (std::size_t i = 0; i < defects.size(); ++i) {
      const SurfaceDefect& defect = defects[i];
      if ((severity(defect.kind) == SurfaceSeverity::error) != error_turn) continue;
      const std::size_t line = source_line(defect, lines);
      inspection.summary.line(error_turn ? "error" : "note", with_line(defect.message, line));
      if (i + 1 == defects.size() || defects[i + 1].kind != defect.kind) {
        inspection.summary.line("", fmt::format("  what to do: {}", advice(defect.kind)));
      }
    }
  }
}

template <int Dim>
void describe_fit(const Surface<Dim>& surface, const SurfaceFit& found, double max_ratio,
                  Inspection& inspection) {
  Summary& summary = inspection.summary;
  Json& report = inspection.report;
  report["missing_facets"] = found.missing.size();
  report["stable"] = found.missing.empty() && found.unstable == 0;
  std::vector<std::size_t> named = found.missing;
  named.resize(std::min(named.size(), kFacetsNamed));
  report["first_missing_facets"] = named;
  if (!found.missing.empty()) {
    const std::string_view rest = found.missing.size() > kFacetsNamed ? " ..." : "";
    summary.line("Delaunay", fmt::format("no: {} of {} missing in the Delaunay triangulation of the vertices",
                                         grouped(found.missing.size()),
                                         count(surface.facets.size(), "facet is", "facets are")));
    summary.line("", fmt::format("facets {}{}", fmt::join(named, " "), rest));
    summary.line("", what_refine_does(found, "refine divides facets until all pieces are"));
    summary.line("", "--boundary fixed refuses the surface");
    return;
  }
  report["unstable_facets"] = found.unstable;
  report["peeled"] = {{"simplices", found.peeled_simplices}, {"facets", found.peeled_facets}};
  report["inside"] = to_json(Dim, found.vertices, found.quality);
  summary.line("Delaunay", "yes: every facet is in the Delaunay triangulation of the vertices");
  if (found.unstable == 0) {
    summary.line("stable", "yes: refine keeps the surface as it is, unless asked for --boundary refine");
  } else {
    summary.line("stable",
                 fmt::format("no: the flow leads out through {}", count(found.unstable, "facet", "facets")));
    summary.line("", what_refine_does(found, "refine divides facets until none does"));
    summary.line("", fmt::format("--boundary fixed peels off {} and {}", simplices(found.peeled_simplices, Dim),
                                 count(found.peeled_facets, "facet", "facets")));
  }
  summary.line("inside",
               fmt::format("{}, {} of them with r/l above {:g}", simplices(found.quality.simplices(), Dim),
                           grouped(found.quality.low_quality()), max_ratio));
}

}  // namespace

template <int Dim>
void inspect_surface(const Surface<Dim>& surface, const SourceLines& lines, double max_ratio,
                     Inspection& inspection) {
  const std::vector<SurfaceDefect> defects = check_surface(surface);
  describe_counts(surface, defects, inspection);
  const bool has_errors = std::any_of(defects.begin(), defects.end(), [](const SurfaceDefect& defect) {
    return severity(defect.kind) == SurfaceSeverity::error;
  });
  std::optional<SurfaceFit> found;
  std::string failure;
  try {
    if (!has_errors) found = fit(surface, max_ratio);
  } catch (const SeedError& error) {
    failure = with_line(error.what(), seed_line(error, lines));
  } catch (const InputError& error) {
    failure = error.what();
  }
  describe_defects(defects, praise<Dim>(defects), failure, lines, inspection);
  if (found) describe_fit(surface, *found, max_ratio, inspection);
}

template void inspect_surface(const Surface<2>&, const SourceLines&, double, Inspection&);
template void inspect_surface(const Surface<3>&, const SourceLines&, double, Inspection&);

}  // namespace sinkmesh::program
