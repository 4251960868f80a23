// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <immintrin.h>

#include "magicmass/arithmetic/target.hpp"

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

/// A whole register as 64-bit words, 32-bit words or single-precision numbers: the word 2 i and the word 2 i + 1 of the
/// latter two make up the word i of the first.
inline constexpr std::size_t register_bytes = sizeof(double) * arithmetic::widest;
typedef std::uint64_t Longs __attribute__((vector_size(register_bytes)));
typedef std::uint32_t Words __attribute__((vector_size(register_bytes)));
typedef float Singles __attribute__((vector_size(register_bytes)));

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
/// 1/sqrt(x) within a relative 2^-14. What a processor makes of it differs: fit for decisions that allow for
/// all of the error, not for results.
[[gnu::always_inline]] inline Singles root_guess(Singles x) { return _mm512_rsqrt14_ps(x); }
inline constexpr double root_guess_error = 0x1p-14;
/// Without the fraction; 2^31 where that does not fit 31 bits.
[[gnu::always_inline]] inline Words truncated(Singles x) { return (Words)_mm512_cvttps_epi32(x); }
/// x y + z and z - x y; rounded once or twice.
[[gnu::always_inline]] inline Singles multiply_add(Singles x, Singles y, Singles z) {
  return _mm512_fmadd_ps(x, y, z);
}
[[gnu::always_inline]] inline Singles subtract_product(Singles z, Singles x, Singles y) {
  return _mm512_fnmadd_ps(x, y, z);
}
/// found | (x ^ y)
[[gnu::always_inline]] inline Words collect_difference(Words found, Words x, Words y) {
  return (Words)_mm512_ternarylogic_epi32((__m512i)found, (__m512i)x, (__m512i)y, 0xf6);
}
#elif defined(__AVX2__)
[[gnu::always_inline]] inline Words interleaved(Longs even, Longs odd) {
  return (Words)_mm256_blend_epi32((__m256i)even, (__m256i)odd, 0xaa);
}
[[gnu::always_inline]] inline Singles smaller(Singles x, Singles y) { return _mm256_min_ps(x, y); }
[[gnu::always_inline]] inline Singles root_guess(Singles x) { return _mm256_rsqrt_ps(x); }
inline constexpr double root_guess_error = 0x1.8p-12;
[[gnu::always_inline]] inline Words truncated(Singles x) { return (Words)_mm256_cvttps_epi32(x); }
[[gnu::always_inline]] inline Singles multiply_add(Singles x, Singles y, Singles z) {
  return _mm256_fmadd_ps(x, y, z);
}
[[gnu::always_inline]] inline Singles subtract_product(Singles z, Singles x, Singles y) {
  return _mm256_fnmadd_ps(x, y, z);
}
[[gnu::always_inline]] inline Words collect_difference(Words found, Words x, Words y) {
  return found | (x ^ y);
}
#else
[[gnu::always_inline]] inline Words interleaved(Longs even, Longs odd) {
  return (Words)((even & 0x00000000ffffffff) | (odd & 0xffffffff00000000));
}
[[gnu::always_inline]] inline Singles smaller(Singles x, Singles y) { return _mm_min_ps(x, y); }
[[gnu::always_inline]] inline Singles root_guess(Singles x) { return _mm_rsqrt_ps(x); }
inline constexpr double root_guess_error = 0x1.8p-12;
[[gnu::always_inline]] inline Words truncated(Singles x) { return (Words)_mm_cvttps_epi32(x); }
[[gnu::always_inline]] inline Singles multiply_add(Singles x, Singles y, Singles z) {
  return x * y + z;
}
[[gnu::always_inline]] inline Singles subtract_product(Singles z, Singles x, Singles y) {
  return z - x * y;
}
[[gnu::always_inline]] inline Words collect_difference(Words found, Words x, Words y) {
  return found | (x ^ y);
}
#endif

/// Whether any bit is set.
[[gnu::always_inline]] inline bool has_bits(Longs x) {
  std::uint64_t any = 0;
  for (int i = 0; i < arithmetic::widest; ++i) any |= x[i];
  return any != 0;
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::batch
