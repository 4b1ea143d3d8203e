// SPDX-License-Identifier: MIT
#include "tools/program/refine_command.h"

#include <fmt/format.h>

#include "refine/refine.h"
#include "tools/io/detail/file.h"
#include "tools/io/write.h"
#include "tools/program/cancel.h"
#include "tools/program/history.h"
#include "tools/program/options.h"
#include "tools/program/progress.h"
#include "tools/program/report.h"
#include "tools/program/stopwatch.h"
#include "tools/program/summary.h"
#include "tools/program/surface_input.h"
#include "tools/program/text.h"

namespace sinkmesh::program {
namespace {

Insert insert_named(const std::string& name) { return name == "sink" ? Insert::sink : Insert::circumcenter; }
Schedule schedule_named(const std::string& name) {
  if (name == "incremental") return Schedule::incremental;
  return name == "block" ? Schedule::block : Schedule::parallel;
}
Fallback fallback_named(const std::string& name) {
  return name == "none" ? Fallback::none : Fallback::circumcenter;
}

// One run, with everything that the summary and the report tell about it.
template <int Dim>
class RefineRun {
 public:
  explicit RefineRun(const RefineArguments& arguments)
      : arguments_(arguments),
        progress_(!arguments.quiet),
        initial_(arguments.ratio),
        final_(arguments.ratio) {}

  ExitStatus run() {
    const Format format = output_format(arguments_.files, Dim);
    check_writable(arguments_.files.output);
    check_writable(arguments_.report);
    check_writable(arguments_.history);
    progress_.phase("reading");
    const Surface<Dim> surface = read_surface_input<Dim>(arguments_.files, lines_);
    lap("read");
    progress_.phase("checking the surface");
    require_sound<Dim>(surface, lines_, arguments_.files.input);
    lap("check");

    catch_stop_signals();
    progress_.phase("triangulating");
    SurfaceMesher<Dim> mesher(surface);
    lap("delaunay");
    const BoundaryResult boundary = mesher.find_domain();
    lap("domain");
    initial_ = mesher.statistics(arguments_.ratio);
    initial_vertices_ = mesher.num_vertices();
    std::optional<History> history;
    if (!arguments_.history.empty()) history.emplace(initial_vertices_, initial_);
    watch_.lap();
    progress_.phase("refining");
    result_ = mesher.refine(options(history));
    lap("refine");
    final_ = mesher.statistics(arguments_.ratio);
    watch_.lap();

    progress_.phase("writing");
    // The course first: once the mesh is there, only the small report can still fail.
    std::optional<io_detail::OutputFile> history_file;
    if (history) {
      history_file.emplace(arguments_.history);
      history_file->finish(history->csv());
    }
    write_mesh(arguments_.files.output, mesher.mesh(), format);
    if (history_file) history_file->publish();
    lap("write");
    progress_.erase();
    const double total = watch_.total();
    if (!arguments_.report.empty()) {
      io_detail::write_file(arguments_.report, to_text(report(surface, mesher, boundary, total)));
    }
    if (!arguments_.quiet) print(summary(surface, mesher, boundary, total), arguments_.files.output == "-");
    return result_.stop == Stop::no_candidate ? ExitStatus::done : ExitStatus::stopped_early;
  }

 private:
  void lap(const char* phase) { phases_.emplace_back(phase, watch_.lap()); }

  RefineOptions options(std::optional<History>& history) {
    RefineOptions options;
    options.max_ratio = arguments_.ratio;
    options.insert = insert_named(arguments_.insert);
    options.schedule = schedule_named(arguments_.schedule);
    options.literal = arguments_.literal;
    options.fallback = fallback_named(arguments_.fallback);
    options.threads = arguments_.threads;
    if (arguments_.max_vertices) options.max_vertices = *arguments_.max_vertices;
    options.should_continue = [this] {
      if (stop_requested()) {
        progress_.phase("stopping; the mesh so far will be written (Ctrl-C again to end at once)");
        return Continue::cancelled;
      }
      const bool late = arguments_.time_limit && watch_.total() >= *arguments_.time_limit;
      return late ? Continue::budget_spent : Continue::yes;
    };
    options.observer = [this, &history](const Progress& progress) {
      if (history) history->add(progress);
      progress_.update(progress);
    };
    return options;
  }

