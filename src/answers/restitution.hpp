// SPDX-License-Identifier: GPL-2.0-or-later
// Terminal velocities of collisions that lose energy.
#pragma once

#include <optional>

#include "answers/ball.hpp"
#include "answers/motion.hpp"

namespace answers {

/// Blocks of one mass, a ball of alpha times that, restitution 0 < e < 1, V = L = 1.
struct Inelastic {
  notation::Alpha alpha;
  cln::cl_RA e;
};
/// The number of all collisions, or nothing where they never end. Throws Undecided where more bits
/// would be needed than are allowed.
std::optional<cln::cl_I> count_collisions(const Inelastic& motion);
/// After N collisions: the velocities of A, B, C, and rho; with the bits that are set now.
Balls terminal(const Inelastic& motion, const cln::cl_I& N);
/// The time at which collisions that never end come to an end.
Ball collapse_time(const Inelastic& motion);

}  // namespace answers
