// SPDX-License-Identifier: MIT
// One attempt at correctly rounded velocities, in so many words; certified_velocities.hpp is what to call.
//
// Why more words settle every rounding at last. With x = 1/(1+alpha), so that V_CM = x/(1+x) and alpha = (1-x)/x, the
// generated forms read for n >= 1, T_m being the Chebyshev polynomials,
//
//     a_n (1+x) = x + T_2n,            c_n (1-x^2) = x (1 - x + T_(2n-1) - T_2n),
//     b_n (1+x) = x - T_(2n+1),       c'_n (1-x^2) = x (1 - x + T_(2n+1) - T_2n).
//
// The right sides vanish at x = -1, those of c and c' at x = 1 too (T_m(1) = 1, T_m(-1) = (-1)^m), so the velocities
// are polynomials in x with integer coefficients; as T_m leads with 2^(m-1) x^m, a and c lead with +-2^(2n-1) x^(2n-1)
// and b and c' with +-2^(2n) x^(2n). Now 1 + alpha = p 2^q with p odd, so x = 2^-q/p. If p > 1, the leading term alone has the
// denominator p^degree, and its numerator, a power of two, does not reduce it: some odd prime stays in the
// velocity's denominator. There is none in a double's, nor in that of a number half way between two doubles. So
// the velocity is neither, and enough words tell it from the nearest such number. The same holds for b^2.
//
// If p = 1, alpha = 2^j - 1 with 1 <= j <= 53, and the velocity is a multiple of 2^-(j degree): as soon as the bound is
// below half of that, it is known exactly. For j = 1 (alpha = 1) it is 0 or 1 for every n, and where it is 0, all that
// it is made of is exact. For j >= 2, 2 T_m(x) is a polynomial in 2x with integer coefficients that leads with 1, so
// the velocities have the denominator 2^((j-1) degree) but for a few bits, and only small n can give a tie.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "magicmass/evaluators/ziv.hpp"
#include "magicmass/velocities_exact.hpp"

namespace magicmass {

/// Where 1 + alpha is a power of two, 2^j: polynomials in x of that degree with integer coefficients are multiples of
/// 2^-grid, grid = j degree. no_grid for other alpha, and where it is of no use.
inline int grid_at(double alpha, std::uint64_t degree) {
  constexpr std::uint64_t largest_degree = 4096;
  if (!(alpha >= 1.0 && alpha < 0x1p53) || degree > largest_degree) {
    return no_grid;
  }
  int exponent = 0;
  const bool is_power = std::frexp(alpha + 1.0, &exponent) == 0.5 && std::trunc(alpha) == alpha;
  return is_power ? (exponent - 1) * static_cast<int>(degree) : no_grid;
}

/// a, b, c or c' as `Form` computes it from alpha and n >= 1.
template <std::size_t Words, class Form>
std::optional<double> attempt_velocity(const Form& form, double alpha, std::uint64_t n) {
  return rounded(form(NearInteger<Words>(alpha), n), grid_at(alpha, 2 * n));
}

/// All four for n >= 1, those that are certain.
template <std::size_t Words>
generated::Velocities<std::optional<double>> attempt_velocities(double alpha, std::uint64_t n) {
  const auto v = generated::velocities_exact(NearInteger<Words>(alpha), n);
  const int grid = grid_at(alpha, 2 * n);
  return {rounded(v.a, grid), rounded(v.b, grid), rounded(v.c, grid), rounded(v.c_prime, grid)};
}

/// b_n^2 for n >= 1.
template <std::size_t Words>
std::optional<double> attempt_energy_fraction(double alpha, std::uint64_t n) {
  const NearInteger<Words> b = generated::b_exact(NearInteger<Words>(alpha), n);
  return rounded(b * b, grid_at(alpha, 4 * n));
}

}  // namespace magicmass
