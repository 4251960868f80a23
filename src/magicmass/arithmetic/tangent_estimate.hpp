// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <immintrin.h>

#include "magicmass/arithmetic/lanes.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// sqrt(x/(2 + x)) within 2^-22.6 and 1/(2 x) within 2^-23, of 24 bits each, for x from 2^-120 to 2^120; each step is rounded as IEEE
/// says, so that it is the same on every machine.
template <class T>
struct TangentEstimate {
  T tangent;
  T half_reciprocal;
};
// x, 2 + x, their quotient, which is halved with them, and the root.
[[gnu::always_inline]] inline TangentEstimate<double> tangent_estimate(double x) {
  const auto single = static_cast<float>(x);
  return {static_cast<double>(std::sqrt(single / (2.0F + single))),
          static_cast<double>(0.5F / single)};
}
[[gnu::always_inline]] inline TangentEstimate<Lanes<2>> tangent_estimate(Lanes<2> x) {
  const __m128 single = _mm_cvtpd_ps(x.v);
  return {_mm_cvtps_pd(_mm_sqrt_ps(_mm_div_ps(single, _mm_add_ps(_mm_set1_ps(2.0F), single)))),
          _mm_cvtps_pd(_mm_div_ps(_mm_set1_ps(0.5F), single))};
}
#ifdef __AVX2__
[[gnu::always_inline]] inline TangentEstimate<Lanes<4>> tangent_estimate(Lanes<4> x) {
  const __m128 single = _mm256_cvtpd_ps(x.v);
  return {_mm256_cvtps_pd(_mm_sqrt_ps(_mm_div_ps(single, _mm_add_ps(_mm_set1_ps(2.0F), single)))),
          _mm256_cvtps_pd(_mm_div_ps(_mm_set1_ps(0.5F), single))};
}
#endif
#ifdef __AVX512F__
[[gnu::always_inline]] inline TangentEstimate<Lanes<8>> tangent_estimate(Lanes<8> x) {
  const __m256 single = _mm512_cvtpd_ps(x.v);
  return {_mm512_cvtps_pd(
              _mm256_sqrt_ps(_mm256_div_ps(single, _mm256_add_ps(_mm256_set1_ps(2.0F), single)))),
          _mm512_cvtps_pd(_mm256_div_ps(_mm256_set1_ps(0.5F), single))};
}
#endif

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
