// SPDX-License-Identifier: MIT
#include "tools/program/refine_command.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "refine/refine.h"
#include "tools/io/detail/file.h"
#include "tools/io/write.h"
#include "tools/program/boundary_account.h"
#include "tools/program/cancel.h"
#include "tools/program/history.h"
#include "tools/program/improvement_account.h"
#include "tools/program/options.h"
#include "tools/program/progress.h"
#include "tools/program/report.h"
#include "tools/program/stopwatch.h"
#include "tools/program/summary.h"
#include "tools/program/surface_input.h"
#include "tools/program/text.h"

namespace sinkmesh::program {
namespace {

Insert insert_named(const std::string& name) {
  if (name == "offsink") return Insert::off_sink;
  return name == "sink" ? Insert::sink : Insert::circumcenter;
}
std::optional<Order> order_named(const std::string& name) {
  if (name.empty()) return std::nullopt;
  if (name == "ratio") return Order::ratio;
  return name == "shortest" ? Order::shortest : Order::smallest;
}
Schedule schedule_named(const std::string& name) {
  if (name == "incremental") return Schedule::incremental;
  return name == "block" ? Schedule::block : Schedule::parallel;
}
Fallback fallback_named(const std::string& name) {
  return name == "none" ? Fallback::none : Fallback::circumcenter;
}

BoundaryMode boundary_named(const std::string& name) {
  if (name == "auto") return BoundaryMode::automatic;
  return name == "fixed" ? BoundaryMode::fixed : BoundaryMode::refine;
}

// Of a triangle with the least angle a, r/l = 1 / (2 sin a). In extended precision, so that 30 degrees are 1.
double ratio_of_angle(double degrees) {
  const long double angle = static_cast<long double>(degrees) * std::numbers::pi_v<long double> / 180;
  return static_cast<double>(1 / (2 * std::sin(angle)));
}

double ratio_asked(const RefineArguments& arguments, int dim) {
  if (arguments.min_angle) return ratio_of_angle(*arguments.min_angle);
  return arguments.ratio.value_or(default_ratio(dim));
}

const char* reason_to_stop(Stop stop) {
  if (stop == Stop::floor) return "where points on the boundary would have come too near to each other";
  return stop == Stop::budget ? "at the limit that was set" : "on request";
}

// One run, with everything that the summary and the report tell about it.
template <int Dim>
class RefineRun {
 public:
  explicit RefineRun(const RefineArguments& arguments)
      : arguments_(arguments),
        ratio_(ratio_asked(arguments, Dim)),
        progress_(!arguments.quiet),
        initial_(ratio_),
        refined_(ratio_),
        final_(ratio_) {}

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
    std::optional<History> history;
    const RefineOptions options = refine_options(history);
    progress_.phase("finding what is inside");
    boundary_ = find_domain(mesher, options);
    lap("domain");
    if (!boundary_.ok()) return end_without_mesh(surface, mesher);
    initial_.take(mesher);
    if (!arguments_.history.empty()) history.emplace(initial_.vertices, initial_.quality);
    watch_.lap();
    progress_.phase("refining");
    result_ = mesher.refine(options);
    lap("refine");
    if (improves()) improve(mesher, options);
    final_.take(mesher);
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
    write_report(surface, mesher);
    const bool is_done = result_.stop == Stop::no_candidate;
    if (!arguments_.quiet) {
      print(summary(surface, mesher), arguments_.files.output == "-");
    } else if (!is_done) {
      print(fmt::format("{}: stopped {}\n", printable(arguments_.files.input, 200), stopped_early()), true);
    }
    return is_done ? ExitStatus::done : ExitStatus::stopped_early;
  }

 private:
  // The mesh at one stage of the run.
  struct Stage {
    explicit Stage(double bound) : max_ratio(bound), quality(bound) {}

    void take(const SurfaceMesher<Dim>& mesher) {
      vertices = mesher.num_vertices();
      quality = mesher.statistics(max_ratio);
      angles = mesher.angle_census();
    }

