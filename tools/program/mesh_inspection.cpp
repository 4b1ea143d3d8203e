// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "core/mix.h"
#include "refine/mesh_check.h"
#include "tools/program/inspection.h"
#include "tools/program/text.h"

namespace sinkmesh::program {
namespace {

template <int Dim>
void describe_validity(const MeshCheck<Dim>& check, Summary& summary) {
  if (check.ok()) {
    summary.line("valid", "yes: volumes are positive, and simplices meet facet to facet");
  } else {
    summary.line("valid", fmt::format("no: {}", count(check.defects.size(), "defect", "defects")));
    for (const MeshDefect& defect : check.defects) {
      summary.line("", fmt::format("{}: {}", name(defect.kind), defect.message));
    }
  }
  if (check.unused_points != 0) {
    summary.line("note", fmt::format("{} of no simplex",
                                     count(check.unused_points, "point is a corner", "points are corners")));
  }
  if (check.rounded_points != 0) {
    summary.line("note", fmt::format("{} rounded before the checks: coordinates differ too much in size",
                                     count(check.rounded_points, "point was", "points were")));
  }
}

template <int Dim>
void describe_delaunay(const MeshCheck<Dim>& check, Summary& summary) {
  if (check.is_delaunay()) {
    const std::string ties = check.cospherical_facets == 0
                                 ? ""
                                 : fmt::format("; {} two simplices of one sphere",
                                               count(check.cospherical_facets, "interior facet separates",
                                                     "interior facets separate"));
    summary.line("Delaunay", "yes: no circumsphere holds a vertex of the mesh" + ties);
  } else {
    summary.line("Delaunay",
                 fmt::format("no: the circumspheres of {} hold vertices of the mesh, the first that of "
                             "simplex {}; {} not locally Delaunay",
                             simplices(check.simplices_not_delaunay, Dim), check.first_not_delaunay,
                             count(check.facets_not_delaunay, "facet is", "facets are")));
  }
  summary.line("flow", fmt::format("{}; {}", count(check.sinks, "sink", "sinks"),
                                   check.unstable_facets == 0
                                       ? std::string("none leads out through the boundary")
                                       : fmt::format("it leads out through {} of the boundary",
                                                     count(check.unstable_facets, "facet", "facets"))));
}

}  // namespace

template <int Dim>
void inspect_mesh(const Mesh<Dim>& mesh, double max_ratio, Inspection& inspection) {
  const MeshCheck<Dim> check = check_mesh(mesh, max_ratio);
  inspection.has_defects = !check.ok();

  Summary& summary = inspection.summary;
  summary.line("", fmt::format("{}, {}, {}, {}", count(check.vertices, "vertex", "vertices"),
                               simplices(mesh.simplices.size(), Dim),
                               count(check.boundary_facets, "boundary facet", "boundary facets"),
                               count(check.components, "part", "parts")));
  describe_validity(check, summary);
  if (check.ok()) describe_delaunay(check, summary);
  add_quality(summary, {{"", check.vertices, &check.quality, &check.angles}}, Dim, max_ratio);
  add_histogram(summary, check.quality);

  Json& report = inspection.report;
  report["options"] = {{"ratio", max_ratio}};
  report["valid"] = check.ok();
  report["defects"] = Json::array();
  for (const MeshDefect& defect : check.defects) {
    report["defects"].push_back({{"kind", name(defect.kind)}, {"message", defect.message}});
  }
  report["unused_points"] = check.unused_points;
  report["rounded_points"] = check.rounded_points;
  report["components"] = check.components;
  report["boundary_facets"] = check.boundary_facets;
  report["interior_facets"] = check.interior_facets;
  if (check.ok()) {
    report["delaunay"] = check.is_delaunay();
    report["simplices_not_delaunay"] = check.simplices_not_delaunay;
    report["facets_not_delaunay"] = check.facets_not_delaunay;
    report["cospherical_facets"] = check.cospherical_facets;
    report["sinks"] = check.sinks;
    report["unstable_facets"] = check.unstable_facets;
    SimplexSetHash<Dim> hash(mesh.points);
    for (const auto& simplex : mesh.simplices) hash.add(simplex);
    report["hash"] = hash_text(hash.value());
    summary.line("hash", hash_text(hash.value()));
  }
  report["quality"] = to_json(Dim, check.vertices, check.quality);
  report["quality"]["histogram"] = histogram(check.quality);
  report["quality"]["angles"] = to_json(check.angles);
}

template void inspect_mesh(const Mesh<2>&, double, Inspection&);
template void inspect_mesh(const Mesh<3>&, double, Inspection&);

}  // namespace sinkmesh::program
