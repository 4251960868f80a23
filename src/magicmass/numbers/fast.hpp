// SPDX-License-Identifier: MIT
// Tier fast: within 4 envelopes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "magicmass/numbers/errors.hpp"
#include "magicmass/numbers/values.hpp"

/// Errors are at most 4 envelopes of max(1/2, |alpha y'/(2 y)|) ulp, half of which rounding alpha
/// alone would cost, and without restitution 2^-50 of the largest velocity of that body; counts are
/// exact. A zero may have either sign, as may a value that is smaller than its promised error.
/// All functions are thread-safe; an alpha that is not positive and finite is InvalidInput. Where
/// a thread does not round to nearest or loses subnormal numbers, array calls throw NotIeee; single
/// calls rely on both, and throw NotIeee in debug builds of the library alone.
namespace magicmass::fast {
/// a_n, b_n, c_n, c'_n, unit V, for any double alpha > 0 and n from 0 to N_A (n = 0: 1, 0, 0, 0),
/// else throws InvalidInput. b_n and c'_n at n = N_A > N_B belong to a collision that does not take
/// place.
Velocities velocities(double alpha, std::int64_t n);
/// Counts, a_t, b_t, c_t, unit V, and rho. nullopt: N_A + N_B is 2^63 or more, alpha below about
/// 5.8e-38.
std::optional<Terminal> terminal(double alpha);
/// The same where each collision has restitution e, 0 < e <= 1, else InvalidInput: errors are at
/// most 4 envelopes of max(1/2, (|alpha y_alpha| + |e y_e|)/|2 y|) ulp, counts are exact. nullopt:
/// the collisions never end (inelastic collapse; decided exactly), or as above where e is 1.
/// Throws Undecided where 1 - (1 - e)^2/(4 e alpha (2 + alpha)), which is 0 where collapse begins,
/// is above 0 and below 2^-80, or where more than 2^62 collisions take place with e < 1, or more
/// than two with e below 2^-380.
std::optional<Terminal> terminal(double alpha, double e);
/// The same for any masses, or two and a wall: within 4 envelopes of max(1/2, (|m y_m| + |w y_w| +
/// |e y_e|)/|2 y|) ulp, m and w those of `masses`, and before a wall, where all may come to rest,
/// within 2^-190 at least; a wall's velocity and share are 0. InvalidInput unless m is positive, w
/// not negative and both finite. Undecided also where more than 2^62 take place with e = 1, or more
/// than two with M_A/M_B above 2^128 or M_C/M_A above 2^190.
std::optional<Terminal> terminal(const Masses& masses, double e);
/// t_j and s_j, units L/V and L, for any double alpha > 0 and j from 0 to N_A + N_B - 1 (j = 0: 0
/// and 1), else throws InvalidInput.
Collision collision(double alpha, std::int64_t j);
/// psi, the angle of one cycle, in radians, below pi.
double angle(double alpha);
/// alpha_k and beta_k, unit 1, k >= 1, else throws InvalidInput.
Ratios ratios(std::int64_t k);
/// Arrays, the same bits as single calls. InvalidInput only if sizes differ or columns overlap.
void velocities(std::span<const double> alpha, std::span<const std::int64_t> n,
                const VelocityColumns& columns);
void terminal(std::span<const double> alpha, const TerminalColumns& columns);
}  // namespace magicmass::fast
