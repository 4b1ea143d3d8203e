// SPDX-License-Identifier: MIT
#include "test/stress/refine/runs.h"

#include <algorithm>
#include <sstream>

#include "test/stress/refine/surface_case.h"
#include "test/stress/text.h"

namespace sinkmesh::stress {

std::vector<NamedCounter> run_counters(bool is_stopped) {
  return {{"refused", 0},
          {"unconformed", 0},
          {"boundary-divided", 0.3},
          {"barred", 0},
          {"stopped", is_stopped ? 0.1 : 0},
          {"floor", 0},
          {"with-leftovers", 0.05},
          {"improved", 0.02}};
}

template <int Dim>
Surface<Dim> tagged_surface_of(const Case& c) {
  Surface<Dim> surface = surface_of<Dim>(c);
  if (c.number_setting("tags") != 0) {
    for (std::size_t f = 0; f < surface.facets.size(); ++f) {
      surface.facet_tags.push_back(static_cast<std::int64_t>(100 + 7 * f));
    }
  }
  return surface;
}

/// What may be refused although check_surface() finds no fault.
template <int Dim>
void CheckedRun<Dim>::refused(const std::string& message, const RefineOptions& options) {
  const auto says = [&](const char* words) { return message.find(words) != std::string::npos; };
  const bool is_fixed = options.boundary.mode != BoundaryMode::refine;
  const bool is_explained =
      (options.boundary.mode == BoundaryMode::fixed && says("are not in the Delaunay triangulation")) ||
      (is_fixed && says("nothing stable is inside")) || says("less than a thousandth of a degree");
  if (!is_explained) throw CheckFailed("refused: " + message);
  ++counters_->named[kRefused];
  note("refused: " + message);
}

template <int Dim>
void CheckedRun<Dim>::expect_stop(Stop stop, const RefineOptions& options, const Stopper* stopper) const {
  const bool has_answered = stopper != nullptr && stopper->has_answered;
  const bool has_limit = options.max_vertices != RefineOptions().max_vertices ||
                         options.max_bytes != RefineOptions().max_bytes ||
                         (has_answered && stopper->answer == Continue::budget_spent);
  if (stop == Stop::budget && !has_limit) throw CheckFailed("stop: by a budget that nobody set");
  if (stop == Stop::cancelled && !(has_answered && stopper->answer == Continue::cancelled))
    throw CheckFailed("stop: cancelled, and nobody did");
  if (!has_answered) return;
  // The first to say no is the one that ends it; bytes are counted when the flag is polled.
  const bool is_told = stop == Stop::cancelled
                           ? stopper->answer == Continue::cancelled
                           : stop == Stop::budget && (stopper->answer == Continue::budget_spent ||
                                                      options.max_bytes != RefineOptions().max_bytes);
  if (!is_told) throw CheckFailed(std::string("stop: told to end, and says ") + name(stop));
}

template <int Dim>
bool CheckedRun<Dim>::find_domain(RefineOptions options, std::shared_ptr<Stopper> stopper) {
  if (stopper) options.should_continue = [stopper] { return stopper->poll(); };
  try {
    mesher_ = std::make_unique<SurfaceMesher<Dim>>(surface_);
    promise_.boundary = mesher_->find_domain(options);
  } catch (const FacetError& error) {
    if (error.facet() >= surface_.facets.size())
      throw CheckFailed("refused: because of a facet that there is not");
    refused(error.what(), options);
    return false;
  } catch (const InputError& error) {
    refused(error.what(), options);
    return false;
  }
  const BoundaryResult& boundary = promise_.boundary;
  promise_.options = options;
  expect_stop(boundary.stop, options, stopper.get());
  const Mesh<Dim> mesh = mesher_->mesh();
  note("conformed: " + std::to_string(mesh.points.size()) + " points, hash " + std::to_string(mesher_->hash()));
  expect_equal("points after conforming", mesh.points.size(),
               surface_.points.size() + boundary.points_on_segments + boundary.points_on_patches);
  if (!mesher_->triangulation().validate().ok()) throw CheckFailed("invariants: violated after conforming");
  const auto& facets = boundary.unconformed;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (facets[i] >= surface_.facets.size() || (i > 0 && facets[i] <= facets[i - 1]))
      throw CheckFailed("unconformed: no ascending list of facets");
  }
  if (!boundary.ok()) {
    expect_equal("simplices without a domain", mesh.simplices.size(), 0U);
    ++counters_->named[facets.empty() ? kStopped : kUnconformed];
    note("no domain");
    return false;
  }
  if (boundary.mode == BoundaryMode::refine) ++counters_->named[kDivided];
  // What the refinement would remove may be there yet; the rest must hold.
  promise_.result = {};
  expect_sound(surface_, mesh, promise_, *counters_);
  return true;
}

