// SPDX-License-Identifier: MIT
// What is said of rounding errors holds where each operation is rounded to its type, none is
// rearranged or contracted, and NaN is one. Checked at compile time, and at run time on request.
#pragma once

#include <cfloat>

static_assert(FLT_EVAL_METHOD == 0,
              "magicmass counts on doubles that are not computed in wider registers: -mfpmath=sse");
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "magicmass counts on IEEE arithmetic: not with -ffast-math, nor with a part of it"
#endif

namespace magicmass::arithmetic {
/// Whether this thread rounds to nearest and keeps subnormal numbers: a caller's rounding mode or
/// -Ofast would make results wrong in silence.
inline bool arithmetic_is_ieee() {
  volatile double one = 1.0;
  volatile double half_ulp = 0x1p-53;
  volatile double smallest = 0x1p-1022;
  const double up = one + half_ulp * 1.5;
  return one + half_ulp == 1.0 && up == 0x1.0000000000001p0 && smallest * 0.5 != 0.0;
}
}  // namespace magicmass::arithmetic
