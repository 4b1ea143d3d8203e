// SPDX-License-Identifier: MIT
//
// Rounded values of polynomials, the dearest of them two by two.
#pragma once

#include "predicates/polynomials.h"

namespace sinkmesh::detail {

/// P at the rounded differences of its points.
template <class P>
[[gnu::always_inline]] inline double rounded_value(const Points<P>& p) {
  return P::value(rounded_vectors<P>(p));
}

/// The same sums and products in the same order as InSphere<3>::value, so the same double. a and b share a
/// register, and c and d: x[0] holds those of a and b, and next(x, 0) those of b and c.
template <>
inline double rounded_value<InSphere<3>>(const Points<InSphere<3>>& p) {
  using Pair = double __attribute__((vector_size(16)));
  using Pairs = std::array<Pair, 2>;  // of a, b, c, d; or of what belongs to ab, bc, cd, da
  const auto next = [](const Pairs& v, std::size_t i) { return Pair{v[i][1], v[1 - i][0]}; };
  const auto differences = [&p](std::size_t k) {
    const double x = (*p[4])[k];
    return Pairs{Pair{(*p[0])[k], (*p[1])[k]} - Pair{x, x}, Pair{(*p[2])[k], (*p[3])[k]} - Pair{x, x}};
  };
  const Pairs x = differences(0);
  const Pairs y = differences(1);
  const Pairs z = differences(2);
  Pairs minor;  // ab bc, cd da
  Pairs lift;
  for (std::size_t i = 0; i < 2; ++i) {
    minor[i] = x[i] * next(y, i) - next(x, i) * y[i];
    lift[i] = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
  }
  const Pair across = x[0] * y[1] - x[1] * y[0];                                      // ac bd
  const Pair first = z[0] * next(minor, 0) - next(z, 0) * across + z[1] * minor[0];   // abc bcd
  const Pair second = z[1] * next(minor, 1) + next(z, 1) * across + z[0] * minor[1];  // cda dab
  const Pair with_first = next(lift, 1) * first;                                      // d abc, a bcd
  const Pair with_second = next(lift, 0) * second;                                    // b cda, c dab
  return (with_second[1] - with_first[0]) + (with_first[1] - with_second[0]);
}

}  // namespace sinkmesh::detail
