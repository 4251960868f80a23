// SPDX-License-Identifier: GPL-2.0-or-later
// Minimal polynomials of magic and deficient mass ratios.
#pragma once

#include <string>
#include <vector>

#include <cln/integer.h>

namespace answers {

/// Whole coefficients, of x^0 first.
using Polynomial = std::vector<cln::cl_I>;

/// The polynomial of least degree that alpha_k (`is_magic`) or beta_k is a root of, 1 <= k: without
/// a common factor, its first coefficient positive.
Polynomial polynomial_of_ratio(int k, bool is_magic);
/// "x^2 + 4*x - 1".
std::string text_of(const Polynomial& p);

}  // namespace answers