  Json report(const Surface<Dim>& surface, const SurfaceMesher<Dim>& mesher, const BoundaryResult& boundary,
              double total) const {
    const auto limit = [](const auto& value) { return value ? Json(*value) : Json(); };
    const Triangulation<Dim>& triangulation = mesher.triangulation();
    Json report = begin_report("refine");
    report["input"] = {{"path", arguments_.files.input},
                       {"vertices", surface.points.size()},
                       {"facets", surface.facets.size()},
                       {"dimension", Dim},
                       {"duplicates", triangulation.duplicates().size()},
                       {"rounded_points", triangulation.gate().rounded_points()}};
    report["options"] = {{"ratio", arguments_.ratio},
                         {"insert", arguments_.insert},
                         {"schedule", arguments_.schedule},
                         {"literal", arguments_.literal},
                         {"fallback", arguments_.fallback},
                         {"threads", arguments_.threads},
                         {"max_vertices", limit(arguments_.max_vertices)},
                         {"time_limit", limit(arguments_.time_limit)}};
    report["peeled"] = {{"simplices", boundary.peeled_simplices}, {"facets", boundary.peeled_facets}};
    report["initial"] = to_json(Dim, initial_vertices_, initial_);
    report["final"] = to_json(Dim, mesher.num_vertices(), final_);
    report["final"]["histogram"] = histogram(final_);
    report["rounds"] = result_.rounds;
    report["candidates"] = result_.candidates;
    report["prestars"] = result_.prestars;
    report["inserted"] = result_.inserted;
    report["rejected"] = {{"boundary", result_.rejected.boundary},
                          {"crossing", result_.rejected.crossing},
                          {"separation", result_.rejected.separation},
                          {"dependent", result_.rejected.dependent}};
    report["remaining"] = {
        {"total", result_.remaining.total()},         {"boundary_facet", result_.remaining.boundary_facet},
        {"boundary", result_.remaining.boundary},     {"crossing", result_.remaining.crossing},
        {"separation", result_.remaining.separation}, {"omega", result_.remaining.omega},
        {"untried", result_.remaining.untried}};
    report["separation"] = result_.separation;
    report["stop"] = name(result_.stop);
    report["hash"] = hash_text(mesher.hash());
    Json seconds;
    for (const auto& [phase, duration] : phases_) seconds[phase] = duration;
    seconds["total"] = total;
    report["seconds"] = seconds;
    report["peak_memory_bytes"] = peak_memory_bytes();
    return report;
  }

  std::string summary(const Surface<Dim>& surface, const SurfaceMesher<Dim>& mesher,
                      const BoundaryResult& boundary, double total) const {
    Summary summary;
    summary.line("input", fmt::format("{}: {}, {}", printable(arguments_.files.input, 200),
                                      count(surface.points.size(), "vertex", "vertices"),
                                      count(surface.facets.size(), "facet", "facets")));
    if (const std::size_t rounded = mesher.triangulation().gate().rounded_points(); rounded != 0) {
      summary.line("", fmt::format("{} rounded: coordinates differ too much in size",
                                   count(rounded, "point was", "points were")));
    }
    summary.line("domain", fmt::format("{} inside", simplices(initial_.simplices(), Dim)));
    if (boundary.peeled_simplices != 0) {
      summary.line("",
                   fmt::format("after {} with {} of the surface were peeled off, from which the flow leads out",
                               simplices(boundary.peeled_simplices, Dim),
                               count(boundary.peeled_facets, "facet", "facets")));
    }
    add_quality(summary, {{"before", initial_vertices_, &initial_}, {"after", mesher.num_vertices(), &final_}},
                Dim, arguments_.ratio);
    summary.line("inserted", fmt::format("{} in {}, of {}", count(result_.inserted, "point", "points"),
                                         count(result_.rounds, "round", "rounds"),
                                         count(result_.candidates, "candidate", "candidates")));
    add_remaining(summary, result_.remaining, arguments_.ratio);
    if (result_.stop != Stop::no_candidate) {
      summary.line("stopped",
                   fmt::format("early, {}; the mesh is valid",
                               result_.stop == Stop::budget ? "at the limit that was set" : "on request"));
    }
    add_times(summary, phases_, total);
    summary.line("output",
                 arguments_.files.output == "-" ? "standard output" : printable(arguments_.files.output, 200));
    return summary.text();
  }

