// SPDX-License-Identifier: GPL-2.0-or-later
// Between machine numbers, mass ratios, text and exact rationals; every rounding is to nearest, ties to even.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>

#include <cln/rational.h>

#include "magicmass/scenes/mass_ratio.hpp"

namespace magicmass::reference {

/// The value of a finite floating-point number, exactly. Throws InvalidInput for an infinity or NaN.
cln::cl_RA exact(float value);
/// Likewise.
cln::cl_RA exact(double value);
/// Likewise.
cln::cl_RA exact(long double value);

/// The value of a mass ratio that is a rational by its form; nullopt for Magic and Deficient.
std::optional<cln::cl_RA> exact(const MassRatio& alpha);

/// The float, double or long double nearest to x: ties to even, subnormals as they are spaced, infinity from the
/// largest finite number plus half its spacing on.
template <std::floating_point Float>
Float nearest(const cln::cl_RA& x);

/// |got - exact| / ulp(exact), real-valued; ulp(y) is the spacing of Float in the binade [2^e, 2^(e+1)) of |y|,
/// the subnormal spacing below the normal range and the last binade's above it. Infinity if got is not finite.
/// The result itself is rounded to nearest.
template <std::floating_point Float>
double ulp_error(Float got, const cln::cl_RA& exact_value);

/// "p/q" in lowest terms with q > 1, or "p".
std::string to_text(const cln::cl_RA& x);
/// All digits.
std::string to_text(const cln::cl_I& n);

/// Reads "p/q" or "p": decimal digits, at most one leading '-'. Throws InvalidInput otherwise, and for q = 0.
cln::cl_RA parse_rational(std::string_view text);

}  // namespace magicmass::reference
