// SPDX-License-Identifier: MIT
#include "tools/reproduce/study.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>

#include "core/vector.h"
#include "predicates/circumcenter.h"
#include "refine/flow.h"
#include "refine/refine.h"

namespace sinkmesh::reproduce {
namespace {

// Of this thread. Finer than what getrusage() tells, which counts ticks on many systems.
double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

MeshNumbers numbers(const QualityStatistics& quality) {
  return {quality.simplices(), quality.low_quality(), quality.min_ratio(), quality.average_ratio(),
          quality.max_ratio()};
}

template <int Dim>
MeshNumbers facet_numbers(const Surface<Dim>& surface, double max_ratio) {
  MeshNumbers result;
  result.simplices = surface.facets.size();
  double sum = 0;
  for (const auto& facet : surface.facets) {
    FacetCorners<Dim> corners;
    for (std::size_t k = 0; k < Dim; ++k) corners[k] = &surface.points[facet[k]];
    const double ratio = std::sqrt(facet_shape<Dim>(corners).ratio2());
    result.low_quality += ratio > max_ratio ? 1 : 0;
    result.ratio_min = sum == 0 ? ratio : std::min(result.ratio_min, ratio);
    result.ratio_max = std::max(result.ratio_max, ratio);
    sum += ratio;
  }
  result.ratio_avg = sum / static_cast<double>(surface.facets.size());
  return result;
}

// The textbook formula, in doubles, from the first corner.
Point2 plain_circumcenter(const Corners<2>& s) {
  const Point2 u = *s[1] - *s[0];
  const Point2 v = *s[2] - *s[0];
  const double twice_area = 2 * cross(u, v);
  return {(*s[0])[0] + (dot(u, u) * v[1] - dot(v, v) * u[1]) / twice_area,
          (*s[0])[1] + (dot(v, v) * u[0] - dot(u, u) * v[0]) / twice_area};
}
Point3 plain_circumcenter(const Corners<3>& s) {
  const Point3 u = *s[1] - *s[0];
  const Point3 v = *s[2] - *s[0];
  const Point3 w = *s[3] - *s[0];
  const Point3 vw = cross(v, w);
  const Point3 wu = cross(w, u);
  const Point3 uv = cross(u, v);
  Point3 z = *s[0];
  for (std::size_t k = 0; k < 3; ++k) {
    z[k] += (dot(u, u) * vw[k] + dot(v, v) * wu[k] + dot(w, w) * uv[k]) / (2 * dot(u, vw));
  }
  return z;
}

// The exact center is rounded once, to the double next to it, which does not count as an error.
template <int Dim>
double error_of_plain_circumcenter(const Corners<Dim>& s) {
  Point<Dim> exact;
  if (!circumcenter(s, exact)) return 0;
  const double distance2 = squared_distance(plain_circumcenter(s), exact);
  return std::sqrt(distance2 / squared_distance(exact, *s[0]));
}

template <int Dim>
Conditioning conditioning(const SurfaceMesher<Dim>& mesher, double max_ratio) {
  const Complex<Dim>& complex = mesher.triangulation().complex();
  Flow<Dim> flow(mesher.triangulation());
  std::vector<Simplex> low;
  Conditioning result;
  for (const Simplex s : mesher.domain().simplices()) {
    if (shape<Dim>(complex.corners(s)).ratio2() <= max_ratio * max_ratio) continue;
    low.push_back(s);
    result.circumcenters = std::max(result.circumcenters, error_of_plain_circumcenter<Dim>(complex.corners(s)));
  }
  for (const Simplex s : flow.sinks_reached(low)) {
    result.sinks = std::max(result.sinks, error_of_plain_circumcenter<Dim>(complex.corners(s)));
  }
  return result;
}

}  // namespace

std::string schedule_text(const Plan& plan) {
  return std::string(name(plan.schedule)) + (plan.literal ? ", literal" : "");
}

const Run& Study::run(const Plan& plan) const {
  const auto found = std::find_if(runs.begin(), runs.end(), [&](const Run& r) {
    return r.plan.insert == plan.insert && r.plan.schedule == plan.schedule && r.plan.literal == plan.literal;
  });
  if (found == runs.end()) throw std::out_of_range(model + ": no run " + schedule_text(plan));
  return *found;
}

template <int Dim>
Study begin_study(const std::string& model, const Surface<Dim>& surface, double max_ratio) {
  Study study;
  study.model = model;
  study.max_ratio = max_ratio;
  study.dimension = Dim;
  study.facets = surface.facets.size();
  study.surface = facet_numbers(surface, max_ratio);
  SurfaceMesher<Dim> mesher(surface);
  mesher.find_domain();
  study.initial = numbers(mesher.statistics(max_ratio));
  Flow<Dim> flow(mesher.triangulation());
  const std::vector<Simplex> inside = mesher.domain().simplices();
  study.sinks = static_cast<std::size_t>(
      std::count_if(inside.begin(), inside.end(), [&](Simplex s) { return flow.is_sink(s); }));
  study.conditioning = conditioning(mesher, max_ratio);
  return study;
}

template <int Dim>
Run refine_as(const Surface<Dim>& surface, double max_ratio, const Plan& plan) {
  SurfaceMesher<Dim> mesher(surface);
  mesher.find_domain();
  Run run;
  run.plan = plan;
  run.rounds.push_back({numbers(mesher.statistics(max_ratio)), 0, 0, 0});

  double observer_seconds = 0;
  RefineOptions options;
  options.max_ratio = max_ratio;
  options.insert = plan.insert;
  options.schedule = plan.schedule;
  options.literal = plan.literal;
  options.observer = [&](const Progress& progress) {
    const double start = cpu_seconds();
    run.rounds.push_back(
        {numbers(progress.statistics()), progress.candidates, progress.passed_boundary, progress.inserted});
    observer_seconds += cpu_seconds() - start;
  };
  const double start = cpu_seconds();
  run.result = mesher.refine(options);
  run.cpu_seconds = cpu_seconds() - start - observer_seconds;
  run.mesh = numbers(mesher.statistics(max_ratio));
  run.hash = mesher.hash();
  return run;
}

template Study begin_study(const std::string&, const Surface2&, double);
template Study begin_study(const std::string&, const Surface3&, double);
template Run refine_as(const Surface2&, double, const Plan&);
template Run refine_as(const Surface3&, double, const Plan&);

}  // namespace sinkmesh::reproduce
