// SPDX-License-Identifier: MIT
#include "predicates/self_test.h"

#include "predicates/predicates.h"

namespace sinkmesh {
namespace {

// Read through a volatile, so that the compiler cannot compute the tests itself.
double opaque(double x) {
  const volatile double hidden = x;
  return hidden;
}

bool rounds_to_nearest() {
  const double one = opaque(1);
  return one + opaque(0x1p-53) == one && one + opaque(0x1.8p-53) == one + 0x1p-52 &&
         -one - opaque(0x1p-53) == -one && one - opaque(0x1p-54) == one;
}

bool underflows_gradually() {
  const double smallest = opaque(0x1p-1074);
  return smallest + smallest == opaque(0x1p-1073) && smallest * opaque(0.75) == smallest &&
         opaque(0x1p-1022) - opaque(0x1.8p-1023) == opaque(0x1p-1024);
}

// x^2 - x^2 is what a fused multiply-subtract would make of the rounding error of the square.
bool does_not_contract() {
  const double x = opaque(1 + 0x1p-30);
  const double difference = x * x - opaque(x * x);
  return difference == 0;
}

bool knows_signs() {
  const Point3 o = {0, 0, 0};
  const Point3 x = {opaque(1), 0, 0};
  const Point3 y = {0, opaque(1), 0};
  const Point3 z = {0, 0, opaque(1)};
  const Point3 all = {opaque(1), opaque(1), opaque(1)};
  // One unit in the last place off the plane through three points without a common coordinate.
  const Point3 off = {opaque(0.25), opaque(0.25), opaque(0.5 - 0x1p-54)};
  return orient3d(o, x, y, z) == 1 && orient3d(x, y, z, off) == -1 && insphere(o, x, y, z, all) == 0 &&
         insphere_sos(o, x, y, z, all) == -1 && insphere(o, x, y, z, {0.5, 0.5, 0.5}) == 1 &&
         diametral_side(x, y, z, o) == -1 && diametral_side_sos(o, x, {1, 1, 0}, all) == 1 &&
         orient2d({0, 0}, {1, 0}, {0, 1}) == 1 && incircle({0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}) == 1 &&
         diametral_side({0, 0}, {1, 0}, Point2{0.5, 0.5}) == 0;
}

}  // namespace

std::string predicates_self_test() {
  if (!rounds_to_nearest())
    return "the rounding mode is not to nearest: restore it with fesetround(FE_TONEAREST)";
  if (!underflows_gradually()) {
    return "subnormal numbers are flushed to zero: a library linked with -ffast-math may have switched this on";
  }
  if (!does_not_contract()) return "products and sums are fused: compile with -ffp-contract=off";
  if (!knows_signs()) return "a predicate has the wrong sign: the compiler breaks IEEE arithmetic";
  return {};
}

}  // namespace sinkmesh
