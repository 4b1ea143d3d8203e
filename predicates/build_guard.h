// SPDX-License-Identifier: MIT
//
// Refuses compiler settings under which rounded arithmetic is not IEEE 754 binary64 [PS, 14]. What cannot be
// seen at compile time (contraction, flush-to-zero, rounding mode) is found by predicates_self_test() in
// self_test.h.
#pragma once

#include <cfloat>
#include <limits>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "sinkmesh: exact signs need IEEE arithmetic; remove -ffast-math, -Ofast and -funsafe-math-optimizations"
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "sinkmesh: comparisons with NaN must be false; remove -ffinite-math-only"
#endif
#if !defined(FLT_EVAL_METHOD) || (FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16)
#error "sinkmesh: doubles must be evaluated as doubles; remove -mfpmath=387 (16 only concerns half precision)"
#endif

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);
