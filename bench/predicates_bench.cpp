// SPDX-License-Identifier: MIT
//
// Every predicate on random, exactly degenerate and nearly degenerate input (predicate_inputs.h), for raw
// doubles and with the static filter of a whole set. Counters: the share of calls that each stage decides.
#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

#include "bench/predicate_inputs.h"
#include "predicates/circumcenter.h"
#include "predicates/predicates.h"
#include "predicates/staged.h"
#include "predicates/verdict.h"

namespace sinkmesh {
namespace {

using namespace bench;
using namespace detail;

const char* const kStageNames[kStages] = {"static",    "local",     "granularity", "box",
                                          "permanent", "integer64", "integer128",  "expansion"};

template <class P, class VerdictOf>
void report_stages(benchmark::State& state, const InputSet<P>& set, VerdictOf&& verdict_of) {
  std::array<std::size_t, kStages> calls{};
  for (std::size_t i = 0; i < kInputSize; ++i) {
    ++calls[static_cast<std::size_t>(verdict_of(set.points(i)).stage)];
  }
  for (std::size_t s = 0; s < kStages; ++s) {
    if (calls[s] == 0) continue;
    state.counters[kStageNames[s]] = static_cast<double>(calls[s]) / static_cast<double>(kInputSize);
  }
}

/// One call for each of the arguments in turn.
template <class Call>
void run(benchmark::State& state, Call&& call) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(call(i));
    if (++i == kInputSize) i = 0;
  }
  state.SetItemsProcessed(state.iterations());
}

// What any predicate costs at least: the rounded expression, trusted.
template <class P, Input input>
void BM_Plain(benchmark::State& state) {
  const InputSet<P> set(input);
  run(state, [&](std::size_t i) { return P::value(rounded_vectors<P>(set.points(i))) > 0; });
}

template <class P, Input input>
void BM_Set(benchmark::State& state) {
  const InputSet<P> set(input);
  const auto verdict_of = [&](const Points<P>& points) { return set.predicates().template verdict<P>(points); };
  run(state, [&](std::size_t i) { return verdict_of(set.points(i)).sign; });
  report_stages(state, set, verdict_of);
}

// The public functions of predicates.h.
template <class P, auto kPredicate, Input input>
void BM_Raw(benchmark::State& state) {
  const InputSet<P> set(input);
  run(state, [&](std::size_t i) { return std::apply(kPredicate, set.arguments()[i]); });
  report_stages(state, set, decide<P>);
}

// diametral_side() is overloaded.
template <int Dim>
constexpr auto kDiametralSide = [](const auto&... points) { return diametral_side(points...); };
template <int Dim>
constexpr auto kDiametralSideSos = [](const auto&... points) { return diametral_side_sos(points...); };

// Perturbed.
template <class P, auto kPredicate, Input input>
void BM_RawSos(benchmark::State& state) {
  const InputSet<P> set(input);
  run(state, [&](std::size_t i) { return std::apply(kPredicate, set.arguments()[i]); });
}

template <int Dim>
int perturbed_sign(const Predicates<Dim>& predicates, const Arguments<InSphere<Dim>>& p) {
  Corners<Dim> corners;
  for (std::size_t i = 0; i <= Dim; ++i) corners[i] = &p[i];
  return predicates.in_sphere(corners, p.back());
}
template <int Dim>
int perturbed_sign(const Predicates<Dim>& predicates, const Arguments<Diametral<Dim>>& p) {
  FacetCorners<Dim> corners;
  for (std::size_t i = 0; i < Dim; ++i) corners[i] = &p[i];
  return predicates.flow_side(corners, p.back());
}

template <class P, Input input>
void BM_SetSos(benchmark::State& state) {
  const InputSet<P> set(input);
  run(state, [&](std::size_t i) {
    return perturbed_sign<static_cast<int>(P::kDim)>(set.predicates(), set.arguments()[i]);
  });
}

// Of two simplices, with the signs of their volumes.
template <int Dim, Input input>
void BM_SetOrthogonality(benchmark::State& state) {
  using P = Orthogonality<Dim>;
  const InputSet<P> set(input);
  run(state, [&](std::size_t i) {
    Corners<Dim> s;
    Corners<Dim> t;
    for (std::size_t k = 0; k <= Dim; ++k) {
      s[k] = &set.arguments()[i][k];
      t[k] = &set.arguments()[i][k + Dim + 1];
    }
    return set.predicates().orthogonality(s, t);
  });
  report_stages(state, set,
                [&](const Points<P>& points) { return set.predicates().template verdict<P>(points); });
}

