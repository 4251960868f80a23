// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <immintrin.h>

#include "magicmass/arithmetic/target.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

template <int N>
struct LaneTypes {
  typedef double Doubles __attribute__((vector_size(8 * N)));
  typedef std::int64_t Integers __attribute__((vector_size(8 * N)));
};

/// N doubles (2, 4 or 8) that do the same at once. Every operation is IEEE's, rounded to nearest, lane by lane, so that the
/// number of lanes never shows in a result. With `double` in place of Lanes<N> all functions below work on one number.
template <int N>
struct Lanes {
  using Doubles = typename LaneTypes<N>::Doubles;
  using Mask = typename LaneTypes<N>::Integers;  ///< all bits set where true

  Doubles v;

  Lanes() = default;
  Lanes(Doubles doubles) : v(doubles) {}
  Lanes(double all) : v(all - Doubles{}) {}

  friend Lanes operator+(Lanes x, Lanes y) { return x.v + y.v; }
  friend Lanes operator-(Lanes x, Lanes y) { return x.v - y.v; }
  friend Lanes operator*(Lanes x, Lanes y) { return x.v * y.v; }
  friend Lanes operator/(Lanes x, Lanes y) { return x.v / y.v; }
  friend Lanes operator-(Lanes x) { return -x.v; }
  friend Mask operator<(Lanes x, Lanes y) { return x.v < y.v; }
  friend Mask operator>(Lanes x, Lanes y) { return x.v > y.v; }
  friend Mask operator<=(Lanes x, Lanes y) { return x.v <= y.v; }
  friend Mask operator>=(Lanes x, Lanes y) { return x.v >= y.v; }
  friend Mask operator==(Lanes x, Lanes y) { return x.v == y.v; }
};

template <class T>
inline constexpr int lane_count = 1;
template <int N>
inline constexpr int lane_count<Lanes<N>> = N;

/// From and to consecutive doubles, aligned or not.
template <class T>
[[gnu::always_inline]] inline T load(const double* from) {
  T result;
  std::memcpy(&result, from, sizeof result);
  return result;
}
template <class T>
[[gnu::always_inline]] inline void store(T x, double* to) {
  std::memcpy(to, &x, sizeof x);
}

[[gnu::always_inline]] inline double select(bool condition, double yes, double no) {
  return condition ? yes : no;
}
template <int N>
[[gnu::always_inline]] inline Lanes<N> select(typename Lanes<N>::Mask condition, Lanes<N> yes,
                                              Lanes<N> no) {
#ifdef __AVX512F__
  return condition ? yes.v : no.v;
#else
  // three operations of logic: a blend by mask costs as much, and SSE2 has none
  using Bits = typename Lanes<N>::Mask;
  const Bits no_bits = std::bit_cast<Bits>(no.v);
  return std::bit_cast<typename Lanes<N>::Doubles>(
      no_bits ^ ((no_bits ^ std::bit_cast<Bits>(yes.v)) & condition));
#endif
}
/// Whether it holds in every lane.
[[gnu::always_inline]] inline bool all(bool condition) { return condition; }
[[gnu::always_inline]] inline bool all(Lanes<2>::Mask condition) {
  return _mm_movemask_pd(std::bit_cast<__m128d>(condition)) == 3;
}

/// yes where the condition holds, else +0.
[[gnu::always_inline]] inline double where(bool condition, double yes) {
  return condition ? yes : 0.0;
}
template <int N>
[[gnu::always_inline]] inline Lanes<N> where(typename Lanes<N>::Mask condition, Lanes<N> yes) {
#ifdef __AVX512F__
  return condition ? yes.v : typename Lanes<N>::Doubles{};
#else
  using Bits = typename Lanes<N>::Mask;
  return std::bit_cast<typename Lanes<N>::Doubles>(std::bit_cast<Bits>(yes.v) & condition);
#endif
}

/// x with all but its leading bits cleared, of 53.
template <int bits>
[[gnu::always_inline]] inline double leading(double x) {
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(x) & -(std::int64_t{1} << (53 - bits)));
}
template <int bits, int N>
[[gnu::always_inline]] inline Lanes<N> leading(Lanes<N> x) {
  using Bits = typename Lanes<N>::Mask;
  return std::bit_cast<typename Lanes<N>::Doubles>(std::bit_cast<Bits>(x.v) &
                                                   (Bits{} - (std::int64_t{1} << (53 - bits))));
}

[[gnu::always_inline]] inline double magnitude(double x) { return std::fabs(x); }
template <int N>
[[gnu::always_inline]] inline Lanes<N> magnitude(Lanes<N> x) {
  using Bits = typename Lanes<N>::Mask;
  return std::bit_cast<typename Lanes<N>::Doubles>(std::bit_cast<Bits>(x.v) &
                                                   (Bits{} + 0x7fffffffffffffff));
}

