// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/counts.hpp"
#include "magicmass/quantities.hpp"

namespace magicmass {

/// Velocities between equal blocks with restitution 0 < e <= 1 after the last collision, in units of V, and (b_t/V)^2.
/// `counts` are all collisions, N_B <= N_A <= N_B + 1; alpha is above alpha_c(e) = (1 - sqrt(e))^2/(2 sqrt(e)).
/// The generated evaluators in long double, rounded once: at most 4 max(1/2, cond/2) ulp (1.01 seen), where cond is the
/// sum of the relative condition numbers in alpha and e. Not finite where long double cannot tell alpha from alpha_c(e).
generated::TerminalValues<double> inelastic_terminal(long double alpha, long double e,
                                                     const Counts& counts);

/// The time, in units of L/V, in which infinitely many collisions happen, for alpha <= alpha_c(e); error as above.
double collapse_time(long double alpha, long double e);

}  // namespace magicmass
