// SPDX-License-Identifier: MIT
// One attempt at a correctly rounded time or distance, in so many words; certified_encounters.hpp is what to call.
//
// Why more words settle every rounding at last. t_j = U_(j-1)/U_j and s_j = 1/U_j at x = 1/(1+alpha), with Chebyshev's
// U_j(x) = sin((j+1)h)/sin h. For j = 1 both are (1+alpha)/2, a multiple of half of alpha's last bit: once the bound
// is below half of that, they are known exactly, ties included. For j >= 2 neither is a binary fraction, so
// neither is a double or half way between two. Proof: there are three collisions or more, so alpha < 1 and
// 1 + alpha = p/2^m with p odd, p >= 3 and m >= 1, so 2x = Y/p with Y = 2^(m+1) even. U_j leads with (2x)^j and is a polynomial in 2x
// with integer coefficients, so N_j = p^j U_j is an integer without a prime of p, and s_j = p^j/N_j,
// t_j = p N_(j-1)/N_j. As N_j^2 - N_(j-1) N_(j+1) = p^(2j), N_j and N_(j-1) have no prime in common: if t_j or s_j is a
// binary fraction, N_j is +-2^i. Let j + 1 = 2^a r with r odd; U_(2k-1) = 2 T_k U_(k-1), so N_j is N_(r-1) times
// p^k 2 T_k for k = r, 2r, ..., all integers.
//   r = 2k+1 >= 3: N_2k = (N_k + p N_(k-1)) (N_k - p N_(k-1)) is odd (the constant term of U_2k is +-1, Y is even), so both
//   factors are +-1, and p >= 3 leaves N_(k-1) = 0: sin(kh) = 0. But 0 < kh < pi for k <= j.
//   r = 1, a >= 2: p^2 2 T_2 = Y^2 - 2 p^2 = 2 (2^(2m+1) - p^2), so 2^(2m+1) = p^2 +- 1; p^2 + 1 = 2 mod 8 is no such power,
//   and (p-1)(p+1) is one for p = 3 alone: alpha = 1/2, where only j <= 2 take place.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "magicmass/encounters_exact.hpp"
#include "magicmass/evaluators/ziv.hpp"

namespace magicmass {

/// t_1 and s_1 are multiples of 2^-grid.
inline int grid_at_collision(double alpha, std::uint64_t j) {
  if (j != 1) {
    return no_grid;
  }
  int exponent = 0;
  const auto digits = static_cast<std::uint64_t>(std::frexp(alpha, &exponent) * 0x1p53);
  return 1 + std::max(0, 53 - exponent - std::countr_zero(digits));
}

/// Both for j >= 1.
template <std::size_t Words>
std::optional<generated::Encounters<double>> attempt_encounters(double alpha, std::uint64_t j) {
  const auto encounter = generated::encounters_exact(NearInteger<Words>(alpha), j);
  const int grid = grid_at_collision(alpha, j);
  const auto t = rounded(encounter.t, grid);
  const auto s = rounded(encounter.s, grid);
  if (!t || !s) {
    return std::nullopt;
  }
  return generated::Encounters<double>{*t, *s};
}

}  // namespace magicmass
