// SPDX-License-Identifier: MIT
//
// The stages in their order, once for all polynomials.
#include "predicates/detail/stages.h"
#include "predicates/lanes.h"

namespace sinkmesh::detail {
namespace {

/// What remains when the cheap stages have failed. Apart from them, so that they need no stack for its numbers.
template <class P>
[[gnu::noinline]] Verdict decide_by_more(const Points<P>& points, const Vectors<P, double>& v, double value,
                                         double unit) {
  const double permanent = permanent_error<P>(v);
  if (const int s = by_error(value, permanent); s != kUndecided) return {s, Stage::kPermanent};
  if (by_granularity(value, permanent, unit) == 0) return {0, Stage::kGranularity};
  if (const int s = by_integers<P, kBits64>(points); s != kUndecided) return {s, Stage::kInteger64};
  if (const int s = by_integers<P, kBits128>(points); s != kUndecided) return {s, Stage::kInteger128};
  if (const int s = by_first_order<P>(points); s != kUndecided) return {s, Stage::kExpansion};
  return {by_expansions<P>(points), Stage::kExpansion};
}

}  // namespace

// The local error is cheaper than the permanent, so that the certificates of zero come before that: ties of
// integer data and of lattices never compute it.
template <class P>
Verdict decide_after_static(const Points<P>& points, double value, double unit) {
  const Vectors<P, double> v = rounded_vectors<P>(points);
  const double local = local_error<P>(v);
  if (const int s = by_error(value, local); s != kUndecided) return {s, Stage::kLocal};
  if (by_granularity(value, local, unit) == 0) return {0, Stage::kGranularity};
  if (by_box<P>(points) != kUndecided) return {0, Stage::kBox};
  return decide_by_more<P>(points, v, value, unit);
}

template <class P>
Verdict decide(const Points<P>& points) {
  constexpr double kNoUnit = 0;
  return decide_after_static<P>(points, rounded_value<P>(points), kNoUnit);
}

#define SINKMESH_INSTANTIATE(P)                 \
  template Verdict decide<P>(const Points<P>&); \
  template Verdict decide_after_static<P>(const Points<P>&, double, double);
SINKMESH_INSTANTIATE(Orientation<2>)
SINKMESH_INSTANTIATE(Orientation<3>)
SINKMESH_INSTANTIATE(InSphere<2>)
SINKMESH_INSTANTIATE(InSphere<3>)
SINKMESH_INSTANTIATE(Diametral<2>)
SINKMESH_INSTANTIATE(Diametral<3>)
SINKMESH_INSTANTIATE(FacetNormals<2>)
SINKMESH_INSTANTIATE(FacetNormals<3>)
SINKMESH_INSTANTIATE(Orthogonality<2>)
SINKMESH_INSTANTIATE(Orthogonality<3>)
#undef SINKMESH_INSTANTIATE

}  // namespace sinkmesh::detail
