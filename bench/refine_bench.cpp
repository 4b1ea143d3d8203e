// SPDX-License-Identifier: MIT
//
// Refinement of the four models to r/l <= 2, in the six combinations of the paper and with its literal parallel
// rounds. Reading, writing, the triangulation of the surface's vertices and the search for the domain are
// excluded; the second benchmark takes these in. And the search for self-intersections, where there are none.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>

#include "refine/refine.h"
#include "refine/self_intersections.h"
#include "tools/io/read.h"

namespace sinkmesh {
namespace {

Surface3 read_model(const std::string& model) {
  return read_surface(std::string(SINKMESH_BENCH_MODELS) + "/" + model + ".off");
}

void run_refine(benchmark::State& state, const std::string& model, const RefineOptions& options) {
  const Surface3 surface = read_model(model);
  RefineResult result;
  for (auto _ : state) {
    state.PauseTiming();
    SurfaceMesher3 mesher(surface);
    mesher.find_domain();
    state.ResumeTiming();
    result = mesher.refine(options);
    state.PauseTiming();
    state.counters["tetrahedra"] = static_cast<double>(mesher.statistics(options.max_ratio).simplices());
    state.ResumeTiming();
  }
  const auto inserted = static_cast<double>(result.inserted);
  state.counters["inserted"] = inserted;
  state.counters["candidates"] = static_cast<double>(result.candidates);
  state.counters["prestars"] = static_cast<double>(result.prestars);
  state.counters["per_insertion"] =
      benchmark::Counter(inserted, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void run_surface_to_mesh(benchmark::State& state, const std::string& model) {
  const Surface3 surface = read_model(model);
  for (auto _ : state) {
    SurfaceMesher3 mesher(surface);
    mesher.find_domain();
    benchmark::DoNotOptimize(mesher.refine({}));
  }
}

// n x n vertices on a torus, two triangles for each.
Surface3 torus(std::uint32_t n) {
  Surface3 surface;
  const double step = 2 * std::numbers::pi / n;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const double radius = 2 + std::cos(j * step);
      surface.points.push_back({radius * std::cos(i * step), radius * std::sin(i * step), std::sin(j * step)});
      const std::uint32_t i_next = (i + 1) % n;
      const std::uint32_t j_next = (j + 1) % n;
      surface.facets.push_back({i * n + j, i_next * n + j, i_next * n + j_next});
      surface.facets.push_back({i * n + j, i_next * n + j_next, i * n + j_next});
    }
  }
  return surface;
}

// The same triangles, rolled out in a plane that is not parallel to an axis, but for rounding. Not closed.
Surface3 tilted_sheet(std::uint32_t n) {
  Surface3 surface = torus(n);
  std::erase_if(surface.facets, [n](const Surface3::Facet& facet) {
    return std::any_of(facet.begin(), facet.end(), [n](std::uint32_t v) { return v / n == 0 || v % n == 0; });
  });
  for (std::uint32_t v = 0; v < surface.points.size(); ++v) {
    const double x = 0.1 * (v / n);
    const double y = 0.1 * (v % n);
    surface.points[v] = {x, y, 0.3 * x + 0.7 * y};
  }
  return surface;
}

// No facet is near those that it follows.
Surface3 torus_in_random_order(std::uint32_t n) {
  Surface3 surface = torus(n);
  std::mt19937_64 random(1);
  std::shuffle(surface.facets.begin(), surface.facets.end(), random);
  return surface;
}

using MakeSurface = Surface3 (*)(std::uint32_t);
constexpr std::pair<const char*, MakeSurface> kSurfaces[] = {
    {"torus", torus}, {"torus_in_random_order", torus_in_random_order}, {"tilted_sheet", tilted_sheet}};

void run_self_intersections(benchmark::State& state, MakeSurface make) {
  constexpr std::uint32_t kSide = 224;  // 100,352 triangles
  const Surface3 surface = make(kSide);
  for (auto _ : state) {
    const auto pairs = self_intersections(surface);
    if (!pairs.empty()) state.SkipWithError("the surface intersects itself");
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(surface.facets.size()));
}

struct Method {
  const char* name;
  Insert insert;
  Schedule schedule;
  bool literal = false;
};
constexpr Method kMethods[] = {
    {"offsink/incremental", Insert::off_sink, Schedule::incremental},
    {"offsink/block", Insert::off_sink, Schedule::block},
    {"offsink/parallel", Insert::off_sink, Schedule::parallel},
    {"sink/incremental", Insert::sink, Schedule::incremental},
    {"sink/block", Insert::sink, Schedule::block},
    {"sink/parallel", Insert::sink, Schedule::parallel},
    {"sink/literal", Insert::sink, Schedule::parallel, true},
    {"circumcenter/incremental", Insert::circumcenter, Schedule::incremental},
    {"circumcenter/block", Insert::circumcenter, Schedule::block},
    {"circumcenter/parallel", Insert::circumcenter, Schedule::parallel},
    {"circumcenter/literal", Insert::circumcenter, Schedule::parallel, true},
};

void register_all() {
  for (const std::string model : {"cuboctahedron", "paraboloid", "star", "head"}) {
    for (const Method& method : kMethods) {
      RefineOptions options;
      options.insert = method.insert;
      options.schedule = method.schedule;
      options.literal = method.literal;
      benchmark::RegisterBenchmark(("refine/" + model + "/" + method.name).c_str(), run_refine, model, options)
          ->Unit(benchmark::kMillisecond);
    }
    benchmark::RegisterBenchmark(("surface_to_mesh/" + model).c_str(), run_surface_to_mesh, model)
        ->Unit(benchmark::kMillisecond);
  }
  for (const auto& [name, make] : kSurfaces) {
    benchmark::RegisterBenchmark((std::string("self_intersections/") + name).c_str(), run_self_intersections,
                                 make)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace sinkmesh

int main(int argc, char** argv) {
  sinkmesh::register_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
