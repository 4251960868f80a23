// SPDX-License-Identifier: MIT
// Tier accurate: correctly rounded.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "magicmass/numbers/errors.hpp"
#include "magicmass/numbers/values.hpp"

/// Each result is the double nearest to the exact value, zeros and thresholds included; counts are
/// exact. Throws Undecided if thousands of bits do not settle a rounding: never seen.
/// All functions are thread-safe; an alpha that is not positive and finite is InvalidInput. Where
/// a thread does not round to nearest or loses subnormal numbers, array calls throw NotIeee; single
/// calls rely on both, and throw NotIeee in debug builds of the library alone.
namespace magicmass::accurate {
/// a_n, b_n, c_n, c'_n, unit V, for any double alpha > 0 and n from 0 to N_A (n = 0: 1, 0, 0, 0),
/// else throws InvalidInput. At n = N_A > N_B, b_n and c'_n belong to no collision of the motion.
Velocities velocities(double alpha, std::int64_t n);
/// Counts, a_t, b_t, c_t, unit V, and rho. nullopt: N_A + N_B >= 2^63, alpha below about 5.8e-38.
std::optional<Terminal> terminal(double alpha);
/// t_j and s_j, units L/V and L, for any double alpha > 0 and j from 0 to N_A + N_B - 1 (j = 0: 0
/// and 1), else throws InvalidInput.
Collision collision(double alpha, std::int64_t j);
/// The end of infinitely many collisions with restitution e, 0 < e <= 1; nullopt if they end, which
/// is decided exactly. A time above the largest double is infinite. InvalidInput unless m and w,
/// `ball` and `per_B` of the masses, are finite, m positive and w not negative. Throws Undecided if
/// 1 - 4 e m (1 + w + w m)/(1 - e)^2, 0 where collapse begins, is above 0 and below 2^-80.
std::optional<Collapse> collapse(const Masses& masses, double e);
/// The same of equal blocks, m = alpha and w = 1.
std::optional<Collapse> collapse(double alpha, double e);
/// psi, the angle of one cycle, in radians, below pi.
double angle(double alpha);
/// alpha_k and beta_k, unit 1, k >= 1, else throws InvalidInput.
Ratios ratios(std::int64_t k);
/// Arrays, the same bits as single calls. InvalidInput only if sizes differ or columns overlap.
void velocities(std::span<const double> alpha, std::span<const std::int64_t> n,
                const VelocityColumns& columns);
void terminal(std::span<const double> alpha, const TerminalColumns& columns);
}  // namespace magicmass::accurate
