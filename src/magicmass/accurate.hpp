// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "magicmass/counts.hpp"
#include "magicmass/quantities.hpp"
#include "magicmass/terminal.hpp"

/// Tier `accurate`: the double nearest to the exact value, ties to even, for every positive finite double alpha (V = L
/// = 1, e = 1), on every machine the same. Throws InvalidInput outside the domains given. Ziv's strategy in three
/// stages: numbers within 2^-67 of what they stand for with a rounding test, within about 2^-84 with one, and certified
/// multiword arithmetic, which enough words always end (argued in evaluators/velocity_attempts.hpp,
/// encounter_attempts.hpp and certified_angles.cpp); Undecided is thrown where 1536 bits are not enough, which was
/// never seen. From theorems tangent.* and ratios.*.
namespace magicmass::accurate {

/// All velocities just after the n-th collisions (Ee & Lee eqs. eq:a-final to eq:c'-final), in units of V; 0 <= n, also
/// past N_A, where the formula goes on.
generated::Velocities<double> velocities(double alpha, std::int64_t n);

/// Time, in units of L/V, and distance from A to B, in units of L, at collision j = 0 (P_1), 1 (Q_1), ...; j below the
/// number of collisions.
generated::Encounters<double> encounters(double alpha, std::int64_t j);

/// The angle psi of one cycle (Ee & Lee def:psi), in rad.
double angle(double alpha);

/// Magic and deficient mass ratio alpha_k and beta_k (Ee & Lee, Table II: exact:ak, exact:bk), k >= 1.
generated::Ratios<double> ratios(std::int64_t k);

/// After the last collision (Ee & Lee eqs. eq:a-terminal, eq:b-terminal, eq:ct); none where the counts do not fit 64 bits.
std::optional<Terminal> terminal(double alpha);

}  // namespace magicmass::accurate
