// SPDX-License-Identifier: MIT
//
// Refuses compilers' modes in which a rounded operation is not that of IEEE 754 binary64 [PS, 14]. What a
// preprocessor cannot see (contraction to fused operations, flush-to-zero, rounding modes) is tested by
// predicates_self_test().
#pragma once

#include <cfloat>
#include <limits>

#if defined(__FAST_MATH__) || defined(_M_FP_FAST) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "sinkmesh needs IEEE arithmetic: compile without -ffast-math, -Ofast and -ffinite-math-only"
#endif

#if !defined(FLT_EVAL_METHOD) || FLT_EVAL_METHOD != 0
#error "sinkmesh needs doubles evaluated as doubles: compile with -mfpmath=sse, not for the x87 unit"
#endif

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53,
              "sinkmesh needs IEEE 754 binary64");