/// x where y is positive or +0, -x where y is negative or -0.
[[gnu::always_inline]] inline double times_sign_of(double x, double y) {
  const __m128d sign = _mm_and_pd(_mm_set_sd(y), _mm_set_sd(-0.0));
  return _mm_cvtsd_f64(_mm_xor_pd(_mm_set_sd(x), sign));
}
template <int N>
[[gnu::always_inline]] inline Lanes<N> times_sign_of(Lanes<N> x, Lanes<N> y) {
  using Bits = typename Lanes<N>::Mask;
  const Bits sign = std::bit_cast<Bits>(y.v) & std::bit_cast<Bits>(Lanes<N>(-0.0).v);
  return std::bit_cast<typename Lanes<N>::Doubles>(std::bit_cast<Bits>(x.v) ^ sign);
}

/// The smaller, or y where x or y is not a number.
[[gnu::always_inline]] inline double smaller(double x, double y) {
  return _mm_cvtsd_f64(_mm_min_sd(_mm_set_sd(x), _mm_set_sd(y)));
}
[[gnu::always_inline]] inline Lanes<2> smaller(Lanes<2> x, Lanes<2> y) {
  return _mm_min_pd(x.v, y.v);
}
#ifdef __AVX2__
[[gnu::always_inline]] inline Lanes<4> smaller(Lanes<4> x, Lanes<4> y) {
  return _mm256_min_pd(x.v, y.v);
}
#endif
#ifdef __AVX512F__
[[gnu::always_inline]] inline Lanes<8> smaller(Lanes<8> x, Lanes<8> y) {
  return _mm512_min_pd(x.v, y.v);
}
#endif

[[gnu::always_inline]] inline double square_root(double x) { return __builtin_sqrt(x); }
[[gnu::always_inline]] inline Lanes<2> square_root(Lanes<2> x) { return _mm_sqrt_pd(x.v); }
#ifdef __AVX2__
[[gnu::always_inline]] inline Lanes<4> square_root(Lanes<4> x) { return _mm256_sqrt_pd(x.v); }
#endif
#ifdef __AVX512F__
[[gnu::always_inline]] inline Lanes<8> square_root(Lanes<8> x) { return _mm512_sqrt_pd(x.v); }
#endif

/// 1/sqrt(x) and 1/x within 2^-22.5, for x from 2^-126 to 2^126; a float's worth of digits, each step rounded as IEEE
/// says, so that it is the same on every machine, which the processors' own estimates are not.
[[gnu::always_inline]] inline double reciprocal_square_root_estimate(double x) {
  return static_cast<double>(1.0F / std::sqrt(static_cast<float>(x)));
}
[[gnu::always_inline]] inline Lanes<2> reciprocal_square_root_estimate(Lanes<2> x) {
  return _mm_cvtps_pd(_mm_div_ps(_mm_set1_ps(1.0F), _mm_sqrt_ps(_mm_cvtpd_ps(x.v))));
}
[[gnu::always_inline]] inline double reciprocal_estimate(double x) {
  return static_cast<double>(1.0F / static_cast<float>(x));
}
[[gnu::always_inline]] inline Lanes<2> reciprocal_estimate(Lanes<2> x) {
  return _mm_cvtps_pd(_mm_div_ps(_mm_set1_ps(1.0F), _mm_cvtpd_ps(x.v)));
}
#ifdef __AVX2__
[[gnu::always_inline]] inline Lanes<4> reciprocal_square_root_estimate(Lanes<4> x) {
  return _mm256_cvtps_pd(_mm_div_ps(_mm_set1_ps(1.0F), _mm_sqrt_ps(_mm256_cvtpd_ps(x.v))));
}
[[gnu::always_inline]] inline Lanes<4> reciprocal_estimate(Lanes<4> x) {
  return _mm256_cvtps_pd(_mm_div_ps(_mm_set1_ps(1.0F), _mm256_cvtpd_ps(x.v)));
}
#endif
#ifdef __AVX512F__
[[gnu::always_inline]] inline Lanes<8> reciprocal_square_root_estimate(Lanes<8> x) {
  return _mm512_cvtps_pd(_mm256_div_ps(_mm256_set1_ps(1.0F), _mm256_sqrt_ps(_mm512_cvtpd_ps(x.v))));
}
[[gnu::always_inline]] inline Lanes<8> reciprocal_estimate(Lanes<8> x) {
  return _mm512_cvtps_pd(_mm256_div_ps(_mm256_set1_ps(1.0F), _mm512_cvtpd_ps(x.v)));
}
#endif

/// The whole number nearest to x, |x| < 2^51, ties to even.
template <class T>
[[gnu::always_inline]] inline T nearest_whole(T x) {
  const T shift(0x1.8p52);
  return (x + shift) - shift;
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
