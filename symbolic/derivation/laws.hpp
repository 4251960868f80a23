// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "proof/statement.hpp"

namespace magicmass::derivation {

/// All the physics that goes in: one contact of two bodies (masses M_1, M_2, velocities u before and v
/// after), and how everything starts. Nothing else is assumed anywhere.
struct Laws {
  proof::Statement momentum;     ///< M_1 u_1 + M_2 u_2 = M_1 v_1 + M_2 v_2
  proof::Statement energy;       ///< the same with squares: twice the kinetic energy
  proof::Statement contact;      ///< v_1 != u_1: a collision changes velocities
  proof::Statement restitution;  ///< v_2 - v_1 = e (u_1 - u_2) where energy is lost, 0 < e <= 1
  proof::Statement wall;         ///< v_1 = u_1: a wall does not move
  proof::Statement a_initial;    ///< a_0 = V
  proof::Statement b_initial;    ///< b_0 = 0
  proof::Statement c_initial;    ///< c'_0 = 0
  proof::Statement t_initial;    ///< the first collision is at time 0 ...
  proof::Statement s_initial;    ///< ... with A and B a distance L apart
  // Between collisions all move uniformly: relative velocity times time is distance.
  proof::Statement t_Q;  ///< for the ball from A to B, n >= 1
  proof::Statement s_Q;  ///< for the distance of A and B meanwhile
  proof::Statement t_P;  ///< for the ball from B to A, n >= 2
  proof::Statement s_P;  ///< for the distance of A and B meanwhile
};

/// The real ones.
Laws conservation_laws();

}  // namespace magicmass::derivation
