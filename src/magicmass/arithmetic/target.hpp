// SPDX-License-Identifier: MIT
#pragma once

/// Each instruction set is a namespace of its own: one program holds all of them, and the linker must never take a
/// function compiled for one in place of another's.
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__) && defined(__FMA__)
#define MAGICMASS_TARGET avx512
#elif defined(__AVX2__) && defined(__FMA__)
#define MAGICMASS_TARGET avx2
#else
#define MAGICMASS_TARGET baseline
#endif

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// Doubles in the widest register.
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__) && defined(__FMA__)
inline constexpr int widest = 8;
#elif defined(__AVX2__) && defined(__FMA__)
inline constexpr int widest = 4;
#else
inline constexpr int widest = 2;
#endif

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