  const RefineArguments& arguments_;
  SourceLines lines_;
  Stopwatch watch_;
  ProgressLine progress_;
  Phases phases_;
  std::size_t initial_vertices_ = 0;
  QualityStatistics initial_;
  QualityStatistics final_;
  RefineResult result_;
};

}  // namespace

CLI::App* add_refine_command(CLI::App& program, RefineArguments& arguments) {
  CLI::App* const command = program.add_subcommand(
      "refine",
      "Mesh what a closed surface (in the plane: polygon) bounds, and insert points until it is good");
  add_file_options(*command, arguments.files, "The surface: .off, .obj, .stl, .ply; in the plane: .poly");
  command
      ->add_option("--ratio", arguments.ratio,
                   "Largest ratio of circumradius to shortest edge that is good enough")
      ->check(at_least(1, "the least for which refinement is sure to end"))
      ->capture_default_str();
  command->add_option("--insert", arguments.insert, "Which points to insert")
      ->check(CLI::IsMember({"sink", "circumcenter"}))
      ->capture_default_str();
  command->add_option("--schedule", arguments.schedule, "How many at a time")
      ->check(CLI::IsMember({"incremental", "block", "parallel"}))
      ->capture_default_str();
  command->add_flag(
      "--literal", arguments.literal,
      "With --schedule block or parallel: rounds as published, without pruning; the same mesh, more slowly");
  command->add_option("--fallback", arguments.fallback, "What to do where no sink can be inserted")
      ->check(CLI::IsMember({"none", "circumcenter"}))
      ->capture_default_str();
  command
      ->add_option("--threads", arguments.threads,
                   "Accepted for later use: one thread works so far; the mesh does not depend on it")
      ->check(at_least(1))
      ->capture_default_str();
  command->add_option("--max-vertices", arguments.max_vertices, "Stop when the mesh has so many vertices")
      ->check(at_least(1));
  command
      ->add_option("--time-limit", arguments.time_limit, "Stop after so many seconds, and write what there is")
      ->check(at_least(0))
      ->type_name("SECONDS");
  add_report_option(*command, arguments.report);
  command->add_option("--history", arguments.history, "Write one line for each round to this file, as CSV")
      ->type_name("FILE");
  command->add_flag("-q,--quiet", arguments.quiet, "No summary, no progress");
  command->footer(
      "Example:\n  sinkmesh refine rotor.off -o rotor.vtu --ratio 1.5 --report rotor.json\n\n"
      "Exit status: 0 done; 1 a file cannot be used; 2 wrong usage; 3 stopped early (limit, Ctrl-C),\n"
      "the mesh so far is written; 4 internal error.");
  return command;
}

ExitStatus run(const RefineArguments& arguments) {
  if (arguments.literal && arguments.schedule == "incremental") {
    throw UsageError("--literal goes with --schedule block or parallel only");
  }
  require_distinct(arguments.files, {{"--report", arguments.report}, {"--history", arguments.history}});
  if (surface_dimension(arguments.files) == 2) return RefineRun<2>(arguments).run();
  return RefineRun<3>(arguments).run();
}

}  // namespace sinkmesh::program
