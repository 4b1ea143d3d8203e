// SPDX-License-Identifier: MIT
//
// Delaunay triangulation in the plane and in space: bulk loading by both engines over a sweep of n, insertion
// of one point after the other, location. Counters explain the times.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bench/insertion_profile.h"
#include "bench/point_sets.h"
#include "core/triangulation.h"

namespace sinkmesh {
namespace {

using namespace bench;

// make_points(n) gives about n points.
template <int Dim, auto make_points, Engine engine>
void BM_Delaunay(benchmark::State& state) {
  const std::vector<Point<Dim>> points = make_points(static_cast<std::size_t>(state.range(0)));
  std::optional<Triangulation<Dim>> triangulation;
  for (auto _ : state) triangulation.emplace(points, engine);
  const auto count = static_cast<double>(points.size());
  const auto solid = static_cast<double>(triangulation->num_solid());
  state.counters["simplices_per_point"] = solid / count;
  state.counters["ghosts_per_point"] = static_cast<double>(triangulation->num_ghosts()) / count;
  state.counters["bytes_per_simplex"] = static_cast<double>(triangulation->complex().bytes()) / solid;
  state.counters["per_point"] =
      benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.SetComplexityN(static_cast<benchmark::IterationCount>(points.size()));
  const InsertionProfile profile = profile_insertions<Dim>(points, engine);
  state.counters["steps"] = profile.steps;
  if (engine == Engine::star) {
    state.counters["prestar"] = profile.prestar;
    state.counters["star"] = profile.star;
  } else {
    state.counters["flips"] = profile.flips;
  }
}

#define SWEEP(dim, set, engine, largest)           \
  BENCHMARK(BM_Delaunay<dim, set, Engine::engine>) \
      ->RangeMultiplier(10)                        \
      ->Range(1000, largest)                       \
      ->Unit(benchmark::kMillisecond)              \
      ->Complexity(benchmark::oNLogN)
SWEEP(3, uniform_cube, star, 10000000);
SWEEP(3, rounded_sphere, star, 100000);
SWEEP(3, paraboloid, star, 100000);
SWEEP(3, open_cylinder, star, 100000);
SWEEP(3, cubic_grid, star, 100000);
SWEEP(3, uniform_cube, flips, 100000);
SWEEP(3, rounded_sphere, flips, 100000);
SWEEP(3, paraboloid, flips, 100000);
SWEEP(3, open_cylinder, flips, 10000);
SWEEP(3, cubic_grid, flips, 100000);
SWEEP(2, uniform_square, star, 1000000);
SWEEP(2, rounded_circle, star, 100000);
SWEEP(2, square_grid, star, 1000000);
SWEEP(2, uniform_square, flips, 100000);
SWEEP(2, rounded_circle, flips, 100000);
SWEEP(2, square_grid, flips, 100000);
#undef SWEEP

// The second half of n points into the triangulation of the first, in random order and without a hint: what
// bulk loading saves.
template <int Dim, auto make_points, Engine engine>
void BM_InsertOneByOne(benchmark::State& state) {
  const std::vector<Point<Dim>> points = make_points(static_cast<std::size_t>(state.range(0)));
  const std::span<const Point<Dim>> all(points);
  const std::size_t half = points.size() / 2;
  for (auto _ : state) {
    state.PauseTiming();
    Triangulation<Dim> triangulation(all.first(half), engine);
    state.ResumeTiming();
    for (const Point<Dim>& p : all.subspan(half)) benchmark::DoNotOptimize(triangulation.insert(p, engine));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size() - half));
}
BENCHMARK(BM_InsertOneByOne<3, uniform_cube, Engine::star>)->Arg(20000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_InsertOneByOne<3, uniform_cube, Engine::flips>)->Arg(20000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_InsertOneByOne<2, uniform_square, Engine::star>)->Arg(20000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_InsertOneByOne<2, uniform_square, Engine::flips>)->Arg(20000)->Unit(benchmark::kMillisecond);

// The way back.
template <int Dim, auto make_points>
void BM_RemoveOneByOne(benchmark::State& state) {
  const std::vector<Point<Dim>> points = make_points(static_cast<std::size_t>(state.range(0)));
  const std::size_t half = points.size() / 2;
  for (auto _ : state) {
    state.PauseTiming();
    Triangulation<Dim> triangulation(points);
    state.ResumeTiming();
    for (std::size_t i = points.size(); i-- > half;)
      triangulation.remove(Vertex(static_cast<std::uint32_t>(i)));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size() - half));
}
BENCHMARK(BM_RemoveOneByOne<3, uniform_cube>)->Arg(20000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_RemoveOneByOne<2, uniform_square>)->Arg(20000)->Unit(benchmark::kMillisecond);

// Each walk starts where the last one ended: far away, or within a hundredth of the width.
template <int Dim, auto make_points, bool near>
void BM_Locate(benchmark::State& state) {
  const std::vector<Point<Dim>> points = make_points(static_cast<std::size_t>(state.range(0)));
  const Triangulation<Dim> triangulation(points);
  std::vector<Point<Dim>> queries(1 << 12);
  Uniform uniform(11);
  for (Point<Dim>& q : queries) {
    for (double& x : q) x = near ? 0.5 + 0.01 * uniform() : uniform();
    q = triangulation.gate().in(q);
  }
  std::size_t i = 0;
  std::int64_t steps = 0;
  Simplex hint;
  for (auto _ : state) {
    const Location<Dim> at = triangulation.locate(queries[i++ % queries.size()], hint);
    hint = at.simplex;
    steps += at.steps;
  }
  state.counters["steps"] = benchmark::Counter(static_cast<double>(steps), benchmark::Counter::kAvgIterations);
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(BM_Locate<3, uniform_cube, false>)->RangeMultiplier(10)->Range(1000, 100000);
BENCHMARK(BM_Locate<3, uniform_cube, true>)->RangeMultiplier(10)->Range(1000, 100000);
BENCHMARK(BM_Locate<2, uniform_square, false>)->RangeMultiplier(10)->Range(1000, 100000);
BENCHMARK(BM_Locate<2, uniform_square, true>)->RangeMultiplier(10)->Range(1000, 100000);

}  // namespace
}  // namespace sinkmesh

BENCHMARK_MAIN();
