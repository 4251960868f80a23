// SPDX-License-Identifier: GPL-2.0-or-later
// Arithmetic that is not IEEE's to nearest: other rounding modes, subnormals flushed to zero.
#pragma once

#include <cfenv>

#include "magicmass/arithmetic/simd.hpp"

namespace magicmass::testing {
/// Whether f, which must not throw, says true in each of the modes.
template <class F>
bool in_foreign_modes(const F& f) {
  bool is_so = true;
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    is_so = f() && is_so;
    std::fesetround(FE_TONEAREST);
  }
#if defined(__SSE2__)
  for (const unsigned bit : {0x8000U, 0x0040U}) {  // results, operands flushed to zero
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | bit);
    is_so = f() && is_so;
    _mm_setcsr(before);
  }
#endif
  return is_so;
}
}  // namespace magicmass::testing
