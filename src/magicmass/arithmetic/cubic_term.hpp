// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/lanes.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// A third or a sixth, negative, as the sum of two doubles, the first with 17 bits.
struct CubicCoefficient {
  double head;
  double tail;
};
inline constexpr CubicCoefficient minus_third{-0x1.5555p-2, -0x1.5555555555555p-20};
inline constexpr CubicCoefficient minus_sixth{-0x1.5555p-3, -0x1.5555555555555p-21};

/// c x^3 = head + tail, z = x^2 rounded. The leading 12 bits of x have a cube of 36, which times the 17 of c.head is a double:
/// head is exact. tail, at most 2^-9 of it, is rounded a few times and takes z as it is: within 2^-61 of the whole.
template <class T>
struct CubicTerm {
  T head;
  T tail;

  [[gnu::always_inline]] CubicTerm(CubicCoefficient c, T x, T z) {
    const T leading = arithmetic::leading<12>(x);
    const T cube = leading * leading * leading;
    head = cube * T(c.head);
    tail = (x - leading) * (z + leading * (x + leading)) * T(c.head + c.tail) + cube * T(c.tail);
  }
};

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
