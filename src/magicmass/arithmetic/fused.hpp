// SPDX-License-Identifier: MIT
// Products and sums in one rounding, where the instruction set has that. Each sign is written out: of -x in place of x a compiler
// makes an operation where it has use for it twice.
#pragma once

#include "magicmass/arithmetic/lanes.hpp"

#ifdef __FMA__
namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// x y + z, rounded once.
[[gnu::always_inline]] inline double fused_sum(double x, double y, double z) {
  return __builtin_fma(x, y, z);
}
[[gnu::always_inline]] inline Lanes<2> fused_sum(Lanes<2> x, Lanes<2> y, Lanes<2> z) {
  return _mm_fmadd_pd(x.v, y.v, z.v);
}
[[gnu::always_inline]] inline Lanes<4> fused_sum(Lanes<4> x, Lanes<4> y, Lanes<4> z) {
  return _mm256_fmadd_pd(x.v, y.v, z.v);
}
#ifdef __AVX512F__
[[gnu::always_inline]] inline Lanes<8> fused_sum(Lanes<8> x, Lanes<8> y, Lanes<8> z) {
  return _mm512_fmadd_pd(x.v, y.v, z.v);
}
#endif
/// x y - z, rounded once.
[[gnu::always_inline]] inline double fused_difference(double x, double y, double z) {
  return __builtin_fma(x, y, -z);
}
[[gnu::always_inline]] inline Lanes<2> fused_difference(Lanes<2> x, Lanes<2> y, Lanes<2> z) {
  return _mm_fmsub_pd(x.v, y.v, z.v);
}
[[gnu::always_inline]] inline Lanes<4> fused_difference(Lanes<4> x, Lanes<4> y, Lanes<4> z) {
  return _mm256_fmsub_pd(x.v, y.v, z.v);
}
#ifdef __AVX512F__
[[gnu::always_inline]] inline Lanes<8> fused_difference(Lanes<8> x, Lanes<8> y, Lanes<8> z) {
  return _mm512_fmsub_pd(x.v, y.v, z.v);
}
#endif
/// z - x y, rounded once.
[[gnu::always_inline]] inline double fused_remainder(double z, double x, double y) {
  return __builtin_fma(-x, y, z);
}
[[gnu::always_inline]] inline Lanes<2> fused_remainder(Lanes<2> z, Lanes<2> x, Lanes<2> y) {
  return _mm_fnmadd_pd(x.v, y.v, z.v);
}
[[gnu::always_inline]] inline Lanes<4> fused_remainder(Lanes<4> z, Lanes<4> x, Lanes<4> y) {
  return _mm256_fnmadd_pd(x.v, y.v, z.v);
}
#ifdef __AVX512F__
[[gnu::always_inline]] inline Lanes<8> fused_remainder(Lanes<8> z, Lanes<8> x, Lanes<8> y) {
  return _mm512_fnmadd_pd(x.v, y.v, z.v);
}
#endif

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
#endif
