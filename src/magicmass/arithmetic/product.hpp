// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/bounded.hpp"
#include "magicmass/arithmetic/pair.hpp"
#include "magicmass/arithmetic/tracked.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// scale x y, a result that is only rounded any more; scale is plus or minus a power of two.
template <class Number>
struct Product {
  Number x;
  Number y;
  double scale;

  friend Number evaluated(Product p) { return scaled(p.x * p.y, p.scale); }
  friend auto certainly_rounded(Product p) { return certainly_rounded(evaluated(p)); }
};

template <class Number>
[[gnu::always_inline]] inline typename Number::Real rounded(Product<Number> p) {
  return rounded(evaluated(p));
}
/// Half an ulp for the product of the high parts and half for the sum.
template <class T>
[[gnu::always_inline]] inline T rounded(Product<Pair<T>> p) {
  return T(p.scale) * (p.x.high * p.y.high + (p.x.high * p.y.low + p.x.low * p.y.high));
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
