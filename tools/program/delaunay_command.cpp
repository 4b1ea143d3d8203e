// SPDX-License-Identifier: MIT
#include "tools/program/delaunay_command.h"

#include <fmt/format.h>

#include "core/triangulation.h"
#include "refine/refine.h"
#include "tools/io/detail/file.h"
#include "tools/io/write.h"
#include "tools/program/flow_fields.h"
#include "tools/program/options.h"
#include "tools/program/point_input.h"
#include "tools/program/progress.h"
#include "tools/program/report.h"
#include "tools/program/stopwatch.h"
#include "tools/program/summary.h"
#include "tools/program/text.h"

namespace sinkmesh::program {
namespace {

// The library's own bound; `delaunay` has no option for it.
const double kMaxRatio = RefineOptions().max_ratio;

template <int Dim>
class DelaunayRun {
 public:
  DelaunayRun(const DelaunayArguments& arguments, Stopwatch watch, ProgressLine& progress)
      : arguments_(arguments), watch_(watch), progress_(progress), quality_(kMaxRatio) {}

  ExitStatus run(const std::vector<Point<Dim>>& points) {
    const Format format = output_format(arguments_.files, Dim);
    lap("read");
    progress_.phase("triangulating");
    const Triangulation<Dim> triangulation(points, arguments_.engine == "star" ? Engine::star : Engine::flips);
    lap("delaunay");
    for (const Simplex s : triangulation.complex().simplices()) {
      if (triangulation.complex().is_solid(s)) quality_.template add<Dim>(triangulation.complex().corners(s));
    }
    watch_.lap();
    Mesh<Dim> mesh = hull_mesh(triangulation);
    if (arguments_.flow) {
      progress_.phase("following the flow");
      flow_ = add_flow_fields(triangulation, mesh);
      lap("flow");
    }
    progress_.phase("writing");
    write_mesh(arguments_.files.output, mesh, format);
    lap("write");
    progress_.erase();
    const double total = watch_.total();
    if (!arguments_.report.empty()) {
      io_detail::write_file(arguments_.report, to_text(report(triangulation, points.size(), total)));
    }
    if (!arguments_.quiet) {
      print(summary(triangulation, points.size(), total), arguments_.files.output == "-");
    }
    return ExitStatus::done;
  }

 private:
  void lap(const char* phase) { phases_.emplace_back(phase, watch_.lap()); }

  Json report(const Triangulation<Dim>& triangulation, std::size_t points, double total) const {
    Json report = begin_report("delaunay");
    report["input"] = {{"path", arguments_.files.input},
                       {"vertices", points},
                       {"dimension", Dim},
                       {"duplicates", triangulation.duplicates().size()},
                       {"rounded_points", triangulation.gate().rounded_points()}};
    report["options"] = {{"engine", arguments_.engine}, {"flow", arguments_.flow}};
    report["final"] = to_json(Dim, points - triangulation.duplicates().size(), quality_);
    report["final"]["hull_facets"] = triangulation.num_ghosts();
    if (flow_) report["flow"] = {{"sinks", flow_->sinks}, {"to_omega_only", flow_->to_omega_only}};
    report["hash"] = hash_text(triangulation.hash());
    Json seconds;
    for (const auto& [phase, duration] : phases_) seconds[phase] = duration;
    seconds["total"] = total;
    report["seconds"] = seconds;
    report["peak_memory_bytes"] = peak_memory_bytes();
    return report;
  }

  std::string summary(const Triangulation<Dim>& triangulation, std::size_t points, double total) const {
    Summary summary;
    summary.line("input", fmt::format("{}: {}", printable(arguments_.files.input, 200),
                                      count(points, "point", "points")));
    if (const std::size_t copies = triangulation.duplicates().size(); copies != 0) {
      summary.line("", fmt::format("{} of an earlier one; kept in the file, in no simplex",
                                   count(copies, "is a copy", "are copies")));
    }
    if (const std::size_t rounded = triangulation.gate().rounded_points(); rounded != 0) {
      summary.line("", fmt::format("{} rounded: coordinates differ too much in size",
                                   count(rounded, "point was", "points were")));
    }
    add_quality(summary, {{"", points - triangulation.duplicates().size(), &quality_}}, Dim, kMaxRatio);
    summary.line("", fmt::format("{:<16}{:>14}", "hull facets", grouped(triangulation.num_ghosts())));
    if (flow_) {
      summary.line("", fmt::format("{:<16}{:>14}", "sinks", grouped(flow_->sinks)));
      summary.line("", fmt::format("{:<16}{:>14}", "flow out only", grouped(flow_->to_omega_only)));
    }
    add_times(summary, phases_, total);
    summary.line("output",
                 arguments_.files.output == "-" ? "standard output" : printable(arguments_.files.output, 200));
    return summary.text();
  }

  const DelaunayArguments& arguments_;
  Stopwatch watch_;
  ProgressLine& progress_;
  Phases phases_;
  QualityStatistics quality_;
  std::optional<FlowCounts> flow_;
};

}  // namespace

CLI::App* add_delaunay_command(CLI::App& program, DelaunayArguments& arguments) {
  CLI::App* const command =
      program.add_subcommand("delaunay", "The exact Delaunay triangulation of points, up to their convex hull");
  add_file_options(
      *command, arguments.files,
      "The points: .xyz, .csv, .node, or the vertices of a surface (.off, .obj, .stl, .ply, .poly)");
  command->add_option("--engine", arguments.engine, "How points are inserted; the mesh is the same")
      ->check(CLI::IsMember({"star", "flips"}))
      ->capture_default_str();
  command->add_flag(
      "--flow", arguments.flow,
      "Add to each cell: watershed (the sink that its flow leads to, -1 for none), sink (its number "
      "if it is one, or -1), sinks (how many it flows to)");
  command
      ->add_option("--dimension", arguments.dimension,
                   "Of the points; default: 3 if each has three coordinates")
      ->check(CLI::IsMember({2, 3}));
  add_report_option(*command, arguments.report);
  command->add_flag("-q,--quiet", arguments.quiet, "No summary, no progress");
  command->footer("Example:\n  sinkmesh delaunay scan.xyz -o scan.vtu");
  return command;
}

ExitStatus run(const DelaunayArguments& arguments) {
  const Stopwatch watch;
  ProgressLine progress(!arguments.quiet);
  require_distinct(arguments.files, {{"--report", arguments.report}});
  check_writable(arguments.files.output);
  check_writable(arguments.report);
  progress.phase("reading");
  const PointInput input = read_point_input(arguments.files, arguments.dimension);
  if (const auto* plane = std::get_if<std::vector<Point2>>(&input)) {
    return DelaunayRun<2>(arguments, watch, progress).run(*plane);
  }
  try {
    return DelaunayRun<3>(arguments, watch, progress).run(std::get<std::vector<Point3>>(input));
  } catch (const DegenerateInput& error) {
    if (error.affine_dimension() != 2) throw;
    throw DegenerateInput(fmt::format("{}; or take x and y alone (--dimension 2)", error.what()), 2);
  }
}

}  // namespace sinkmesh::program
