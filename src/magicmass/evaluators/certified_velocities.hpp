// SPDX-License-Identifier: MIT
// The last stage of tier `accurate`: certified arithmetic that any input ends in, whatever came before.
#pragma once

#include <cstdint>

#include "magicmass/quantities.hpp"

namespace magicmass {

/// Which velocity: a_n of A, b_n of B, c_n of C just after P_n, c'_n of C just after Q_n.
enum class Velocity { a, b, c, c_prime };

/// a_n, b_n, c_n or c'_n in units of V: the double nearest to the exact value of the formula, ties to even, for every
/// double alpha > 0 and every n >= 0, physical (n up to the last collision) or not. For n = 0 the initial 1, 0, 0, 0.
/// Throws InvalidInput unless alpha is positive and finite and n >= 0; Undecided if 1536 bits did not settle a
/// rounding (never seen: see velocity_attempts.hpp).
double certified_velocity(Velocity member, double alpha, std::int64_t n);

/// All four, which share most of the work.
generated::Velocities<double> certified_velocities(double alpha, std::int64_t n);

/// The transmitted energy fraction rho = b_t^2, b_t being b_n at B's last collision, n = N_B. The same promise.
double certified_energy_fraction(double alpha);

}  // namespace magicmass
