// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "derivation/chapters.hpp"

// The parts of the wedge theorem, which take more than one file.
namespace magicmass::derivation {

// 4 e > (1 + e)^2 mu_A mu_B, or cos h < 1: what decides that there is a last collision.
proof::Statement collisions_end();

struct WedgeEvents {
  Theorem wall;
  Theorem momentum_P, momentum_Q, restitution_P, restitution_Q;
  Theorem a_0, b_0, c_0;
  Theorem after_A, after_C, after_B, after_C_prime;  // velocities after a collision from before
};
WedgeEvents wedge_events(Kernel& kernel, const Laws& laws, const Restitution& contact);

struct WedgeSpeeds {
  Theorem r_P, r_Q;                // approach speeds, by definition
  Theorem first_P, first_Q;        // r_P(1), r_Q(1)
  Theorem next_P, next_Q, cycle_Q;  // cycle_Q in terms of the cycle before alone
};
WedgeSpeeds wedge_speeds(Kernel& kernel, const WedgeEvents& events);

// Any masses and any restitution, where the collisions end.
struct Wedge {
  WedgeEvents events;
  WedgeSpeeds speeds;
  Theorem g, h;
  Theorem r_P, r_Q;
  Theorem N_C;
};
Wedge wedge(Kernel& kernel, const Laws& laws, const Restitution& contact);

}  // namespace magicmass::derivation
