// SPDX-License-Identifier: MIT
// Operations for decisions that allow for all of the error: fused where the instruction set has that, estimates as the
// processor makes them. Never for results, which have to be the same bits everywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <immintrin.h>

#include "magicmass/arithmetic/lanes.hpp"

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

/// A whole register as 64-bit words, 32-bit words or single-precision numbers: the words 2 i and 2 i + 1 of the
/// latter two make up the word i of the first.
inline constexpr std::size_t register_bytes = sizeof(double) * arithmetic::widest;
typedef std::uint64_t Longs __attribute__((vector_size(register_bytes)));
typedef std::uint32_t Words __attribute__((vector_size(register_bytes)));
typedef float Singles __attribute__((vector_size(register_bytes)));
using Doubles = arithmetic::Lanes<arithmetic::widest>;

[[gnu::always_inline]] inline Longs load_longs(const void* from) {
  Longs result;
  std::memcpy(&result, from, sizeof result);
  return result;
}
[[gnu::always_inline]] inline void store_longs(Longs x, void* to) { std::memcpy(to, &x, sizeof x); }
[[gnu::always_inline]] inline Singles all(float x) { return x - Singles{}; }

#if defined(__AVX512F__)
/// Even words of the one, odd words of the other.
[[gnu::always_inline]] inline Words interleaved(Longs even, Longs odd) {
  return (Words)_mm512_mask_blend_epi32(0xaaaa, (__m512i)even, (__m512i)odd);
}
/// The smaller, or y where x or y is not a number.
[[gnu::always_inline]] inline Singles smaller(Singles x, Singles y) { return _mm512_min_ps(x, y); }
/// 1/sqrt(x) within a relative root_guess_error.
[[gnu::always_inline]] inline Singles root_guess(Singles x) { return _mm512_rsqrt14_ps(x); }
[[gnu::always_inline]] inline Doubles root_guess(Doubles x) { return _mm512_rsqrt14_pd(x.v); }
inline constexpr double root_guess_error = 0x1p-14;
inline constexpr double double_root_guess_error = 0x1p-14;
/// x y + z and z - x y, rounded once or twice.
[[gnu::always_inline]] inline Singles multiply_add(Singles x, Singles y, Singles z) {
  return _mm512_fmadd_ps(x, y, z);
}
[[gnu::always_inline]] inline Singles subtract_product(Singles z, Singles x, Singles y) {
  return _mm512_fnmadd_ps(x, y, z);
}
[[gnu::always_inline]] inline Doubles multiply_add(Doubles x, Doubles y, Doubles z) {
  return _mm512_fmadd_pd(x.v, y.v, z.v);
}
[[gnu::always_inline]] inline Doubles subtract_product(Doubles z, Doubles x, Doubles y) {
  return _mm512_fnmadd_pd(x.v, y.v, z.v);
}
/// q without its fraction; sets bits of `open` unless q widening has the same whole part, and that below 2^31.
[[gnu::always_inline]] inline Words whole_part(Singles q, float widening, Words& open) {
  // what does not fit is 2^31 in the one and 2^32 - 1 in the other
  const __m512i low = _mm512_cvttps_epi32(q), high = _mm512_cvttps_epu32(q * all(widening));
  open = (Words)_mm512_ternarylogic_epi32((__m512i)open, low, high, 0xf6);  // open | (low ^ high)
  return (Words)low;
}
[[gnu::always_inline]] inline bool has_bits(Longs x) {
  return _mm512_test_epi64_mask((__m512i)x, (__m512i)x) != 0;
}
#else
#if defined(__AVX2__)
[[gnu::always_inline]] inline Words interleaved(Longs even, Longs odd) {
  return (Words)_mm256_blend_epi32((__m256i)even, (__m256i)odd, 0xaa);
}
[[gnu::always_inline]] inline Singles smaller(Singles x, Singles y) { return _mm256_min_ps(x, y); }
[[gnu::always_inline]] inline Singles root_guess(Singles x) { return _mm256_rsqrt_ps(x); }
[[gnu::always_inline]] inline Words truncated(Singles x) { return (Words)_mm256_cvttps_epi32(x); }
[[gnu::always_inline]] inline Singles multiply_add(Singles x, Singles y, Singles z) {
  return _mm256_fmadd_ps(x, y, z);
}
[[gnu::always_inline]] inline Singles subtract_product(Singles z, Singles x, Singles y) {
  return _mm256_fnmadd_ps(x, y, z);
}
[[gnu::always_inline]] inline Doubles multiply_add(Doubles x, Doubles y, Doubles z) {
  return _mm256_fmadd_pd(x.v, y.v, z.v);
}
[[gnu::always_inline]] inline Doubles subtract_product(Doubles z, Doubles x, Doubles y) {
  return _mm256_fnmadd_pd(x.v, y.v, z.v);
}
[[gnu::always_inline]] inline bool has_bits(Longs x) {
  return _mm256_testz_si256((__m256i)x, (__m256i)x) == 0;
}
#else
[[gnu::always_inline]] inline Words interleaved(Longs even, Longs odd) {
  return (Words)((even & 0x00000000ffffffff) | (odd & 0xffffffff00000000));
}
[[gnu::always_inline]] inline Singles smaller(Singles x, Singles y) { return _mm_min_ps(x, y); }
[[gnu::always_inline]] inline Singles root_guess(Singles x) { return _mm_rsqrt_ps(x); }
[[gnu::always_inline]] inline Words truncated(Singles x) { return (Words)_mm_cvttps_epi32(x); }
[[gnu::always_inline]] inline Singles multiply_add(Singles x, Singles y, Singles z) {
  return x * y + z;
}
[[gnu::always_inline]] inline Singles subtract_product(Singles z, Singles x, Singles y) {
  return z - x * y;
}
[[gnu::always_inline]] inline Doubles multiply_add(Doubles x, Doubles y, Doubles z) {
  return x * y + z;
}
[[gnu::always_inline]] inline Doubles subtract_product(Doubles z, Doubles x, Doubles y) {
  return z - x * y;
}
[[gnu::always_inline]] inline bool has_bits(Longs x) { return (x[0] | x[1]) != 0; }
#endif
[[gnu::always_inline]] inline Doubles root_guess(Doubles x) {
  return reciprocal_square_root_estimate(x);
}
inline constexpr double root_guess_error = 0x1.8p-12;
inline constexpr double double_root_guess_error = 0x1p-22;
[[gnu::always_inline]] inline Words whole_part(Singles q, float widening, Words& open) {
  // from 2^24 on, and from what is not a number, the two below differ
  const Singles low = smaller(q, all(0x1p24F));
  const Words whole = truncated(low);
  open |= whole ^ truncated(low * all(widening));
  return whole;
}
#endif

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::batch