    double max_ratio;
    std::size_t vertices = 0;
    QualityStatistics quality;
    AngleCensus angles;
  };
  static Json json_of(const Stage& stage) {
    Json json = to_json(Dim, stage.vertices, stage.quality);
    json["angles"] = to_json(stage.angles);
    return json;
  }

  bool improves() const {
    const bool is_asked = arguments_.slivers || arguments_.coarsen;
    return is_asked && result_.stop != Stop::budget && result_.stop != Stop::cancelled;
  }

  void improve(SurfaceMesher<Dim>& mesher, const RefineOptions& options) {
    refined_.take(mesher);
    watch_.lap();
    progress_.phase("moving points");
    improvement_ = mesher.improve(options);
    lap("improve");
    result_.remaining = improvement_->remaining;
    if (improvement_->stop() != Stop::no_candidate) result_.stop = improvement_->stop();
  }

  void lap(const char* phase) { phases_.emplace_back(phase, watch_.lap()); }

  BoundaryResult find_domain(SurfaceMesher<Dim>& mesher, const RefineOptions& options) const {
    try {
      return mesher.find_domain(options);
    } catch (const FacetError& error) {
      throw error_at(arguments_.files.input, lines_.facet(error.facet()), error.what());
    } catch (const SeedError& error) {
      throw error_at(arguments_.files.input, seed_line(error, lines_), error.what());
    }
  }

  // The surface could not be conformed: no mesh, no history, but a report.
  ExitStatus end_without_mesh(const Surface<Dim>& surface, const SurfaceMesher<Dim>& mesher) {
    progress_.erase();
    write_report(surface, mesher);
    const std::string& input = arguments_.files.input;
    print(failure_line(boundary_, input == "-" ? "standard input" : input, lines_, surface.facets.size(),
                       hint()) +
              "\n",
          true);
    return ExitStatus::stopped_early;
  }

