// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "magicmass/counts.hpp"
#include "magicmass/quantities.hpp"
#include "magicmass/terminal.hpp"

/// Tier `fast`: each number within 4 times what rounding alpha alone would cost, max(1/2, cond/2) ulp with cond =
/// |alpha y'/y|, for every positive finite double alpha (V = L = 1, e = 1). Throws InvalidInput outside the domains
/// given, but for two that it would cost a count to see: n past N_A below alpha = 1, and counts with restitution that
/// are not those of alpha and e; there the numbers mean nothing. From theorems tangent.*, offset.* and ratios.*
/// (generated/magicmass/kernels) and rotation.psi_paper.
namespace magicmass::fast {

/// All velocities just after the n-th collisions (Ee & Lee eqs. eq:a-final to eq:c'-final), in units of V; 0 <= n <= N_A.
generated::Velocities<double> velocities(double alpha, std::int64_t n);

/// Time, in units of L/V, and distance from A to B, in units of L, at collision j = 0 (P_1), 1 (Q_1), ...; j below the
/// number of collisions.
generated::Encounters<double> encounters(double alpha, std::int64_t j);

/// The angle psi of one cycle (Ee & Lee def:psi), in rad.
double angle(double alpha);

/// Magic and deficient mass ratio alpha_k and beta_k (Ee & Lee, Table II: exact:ak, exact:bk), k >= 1, within 1 ulp.
generated::Ratios<double> ratios(std::int64_t k);

/// After the last collision (Ee & Lee eqs. eq:a-terminal, eq:b-terminal, eq:ct); none where the counts do not fit 64 bits.
std::optional<Terminal> terminal(double alpha);

/// The same with restitution 0 < e <= 1, `counts` being all collisions: N_B <= N_A <= N_B + 1, alpha above alpha_c(e) =
/// (1 - sqrt(e))^2/(2 sqrt(e)): nothing of that is looked at. 1.01 max(1/2, cond/2) ulp were seen, with the condition
/// numbers in alpha and e added up. From theorems inelastic_end.*, in long double, rounded once: not finite where that
/// cannot tell alpha from alpha_c(e).
Terminal terminal(long double alpha, long double e, const Counts& counts);

/// The time, in units of L/V, in which infinitely many collisions happen: 0 < e < 1, alpha <= alpha_c(e), which is
/// not looked at. The error is as above.
double collapse_time(long double alpha, long double e);

}  // namespace magicmass::fast
