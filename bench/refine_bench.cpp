// SPDX-License-Identifier: MIT
//
// Refinement of the four models to r/l <= 2, in the six combinations of the paper and with its literal parallel
// rounds. Reading, writing, the triangulation of the surface's vertices and the search for the domain are
// excluded; the second benchmark takes these in.
#include <benchmark/benchmark.h>

#include <string>

#include "refine/refine.h"
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

struct Method {
  const char* name;
  Insert insert;
  Schedule schedule;
  bool literal = false;
};
constexpr Method kMethods[] = {
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
