// SPDX-License-Identifier: MIT
// For bounds that allow for either rounding.
#pragma once

#include "magicmass/arithmetic/fused.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// x y + z, rounded once where that is asked for and the instruction set has it, else twice.
template <bool fuses, class T>
[[gnu::always_inline]] inline T multiply_add(T x, T y, T z) {
#ifdef __FMA__
  if constexpr (fuses) return fused_sum(x, y, z);
#endif
  return x * y + z;
}
/// z - x y, likewise.
template <bool fuses, class T>
[[gnu::always_inline]] inline T subtract_product(T z, T x, T y) {
#ifdef __FMA__
  if constexpr (fuses) return fused_remainder(z, x, y);
#endif
  return z - x * y;
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