  RefineOptions refine_options(std::optional<History>& history) {
    RefineOptions options;
    options.max_ratio = ratio_;
    options.insert = insert_named(arguments_.insert);
    options.order = order_named(arguments_.order);
    options.reach = arguments_.reach;
    options.schedule = schedule_named(arguments_.schedule);
    options.literal = arguments_.literal;
    options.fallback = fallback_named(arguments_.fallback);
    options.coarsen = arguments_.coarsen;
    options.slivers = arguments_.slivers;
    options.min_dihedral = arguments_.min_dihedral.value_or(options.min_dihedral);
    options.boundary = {boundary_named(arguments_.boundary), arguments_.small_angle, arguments_.flat};
    options.threads = arguments_.threads;
    if (arguments_.max_vertices) options.max_vertices = *arguments_.max_vertices;
    options.should_continue = [this] {
      if (stop_requested()) {
        progress_.phase("stopping (Ctrl-C again to end at once)");
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

  void write_report(const Surface<Dim>& surface, const SurfaceMesher<Dim>& mesher) {
    total_ = watch_.total();
    if (!arguments_.report.empty()) {
      io_detail::write_file(arguments_.report, to_text(report(surface, mesher)));
    }
  }

  // Why the run ended, conforming or refining.
  const char* stop_name() const {
    if (!boundary_.unconformed.empty()) return "unconformed";
    return name(boundary_.ok() ? result_.stop : boundary_.stop);
  }

  Json report(const Surface<Dim>& surface, const SurfaceMesher<Dim>& mesher) const {
    const auto limit = [](const auto& value) { return value ? Json(*value) : Json(); };
    const Triangulation<Dim>& triangulation = mesher.triangulation();
    const bool has_mesh = boundary_.ok();
    Json report = begin_report("refine");
    report["input"] = {{"path", arguments_.files.input},
                       {"vertices", surface.points.size()},
                       {"facets", surface.facets.size()},
                       {"dimension", Dim},
                       {"unused_points", mesher.num_unused_points()},
                       {"duplicates", triangulation.duplicates().size()},
                       {"rounded_points", triangulation.gate().rounded_points()}};
    report["options"] = {
        {"ratio", ratio_},
        {"insert", arguments_.insert},
        {"order", name(result_.order)},
        {"reach", arguments_.reach.value_or(kDefaultReach<Dim>)},
        {"schedule", arguments_.schedule},
        {"literal", arguments_.literal},
        {"fallback", arguments_.fallback},
        {"boundary", arguments_.boundary},
        {"small_angle", arguments_.small_angle.value_or(Dim == 2 ? BoundaryOptions::kSmallAngle2
                                                                 : BoundaryOptions::kSmallAngle3)},
        {"flat", arguments_.flat},
        {"coarsen", arguments_.coarsen},
        {"slivers", arguments_.slivers},
        {"min_dihedral", arguments_.min_dihedral.value_or(RefineOptions().min_dihedral)},
        {"threads", arguments_.threads},
        {"max_vertices", limit(arguments_.max_vertices)},
        {"time_limit", limit(arguments_.time_limit)}};
    report["peeled"] = {{"simplices", boundary_.peeled_simplices}, {"facets", boundary_.peeled_facets}};
    report["boundary"] = to_json(boundary_, result_);
    report["initial"] = has_mesh ? json_of(initial_) : Json();
    if (improvement_) {
      report["refined"] = json_of(refined_);
      report["coarsening"] = to_json(improvement_->coarsening);
      report["slivers"] = to_json(improvement_->moving, mesher.slivers());
    }
    report["final"] = has_mesh ? json_of(final_) : Json();
    if (has_mesh) report["final"]["histogram"] = histogram(final_.quality);
    report["rounds"] = result_.rounds;
    report["candidates"] = result_.candidates;
    report["prestars"] = result_.prestars;
    report["inserted"] = result_.inserted;
    report["rejected"] = {{"boundary", result_.rejected.boundary},
                          {"crossing", result_.rejected.crossing},
                          {"separation", result_.rejected.separation},
                          {"dependent", result_.rejected.dependent}};
    const auto leftovers = has_mesh ? mesher.leftovers() : std::vector<Leftover<Dim>>();
    report["remaining"] = to_json(result_.remaining);
    report["centers_beyond"] = result_.centers_beyond;
    report["leftovers"] = to_json(leftovers);
    report["leftovers_total"] = leftovers.size();
    report["separation"] = result_.separation;
    report["stop"] = stop_name();
    report["hash"] = has_mesh ? Json(hash_text(mesher.hash())) : Json();
    Json seconds;
    for (const auto& [phase, duration] : phases_) seconds[phase] = duration;
    seconds["total"] = total_;
    report["seconds"] = seconds;
    report["peak_memory_bytes"] = peak_memory_bytes();
    return report;
  }

  // What may help a surface whose facets could not be divided.
  std::string hint() const {
    if (Dim == 2) return "";
    if (arguments_.flat >= BoundaryOptions().flat) return "; --flat joins facets that are nearly in one plane";
    return fmt::format(
        "; at --flat {} facets that are in one plane up to rounding are not joined: leave it out",
        arguments_.flat);
  }

  std::string stopped_early() const {
    const std::size_t outside = result_.centers_beyond;
    return fmt::format("early, {}; the mesh is Delaunay and stable{}", reason_to_stop(result_.stop),
                       outside == 0 ? ""
                                    : ", but " + count(outside, "circumcenter lies", "circumcenters lie") +
                                          " beyond the boundary");
  }

  std::string summary(const Surface<Dim>& surface, const SurfaceMesher<Dim>& mesher) const {
    Summary summary;
    summary.line("input", fmt::format("{}: {}, {}", printable(arguments_.files.input, 200),
                                      count(surface.points.size(), "vertex", "vertices"),
                                      count(surface.facets.size(), "facet", "facets")));
    if (const std::size_t unused = mesher.num_unused_points(); unused != 0) {
      summary.line("",
                   fmt::format("{} to no facet: left out", count(unused, "vertex belongs", "vertices belong")));
    }
    if (const std::size_t rounded = mesher.triangulation().gate().rounded_points(); rounded != 0) {
      summary.line("", fmt::format("{} rounded: coordinates differ too much in size",
                                   count(rounded, "point was", "points were")));
    }
    add_boundary(summary, boundary_, result_, boundary_named(arguments_.boundary), surface.facets.size(), Dim);
    const std::string regions = boundary_.regions > 1 ? fmt::format(", in {} regions", boundary_.regions) : "";
    summary.line("domain", fmt::format("{} inside{}", simplices(initial_.quality.simplices(), Dim), regions));
    std::vector<QualityColumn> columns = {column("before", initial_), column("after", final_)};
    if (improvement_) columns.insert(columns.begin() + 1, column("refined", refined_));
    add_quality(summary, columns, Dim, ratio_);
    summary.line("inserted", fmt::format("{} in {}, of {}", count(result_.inserted, "point", "points"),
                                         count(result_.rounds, "round", "rounds"),
                                         count(result_.candidates, "candidate", "candidates")));
    if (improvement_)
      add_improvement(summary, *improvement_, arguments_.coarsen, arguments_.slivers, mesher.slivers());
    add_remaining(summary, result_.remaining, ratio_);
    if (result_.stop != Stop::no_candidate) summary.line("stopped", stopped_early());
    add_times(summary, phases_, total_);
    summary.line("output",
                 arguments_.files.output == "-" ? "standard output" : printable(arguments_.files.output, 200));
    return summary.text();
  }

  static QualityColumn column(std::string_view heading, const Stage& stage) {
    return {heading, stage.vertices, &stage.quality, &stage.angles};
  }

  const RefineArguments& arguments_;
  double ratio_;
  SourceLines lines_;
  Stopwatch watch_;
  ProgressLine progress_;
  Phases phases_;
  Stage initial_;
  Stage refined_;  // if there was something to improve
  Stage final_;
  BoundaryResult boundary_;
  RefineResult result_;
  std::optional<Improvement> improvement_;
  double total_ = 0;
};

}  // namespace

CLI::App* add_refine_command(CLI::App& program, RefineArguments& arguments) {
  CLI::App* const command = program.add_subcommand(
      "refine",
      "Mesh what a closed surface (in the plane: segments) bounds, and insert points until it is good");
  add_file_options(*command, arguments.files, "The surface: .off, .obj, .stl, .ply; in the plane: .poly");
  command
      ->add_option("--ratio", arguments.ratio,
                   "Largest ratio of circumradius to shortest edge that is good enough")
      ->check(at_least(1, "the least for which refinement is sure to end"))
      ->default_str(kDefaultRatioText);
  command
      ->add_option("--min-angle", arguments.min_angle,
                   "In the plane: the smallest angle that is good enough; another way of saying --ratio")
      ->check(above(0))
      ->check(at_most(30, "the largest for which refinement is sure to end"))
      ->type_name("DEGREES")
      ->default_str("30");
  command
      ->add_option(
          "--insert", arguments.insert,
          "Which points to insert: the center of the simplex to which the flow leads, a point on the way there "
          "that is just far enough from all vertices, or the center of the simplex itself")
      ->check(CLI::IsMember({"offsink", "sink", "circumcenter"}))
      ->capture_default_str();
  command
      ->add_option("--reach", arguments.reach,
                   "Distance of an off-sink from the vertices, in units of the ratio times the shortest edge")
      ->check(at_least(1, "below it the simplices of an off-sink are of low quality again"))
      ->type_name("FACTOR")
      ->default_str("1.3; in the plane 1.5");
  command
      ->add_option("--order", arguments.order,
                   "Which simplex comes first: the largest ratio, the shortest edge, the smallest circumradius")
      ->check(CLI::IsMember({"ratio", "shortest", "smallest"}))
      ->default_str("shortest, in space within fixed facets smallest; without off-sinks ratio");
  command->add_option("--schedule", arguments.schedule, "How many at a time")
      ->check(CLI::IsMember({"incremental", "block", "parallel"}))
      ->capture_default_str();
  command->add_flag("--literal", arguments.literal,
                    "With --schedule block or parallel, --insert sink or circumcenter: rounds as published, "
                    "without pruning; the same mesh, more slowly");
  command
      ->add_option("--fallback", arguments.fallback,
                   "With --insert sink: what to do where no sink can be inserted")
      ->check(CLI::IsMember({"none", "circumcenter"}))
      ->capture_default_str();
  command
      ->add_option(
          "--boundary", arguments.boundary,
          "Keep the facets of the surface, or divide them where they are not Delaunay, not stable, or in "
          "the way of quality; auto keeps them if all are stable as given")
      ->check(CLI::IsMember({"auto", "fixed", "refine"}))
      ->capture_default_str();
  command
      ->add_option(
          "--small-angle", arguments.small_angle,
          "Angles of the surface up to this one excuse simplices of low quality; smaller attacks more, "
          "with more points")
      ->check(above(0))
      ->check(at_most(60))
      ->type_name("DEGREES")
      ->capture_default_str();
  command
      ->add_option("--flat", arguments.flat,
                   "Facets that lie this near to one plane, as a fraction of the diagonal of the surface, are "
                   "divided as one; 0: exactly coplanar ones only")
      ->check(at_least(0))
      ->check(below(1, "of which it is a fraction"))
      ->type_name("FRACTION")
      ->capture_default_str();
  command->add_flag("--coarsen", arguments.coarsen,
                    "After refining, take inner points away again where that leaves nothing bad");
  command->add_flag(
      "--slivers", arguments.slivers,
      "After refining, move inner points until angles are large enough; the mesh stays Delaunay, the "
      "boundary as it is, and no more simplices of low quality");
  command
      ->add_option(
          "--min-dihedral", arguments.min_dihedral,
          "With --slivers or --coarsen: the smallest dihedral angle (in the plane: angle) that is good enough")
      ->check(above(0))
      ->check(at_most(45, "more than all angles of a mesh can have"))
      ->type_name("DEGREES")
      ->default_str("15");
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
      "the mesh so far is written, but none if facets could not yet be made Delaunay; 4 internal error.");
  return command;
}

ExitStatus run(const RefineArguments& arguments) {
  if (arguments.literal && (arguments.schedule == "incremental" || arguments.insert == "offsink")) {
    throw UsageError("--literal goes with --insert sink or circumcenter and --schedule block or parallel only");
  }
  if (arguments.min_angle && arguments.ratio) {
    throw UsageError("--min-angle is another way of saying --ratio: give one of them");
  }
  if (arguments.fallback != "none" && arguments.insert != "sink") {
    throw UsageError("--fallback goes with --insert sink only");
  }
  if (arguments.min_dihedral && !arguments.slivers && !arguments.coarsen) {
    throw UsageError("--min-dihedral goes with --slivers or --coarsen only");
  }
  if (arguments.reach && arguments.insert != "offsink") {
    throw UsageError("--reach goes with --insert offsink only");
  }
  require_distinct(arguments.files, {{"--report", arguments.report}, {"--history", arguments.history}});
  if (surface_dimension(arguments.files) == 2) return RefineRun<2>(arguments).run();
  if (arguments.min_angle) {
    throw UsageError(
        "--min-angle is for the plane: in space a bound on r/l bounds no angle of a tetrahedron; give --ratio");
  }
  return RefineRun<3>(arguments).run();
}

}  // namespace sinkmesh::program
