// SPDX-License-Identifier: MIT
//
// A sign, and the stage that proved it.
#pragma once

#include "predicates/polynomials.h"

namespace sinkmesh::detail {

/// In the order in which they are tried; see predicates.h.
enum class Stage { kStatic, kLocal, kGranularity, kBox, kPermanent, kInteger64, kInteger128, kExpansion };
inline constexpr int kStages = 8;

struct Verdict {
  int sign;
  Stage stage;
};

/// The error of P's rounded value if no |difference| of its points along axis k exceeds extents[k].
/// Rounding is monotone, so the computed permanent is at most the majorant up to a factor (1+u)^30 for the
/// roundings of both; 2^-40 covers it.
template <class P>
double error_within(const Point<P::kDim>& extents) {
  return P::kErrorBound * (1 + 0x1p-40) * P::majorant(extents);
}

/// Sign of P at raw doubles; all stages but static and granularity.
template <class P>
Verdict decide(const Points<P>& points);

/// Sign of P where the static filter has failed.
/// @param value  the rounded value.
/// @param unit   0, or a number of which the exact value is a multiple.
template <class P>
Verdict decide_after_static(const Points<P>& points, double value, double unit);

}  // namespace sinkmesh::detail
