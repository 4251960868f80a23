// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

namespace magicmass::algebraic {

/// Forms longer than this many characters, or in fields of a higher degree, are not given.
constexpr std::size_t longest_radicals = 100;
/// See longest_radicals.
constexpr long largest_radical_degree = 64;

/// sec(pi/n) - 1, n >= 3, in real square roots: "sqrt(5) - 2". Each form was proved equal by sign_of. Nothing where
/// there is none (real_radicals_exist) or none that is short. Throws InvalidInput for n < 3.
std::optional<std::string> secant_radicals(long n);

/// Of alpha_k = sec(pi/(2k+1)) - 1, k >= 1 (Ee & Lee, Table II). Throws InvalidInput for k < 1.
std::optional<std::string> magic_radicals(long k);
/// Of beta_k = sec(pi/(2(k+1))) - 1, k >= 1. Throws InvalidInput for k < 1.
std::optional<std::string> deficient_radicals(long k);

/// Whether sec(pi/n), n >= 3, can be written with real radicals of any kind: if and only if its degree phi(2n)/2 is a power of
/// 2, that is, the regular n-gon is constructible. All its conjugates are real, and a number in a real radical
/// extension whose conjugates are all real is of such a degree (Isaacs, Solution of polynomials by real radicals,
/// 1985); the classical casus irreducibilis is the cubic of n = 7. Conversely such an n has square roots alone.
/// Throws InvalidInput for n < 3.
bool real_radicals_exist(long n);

}  // namespace magicmass::algebraic
