// SPDX-License-Identifier: MIT
// What is said of rounding errors holds where each operation is rounded to its type, none is rearranged, and NaN is one.
#pragma once

#include <cfloat>

static_assert(FLT_EVAL_METHOD == 0,
              "magicmass counts on doubles that are not computed in wider registers: -mfpmath=sse");
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "magicmass counts on IEEE arithmetic: not with -ffast-math, nor with a part of it"
#endif
