// SPDX-License-Identifier: GPL-2.0-or-later
// What the paper says in numbers and no command of its own answers.
#pragma once

#include "answers/request.hpp"

namespace answers {

/// psi over pi: option alpha.
Answer angle(const Request& request);

/// Where rho has the extremum that an elastic motion has at magic:k or deficient:k: options
/// near, restitution (a fraction below 1), decimals (of the place, 7 unless told otherwise: a
/// search finds no more). Columns alpha, elastic, and shift in percent.
Answer extremum(const Request& request);

/// Whether two numbers are equal that are written as a scene writes them: exactly, but as doubles
/// where the second has a decimal point.
bool are_equal(const std::string& one, const std::string& other);

}  // namespace answers
