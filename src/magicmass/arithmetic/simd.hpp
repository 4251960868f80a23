// SPDX-License-Identifier: MIT
// The one file that knows a processor. T is `double`, or `Simd`: as many doubles, its lanes, as a
// register holds (AVX-512: 8, AVX2: 4, else 2), in the compiler's vector extension.
#pragma once

#include <cstdint>
#include <cstring>

#include "magicmass/arithmetic/ieee.hpp"

#if defined(__x86_64__) || defined(__i386__)
#include <immintrin.h>
#endif

// Each target has its own inline namespace, and all functions are always inlined: otherwise the
// linker may keep one target's copy of an inline function for all of them.
#if defined(__AVX512F__)
#define MAGICMASS_TARGET avx512
#elif defined(__AVX2__) && defined(__FMA__)
#define MAGICMASS_TARGET avx2
#else
#define MAGICMASS_TARGET baseline
#endif

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {
#if defined(__AVX512F__)
inline constexpr int lanes = 8;
#elif defined(__AVX2__) && defined(__FMA__)
inline constexpr int lanes = 4;
#else
inline constexpr int lanes = 2;
#endif
#if defined(__FMA__) || defined(__aarch64__)
inline constexpr bool has_fma = true;
#else
inline constexpr bool has_fma = false;
#endif

#if defined(__x86_64__) || defined(__i386__)
/// Whether the processor runs what is compiled for a target, and the system saves its registers.
[[gnu::always_inline]] inline bool runs_avx2() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}
[[gnu::always_inline]] inline bool runs_avx512() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
}
#endif

typedef double Simd __attribute__((vector_size(8 * lanes)));
typedef std::int64_t SimdMask __attribute__((vector_size(8 * lanes)));
// One number is compared and selected in a register of two: no branch, so nothing to mispredict.
typedef double Two __attribute__((vector_size(16)));
typedef std::int64_t TwoMask __attribute__((vector_size(16)));

/// x in every lane.
template <class T>
[[gnu::always_inline]] inline T all(double x) {
  if constexpr (sizeof(T) == sizeof(double))
    return x;
  else
    return x - T{};
}

[[gnu::always_inline]] inline double square_root(double x) {
#if defined(__SSE2__)
  const __m128d two = _mm_set_sd(x);
  return _mm_cvtsd_f64(_mm_sqrt_sd(two, two));
#else
  return __builtin_sqrt(x);
#endif
}
[[gnu::always_inline]] inline Simd square_root(Simd x) {
#if defined(__AVX512F__)
  return _mm512_maskz_sqrt_pd(0xff, x);  // all lanes; the plain one makes g++ 12 warn
#elif defined(__AVX2__) && defined(__FMA__)
  return _mm256_sqrt_pd(x);
#elif defined(__SSE2__)
  return _mm_sqrt_pd(x);
#else
  Simd r = x;
  for (int lane = 0; lane < lanes; ++lane) r[lane] = __builtin_sqrt(x[lane]);
  return r;
#endif
}

/// x y + z, rounded once. Without `has_fma` it is libm's function: slow, but with the same bits.
[[gnu::always_inline]] inline double fused(double x, double y, double z) {
  return __builtin_fma(x, y, z);
}
[[gnu::always_inline]] inline Simd fused(Simd x, Simd y, Simd z) {
#if defined(__AVX512F__)
  return _mm512_fmadd_pd(x, y, z);
#elif defined(__AVX2__) && defined(__FMA__)
  return _mm256_fmadd_pd(x, y, z);
#else
  Simd r = x;
  for (int lane = 0; lane < lanes; ++lane) r[lane] = __builtin_fma(x[lane], y[lane], z[lane]);
  return r;
#endif
}

template <class T, class V>
[[gnu::always_inline]] inline T load(const V* from) {
  T x;
  std::memcpy(&x, from, sizeof x);
  return x;
}
template <class T, class V>
[[gnu::always_inline]] inline void store(V* to, T x) {
  std::memcpy(to, &x, sizeof x);
}

[[gnu::always_inline]] inline SimdMask is_above(Simd x, Simd y) { return x > y; }
[[gnu::always_inline]] inline TwoMask is_above(double x, double y) { return Two{x, x} > Two{y, y}; }
[[gnu::always_inline]] inline Simd select(SimdMask c, Simd x, Simd y) {
  return Simd((c & SimdMask(x)) | (~c & SimdMask(y)));
}
[[gnu::always_inline]] inline double select(TwoMask c, double x, double y) {
  return Two((c & TwoMask(Two{x, x})) | (~c & TwoMask(Two{y, y})))[0];
}
[[gnu::always_inline]] inline Simd magnitude(Simd x) { return Simd(SimdMask(x) & INT64_MAX); }
[[gnu::always_inline]] inline double magnitude(double x) { return __builtin_fabs(x); }
/// x with its sign changed where y's sign bit is set.
[[gnu::always_inline]] inline Simd times_sign_of(Simd x, Simd y) {
  return Simd(SimdMask(x) ^ (SimdMask(y) & INT64_MIN));
}
[[gnu::always_inline]] inline double times_sign_of(double x, double y) {
  return Two(TwoMask(Two{x, x}) ^ (TwoMask(Two{y, y}) & INT64_MIN))[0];
}

/// The whole number nearest to x, ties to even; |x| <= 2^51.
template <class T>
[[gnu::always_inline]] inline T nearest(T x) {
  return (x + 0x1.8p52) - 0x1.8p52;
}
/// Whole numbers from 0 to 2^52 - 1 to doubles, exactly, and back.
[[gnu::always_inline]] inline Simd to_real(SimdMask n) {
  return Simd(n | SimdMask(all<Simd>(0x1p52))) - 0x1p52;
}
[[gnu::always_inline]] inline SimdMask to_whole(Simd n) {
  return SimdMask(n + 0x1p52) & 0xfffffffffffff;
}
[[gnu::always_inline]] inline void store(std::int64_t* to, Simd n) { store(to, to_whole(n)); }
[[gnu::always_inline]] inline double to_real(std::int64_t n) { return double(n); }
/// 0 for NaN, which a row in doubt may have.
[[gnu::always_inline]] inline std::int64_t to_whole(double n) {
  return std::int64_t(n < 0x1p63 ? n : 0.0);
}
}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
