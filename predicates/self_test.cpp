// SPDX-License-Identifier: MIT
#include "predicates/self_test.h"

#include "predicates/detail/rounding.h"
#include "predicates/predicates.h"

namespace sinkmesh {
namespace {

/// Not a constant for the compiler.
double opaque(double x) {
  volatile double v = x;
  return v;
}

bool is_contracted() {
  // p^2 needs 61 bits. Fusing one of the products into the subtraction leaves its rounding error.
  const double p = opaque(1 + 0x1p-30);
  const double q = opaque(1 + 0x1p-30);
  return p * p - q * q != 0;
}

bool flushes_to_zero() {
  const double smallest = opaque(0x1p-1074);
  const double normal = opaque(0x1p-1022);
  return smallest + opaque(0) == 0 || normal * opaque(0.5) == 0 || smallest * opaque(0x1p1000) == 0;
}

bool rounds_to_nearest() {
  // A tie goes to the even neighbour, anything else to the nearer one; for both signs.
  for (const double sign : {1.0, -1.0}) {
    const double one = opaque(sign);
    if (one + sign * opaque(0x1p-53) != one) return false;
    if (one + sign * opaque(0x1.8p-53) != sign * (1 + 0x1p-52)) return false;
    if (sign * opaque(1 + 0x1p-52) + sign * opaque(0x1p-53) != sign * (1 + 0x1p-51)) return false;
  }
  return true;
}

bool error_terms_are_exact() {
  const detail::TwoTerms product = detail::two_product(opaque(1 + 0x1p-30), opaque(1 - 0x1p-30));
  const detail::TwoTerms sum = detail::two_sum(opaque(1), opaque(0x1p-80));
  return product.head == 1 && product.tail == -0x1p-60 && sum.head == 1 && sum.tail == 0x1p-80;
}

bool signs_are_right() {
  const Point3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  if (orient3d(o, x, y, z) != 1 || orient3d(x, o, y, z) != -1 || orient3d(o, x, y, {1, 1, 0}) != 0)
    return false;
  if (insphere(o, x, y, z, {0.5, 0.5, 0.5}) != 1 || insphere(o, x, y, z, {2, 2, 2}) != -1) return false;
  if (insphere(o, x, y, z, {1, 1, 1}) != 0 || insphere_sos(o, x, y, z, {1, 1, 1}) != -1) return false;
  // Consecutive doubles on either side of a diametral sphere [PS, 12]: no filter can decide these.
  const Point3 a{0.1, 0.2, 0.3}, b{1.1, 0.7, 0.4}, c{0.5, 1.3, 0.9};
  const double dx = 0x1.b22deb6708457p-1;
  const double dy = 0x1.726c903118156p-1;
  return diametral_side(a, b, c, {dx, dy, 0x1.17eb82fa04b6ap+0}) == -1 &&
         diametral_side(a, b, c, {dx, dy, 0x1.17eb82fa04b6bp+0}) == 1;
}

}  // namespace

std::string predicates_self_test() {
  if (is_contracted()) return "a*b - c*d is fused into one operation: compile with -ffp-contract=off";
  if (flushes_to_zero())
    return "subnormal numbers are flushed to zero: find the library linked with -ffast-math";
  if (!rounds_to_nearest())
    return "the rounding mode is not to nearest: restore it with fesetround(FE_TONEAREST)";
  if (!error_terms_are_exact())
    return "the rounding error of a sum or product is wrong: check the compiler flags";
  if (!signs_are_right()) return "a predicate returns a wrong sign of a known vector: check the compiler flags";
  return {};
}

}  // namespace sinkmesh