template <int Dim, Input input>
void BM_RawOrthogonality(benchmark::State& state) {
  using P = Orthogonality<Dim>;
  const InputSet<P> set(input);
  std::vector<std::array<std::array<Point<Dim>, Dim + 1>, 2>> simplices;
  for (const Arguments<P>& p : set.arguments()) {
    auto& pair = simplices.emplace_back();
    for (std::size_t k = 0; k < p.size(); ++k) pair[k / (Dim + 1)][k % (Dim + 1)] = p[k];
  }
  run(state, [&](std::size_t i) { return orthogonality(simplices[i][0], simplices[i][1]); });
  report_stages(state, set, decide<P>);
}

// Of the simplex before a cospherical point: no tie of its own.
template <int Dim, Input input>
void BM_Circumcenter(benchmark::State& state) {
  const InputSet<InSphere<Dim>> set(input);
  run(state, [&](std::size_t i) {
    Corners<Dim> corners;
    for (std::size_t k = 0; k <= Dim; ++k) corners[k] = &set.arguments()[i][k];
    Point<Dim> center{};
    circumcenter(corners, center);
    return center[0];
  });
}

#define FOR_EACH_INPUT(name, ...)                   \
  BENCHMARK(name<__VA_ARGS__, Input::random>);      \
  BENCHMARK(name<__VA_ARGS__, Input::integer_tie>); \
  BENCHMARK(name<__VA_ARGS__, Input::lattice_tie>); \
  BENCHMARK(name<__VA_ARGS__, Input::rounded_tie>); \
  BENCHMARK(name<__VA_ARGS__, Input::scattered_tie>)

FOR_EACH_INPUT(BM_Plain, Orientation<3>);
FOR_EACH_INPUT(BM_Plain, InSphere<3>);
FOR_EACH_INPUT(BM_Plain, Diametral<3>);
FOR_EACH_INPUT(BM_Set, Orientation<2>);
FOR_EACH_INPUT(BM_Set, Orientation<3>);
FOR_EACH_INPUT(BM_Set, InSphere<2>);
FOR_EACH_INPUT(BM_Set, InSphere<3>);
FOR_EACH_INPUT(BM_Set, Diametral<2>);
FOR_EACH_INPUT(BM_Set, Diametral<3>);
FOR_EACH_INPUT(BM_SetSos, InSphere<2>);
FOR_EACH_INPUT(BM_SetSos, InSphere<3>);
FOR_EACH_INPUT(BM_SetSos, Diametral<2>);
FOR_EACH_INPUT(BM_SetSos, Diametral<3>);
FOR_EACH_INPUT(BM_SetOrthogonality, 2);
FOR_EACH_INPUT(BM_SetOrthogonality, 3);
FOR_EACH_INPUT(BM_Raw, Orientation<2>, orient2d);
FOR_EACH_INPUT(BM_Raw, Orientation<3>, orient3d);
FOR_EACH_INPUT(BM_Raw, InSphere<2>, incircle);
FOR_EACH_INPUT(BM_Raw, InSphere<3>, insphere);
FOR_EACH_INPUT(BM_Raw, Diametral<2>, kDiametralSide<2>);
FOR_EACH_INPUT(BM_Raw, Diametral<3>, kDiametralSide<3>);
FOR_EACH_INPUT(BM_RawSos, Diametral<2>, kDiametralSideSos<2>);
FOR_EACH_INPUT(BM_RawSos, Diametral<3>, kDiametralSideSos<3>);
FOR_EACH_INPUT(BM_RawSos, InSphere<2>, incircle_sos);
FOR_EACH_INPUT(BM_RawSos, InSphere<3>, insphere_sos);
FOR_EACH_INPUT(BM_RawOrthogonality, 2);
FOR_EACH_INPUT(BM_RawOrthogonality, 3);
FOR_EACH_INPUT(BM_Circumcenter, 2);
FOR_EACH_INPUT(BM_Circumcenter, 3);

}  // namespace
}  // namespace sinkmesh

BENCHMARK_MAIN();
