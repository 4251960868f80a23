// SPDX-License-Identifier: GPL-2.0-or-later
// Velocities at the accuracy asked for: doubles, exact rationals, or certified digits.
#pragma once

#include "command/accuracy_options.hpp"
#include "command/records.hpp"
#include "magicmass/reference/count.hpp"
#include "magicmass/scenes/mass_ratio.hpp"

namespace magicmass::command {

/// a_n, b_n, c_n and c'_n in units of V.
struct VelocityCells {
  Cell a, b, c, c_prime;
};

/// 0 <= n. At magic:k and n = k three of them are 0, 1 and 0 by the theorems ratios.magic_a, ratios.magic_b and
/// ratios.magic_c_prime. An irrational alpha gets 30 digits where none are asked for. Throws Undecided where n
/// or the answer is too large for the tier.
VelocityCells velocities(const MassRatio& alpha, const cln::cl_I& n, const Accuracy& accuracy);

/// Velocities of the three bodies that no later collision changes, in units of V.
template <class Value>
struct Last {
  Value a, b, c;
};

/// Tier fast at the double nearest to alpha. Throws Undecided where N_A does not fit 64 bits.
Last<double> fast_terminal_velocities(const MassRatio& alpha, const reference::LargeCounts& counts);
/// Throws Undecided where the fractions are too long.
Last<cln::cl_RA> exact_terminal_velocities(const cln::cl_RA& alpha,
                                           const reference::LargeCounts& counts);

/// a_t, b_t, c_t in units of V, and the transmitted fraction of the energy (b_t/V)^2.
struct TerminalCells {
  Cell a_t, b_t, c_t, rho;
};

/// The velocities at the last collisions: a at P_(N_A), b at Q_(N_B), c at the later of both.
TerminalCells terminal_velocities(const MassRatio& alpha, const reference::LargeCounts& counts,
                                  const Accuracy& accuracy);

}  // namespace magicmass::command
