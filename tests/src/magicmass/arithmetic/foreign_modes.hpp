// SPDX-License-Identifier: GPL-2.0-or-later
// Arithmetic that is not IEEE's to nearest: other rounding modes, subnormals flushed to zero.
#pragma once

#include <cfenv>

#include "magicmass/arithmetic/simd.hpp"

namespace magicmass::testing {
/// How many of the modes f, which must not throw, says true in; `all_modes`, if in each.
template <class F>
int in_foreign_modes(const F& f) {
  int count = 0;
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    count += f() ? 1 : 0;
    std::fesetround(FE_TONEAREST);
  }
#if defined(__SSE2__)
  for (const unsigned bit : {0x8000U, 0x0040U}) {  // results, operands flushed to zero
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | bit);
    count += f() ? 1 : 0;
    _mm_setcsr(before);
  }
#endif
  return count;
}
#if defined(__SSE2__)
inline constexpr int all_modes = 5;
#else
inline constexpr int all_modes = 3;
#endif
}  // namespace magicmass::testing