template <int Dim>
void CheckedRun<Dim>::expect_known_mesh(const Mesh<Dim>& mesh, Schedule schedule) {
  const ValidationReport report = mesher_->triangulation().validate();
  if (!report.ok())
    throw CheckFailed("invariant " + report.violations[0].invariant + ": " + report.violations[0].message);
  expect_sound(surface_, mesh, promise_, *counters_);
  expect_separated(surface_, mesh, promise_.result.separation);
  expect_leftovers(mesh, mesher_->leftovers(), promise_, *counters_);
  if (promise_.is_divided() && promise_.is_done() && schedule != Schedule::block &&
      mesh.simplices.size() <= 400)
    expect_centers_inside(mesh);
}

template <int Dim>
void CheckedRun<Dim>::refine(RefineOptions options, std::shared_ptr<Stopper> stopper) {
  if (stopper) options.should_continue = [stopper] { return stopper->poll(); };
  const std::size_t before = mesher_->mesh().points.size();
  std::size_t rounds = 0;
  std::string seen;
  options.observer = [&](const Progress& progress) {
    const QualityStatistics quality = progress.statistics();
    const auto require = [&](bool holds, const char* what, std::size_t found, std::size_t expected) {
      if (!holds && seen.empty()) seen = differ(std::string("progress, ") + what, found, expected);
    };
    ++rounds;
    require(progress.round == rounds, "number of the round", progress.round, rounds);
    require(progress.passed_boundary <= progress.candidates, "points that passed, of those considered",
            progress.passed_boundary, progress.candidates);
    require(quality.simplices() == progress.simplices, "simplices", progress.simplices, quality.simplices());
    require(quality.low_quality() == progress.low_quality, "of low quality", progress.low_quality,
            quality.low_quality());
  };
  promise_.options = options;
  promise_.is_improved = false;
  try {
    promise_.result = mesher_->refine(options);
  } catch (const InputError& error) {
    throw CheckFailed(std::string("refused after finding the domain: ") + error.what());
  }
  promise_.options.observer = {};
  const RefineResult& result = promise_.result;
  expect_stop(result.stop, options, stopper.get());
  const Mesh<Dim> mesh = mesher_->mesh();
  std::ostringstream out;
  out << name(result.stop) << ", " << mesh.points.size() << " points, " << mesh.simplices.size()
      << " simplices, left " << result.remaining.total() << ", hash " << mesher_->hash();
  note(out.str());
  expect_equal("inserted points", result.inserted, mesh.points.size() - before);
  expect_equal(
      "order that was kept", static_cast<int>(result.order),
      static_cast<int>(options.order.value_or(default_order<Dim>(options.insert, promise_.is_divided()))));
  if (result.points_on_segments + result.points_on_patches > result.inserted)
    throw CheckFailed("points on the boundary: more than points");
  if (mesher_->num_vertices() > std::max(options.max_vertices, before))
    throw CheckFailed(differ("vertices above the limit", mesher_->num_vertices(), options.max_vertices));
  expect_known_mesh(mesh, options.schedule);
  if (!seen.empty()) throw CheckFailed(seen);
  if (result.stop == Stop::budget || result.stop == Stop::cancelled) ++counters_->named[kStopped];
  if (result.stop == Stop::floor) ++counters_->named[kFloor];
  if (result.remaining.total() != 0) ++counters_->named[kLeft];
}

template <int Dim>
void CheckedRun<Dim>::improve(RefineOptions options, std::shared_ptr<Stopper> stopper) {
  if (!options.coarsen && !options.slivers) return;
  if (stopper) {
    stopper->has_answered = false;
    options.should_continue = [stopper] { return stopper->poll(); };
  }
  const Mesh<Dim> before = mesher_->mesh();
  const Improvement result = mesher_->improve(options);
  expect_stop(result.stop(), options, stopper.get());
  const SliverResult& moving = result.moving;
  const Mesh<Dim> mesh = mesher_->mesh();
  std::ostringstream out;
  out << "improved: " << name(result.stop()) << ", less " << result.coarsening.removed << " and "
      << moving.removed << " points, " << moving.moved << " moved, " << moving.inserted << " added, cost "
      << moving.cost_after << ", left " << result.remaining.total() << ", hash " << mesher_->hash();
  note(out.str());
  expect_equal("points taken away and added", mesh.points.size() + result.coarsening.removed + moving.removed,
               before.points.size() + moving.inserted);
  if (moving.cost_after > moving.cost_before)
    throw CheckFailed(differ("cost that has grown", moving.cost_after, moving.cost_before));
  promise_.options = options;
  promise_.result.remaining = result.remaining;
  promise_.is_improved = true;
  expect_no_worse(before, mesh, options.max_ratio);
  expect_known_mesh(mesh, options.schedule);
  if (result.coarsening.removed + moving.removed + moving.moved + moving.inserted != 0)
    ++counters_->named[kImproved];
}

template class CheckedRun<2>;
template class CheckedRun<3>;
template Surface<2> tagged_surface_of<2>(const Case&);
template Surface<3> tagged_surface_of<3>(const Case&);

}  // namespace sinkmesh::stress
