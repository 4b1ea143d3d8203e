// SPDX-License-Identifier: MIT
//
// Refinement of the four models to r/l <= 2, reading and writing excluded.
#include <benchmark/benchmark.h>

#include <string>

#include "refine/refine.h"
#include "tools/io/read.h"

namespace sinkmesh {
namespace {

const char* const kModels[] = {"cuboctahedron", "paraboloid", "star", "head"};

// Arguments: model, kind of point, schedule, literal.
void BM_Refine(benchmark::State& state) {
  const std::string model = kModels[state.range(0)];
  const Surface3 surface = read_surface(std::string(SINKMESH_BENCH_MODELS) + "/" + model + ".off");
  RefineOptions options;
  options.insert = static_cast<Insert>(state.range(1));
  options.schedule = static_cast<Schedule>(state.range(2));
  options.literal = state.range(3) != 0;
  state.SetLabel(model + (options.insert == Insert::sink ? " sink " : " circumcenter ") +
                 (options.schedule == Schedule::incremental ? "incremental"
                  : options.schedule == Schedule::block     ? "block"
                  : options.literal                         ? "parallel, literal"
                                                            : "parallel"));
  RefineResult result;
  for (auto _ : state) {
    state.PauseTiming();
    SurfaceMesher3 mesher(surface);
    mesher.find_domain();
    state.ResumeTiming();
    result = mesher.refine(options);
    state.PauseTiming();
    state.counters["tetrahedra"] = static_cast<double>(mesher.statistics(2).simplices());
    state.ResumeTiming();
  }
  state.counters["inserted"] = static_cast<double>(result.inserted);
  state.counters["candidates"] = static_cast<double>(result.candidates);
  state.counters["prestars"] = static_cast<double>(result.prestars);
  state.counters["us_per_insertion"] =
      benchmark::Counter(static_cast<double>(result.inserted) * 1e-6,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(BM_Refine)
    ->ArgsProduct({{0, 1, 2, 3}, {0, 1}, {0, 1, 2}, {0}})
    ->ArgsProduct({{0, 1, 2, 3}, {0, 1}, {2}, {1}})
    ->Unit(benchmark::kMillisecond);

// Everything between reading and writing.
void BM_SurfaceToMesh(benchmark::State& state) {
  const std::string model = kModels[state.range(0)];
  const Surface3 surface = read_surface(std::string(SINKMESH_BENCH_MODELS) + "/" + model + ".off");
  state.SetLabel(model);
  for (auto _ : state) {
    SurfaceMesher3 mesher(surface);
    mesher.find_domain();
    benchmark::DoNotOptimize(mesher.refine({}));
  }
}
BENCHMARK(BM_SurfaceToMesh)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sinkmesh

BENCHMARK_MAIN();
