// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/fused.hpp"
#include "magicmass/arithmetic/lanes.hpp"
#include "magicmass/arithmetic/tangent_estimate.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// Two T that do the same one after the other: while an operation on the one waits for its arguments, that on the other is done.
/// For loops that wait more than they compute, where there are registers for both.
template <class T>
struct SideBySide {
  struct Mask {
    typename T::Mask first;
    typename T::Mask second;
  };

  T first;
  T second;

  SideBySide() = default;
  SideBySide(T one, T other) : first(one), second(other) {}
  SideBySide(double all) : first(all), second(all) {}

  friend SideBySide operator-(SideBySide x) { return {-x.first, -x.second}; }
  friend SideBySide operator+(SideBySide x, SideBySide y) {
    return {x.first + y.first, x.second + y.second};
  }
  friend SideBySide operator-(SideBySide x, SideBySide y) {
    return {x.first - y.first, x.second - y.second};
  }
  friend SideBySide operator*(SideBySide x, SideBySide y) {
    return {x.first * y.first, x.second * y.second};
  }
  friend SideBySide operator/(SideBySide x, SideBySide y) {
    return {x.first / y.first, x.second / y.second};
  }
  friend Mask operator>(SideBySide x, SideBySide y) {
    return {x.first > y.first, x.second > y.second};
  }
  friend Mask operator>=(SideBySide x, SideBySide y) {
    return {x.first >= y.first, x.second >= y.second};
  }

  friend SideBySide select(Mask condition, SideBySide yes, SideBySide no) {
    return {select(condition.first, yes.first, no.first),
            select(condition.second, yes.second, no.second)};
  }
  friend SideBySide where(Mask condition, SideBySide yes) {
    return {where(condition.first, yes.first), where(condition.second, yes.second)};
  }
  friend SideBySide smaller(SideBySide x, SideBySide y) {
    return {smaller(x.first, y.first), smaller(x.second, y.second)};
  }
  friend SideBySide magnitude(SideBySide x) { return {magnitude(x.first), magnitude(x.second)}; }
  friend SideBySide times_sign_of(SideBySide x, SideBySide y) {
    return {times_sign_of(x.first, y.first), times_sign_of(x.second, y.second)};
  }
  friend SideBySide reciprocal_square_root_estimate(SideBySide x) {
    return {reciprocal_square_root_estimate(x.first), reciprocal_square_root_estimate(x.second)};
  }
#ifdef __FMA__
  friend SideBySide fused_sum(SideBySide x, SideBySide y, SideBySide z) {
    return {fused_sum(x.first, y.first, z.first), fused_sum(x.second, y.second, z.second)};
  }
  friend SideBySide fused_difference(SideBySide x, SideBySide y, SideBySide z) {
    return {fused_difference(x.first, y.first, z.first),
            fused_difference(x.second, y.second, z.second)};
  }
  friend SideBySide fused_remainder(SideBySide z, SideBySide x, SideBySide y) {
    return {fused_remainder(z.first, x.first, y.first),
            fused_remainder(z.second, x.second, y.second)};
  }
#endif
  friend void store(SideBySide x, double* to) {
    store(x.first, to);
    store(x.second, to + lane_count<T>);
  }
};

template <int bits, class T>
[[gnu::always_inline]] inline SideBySide<T> leading(SideBySide<T> x) {
  return {leading<bits>(x.first), leading<bits>(x.second)};
}

template <class T>
[[gnu::always_inline]] inline TangentEstimate<SideBySide<T>> tangent_estimate(SideBySide<T> x) {
  const TangentEstimate<T> first = tangent_estimate(x.first), second = tangent_estimate(x.second);
  return {{first.tangent, second.tangent}, {first.half_reciprocal, second.half_reciprocal}};
}

template <class T>
inline constexpr int lane_count<SideBySide<T>> = 2 * lane_count<T>;

template <>
[[gnu::always_inline]] inline SideBySide<Lanes<widest>> load(const double* from) {
  return {load<Lanes<widest>>(from), load<Lanes<widest>>(from + widest)};
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
