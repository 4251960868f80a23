// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/pair.hpp"

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

/// A turn of the plane by its cosine and sine. The product of two is within 2^-101 of their sum of angles, and of length 1.
template <class T>
struct Turn {
  arithmetic::Pair<T> cosine;
  arithmetic::Pair<T> sine;

  friend Turn operator*(const Turn& x, const Turn& y) {
    return {normalised(x.cosine * y.cosine - x.sine * y.sine),
            normalised(x.sine * y.cosine + x.cosine * y.sine)};
  }
  static Turn none() { return {arithmetic::Pair<T>(T(1.0)), arithmetic::Pair<T>(T(0.0))}; }
};

/// The turn by 2 x from tan(x/2) = t <= 1, within 2^-98.
inline Turn<double> twice_from_half_tangent(arithmetic::Pair<double> t) {
  const auto square = t * t;
  const auto per_sum = reciprocal(square + 1.0);
  const Turn<double> once{(-square + 1.0) * per_sum, scaled(t * per_sum, 2.0)};
  return once * once;
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::batch
