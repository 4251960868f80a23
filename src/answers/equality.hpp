// SPDX-License-Identifier: GPL-2.0-or-later
// equal: are two typed expressions equal?
#pragma once

#include "answers/request.hpp"
#include "equality/decide.hpp"

namespace answers {

/// Two words, and the option domain. The check fails where they differ; undecided has exit code 3.
/// Throws InvalidInput for what cannot be read.
Answer equal(const Request& request);

/// What the paper's names stand for, from the book: psi, theta, V_CM, alpha_k, beta_k, a_n, b_n,
/// c_n, c'_n. A line for each in `notes`: "psi = 2*atan(sqrt(alpha*(2 + alpha)))".
kernel::Expr with_meanings(kernel::Expr typed, std::vector<std::string>& notes);

/// The right side of an equation that a step states, in the symbols that people type; of several
/// the one with this left side: "power.a", "deficient.terminal: b_(N_B)". Refused where there is
/// none.
kernel::Expr stated_value(const std::string& step);

}  // namespace answers
