// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include <ginac/ginac.h>

#include "derivation/chapters.hpp"

// The parts of the wedge theorem, which take more than one file.
namespace magicmass::derivation {

// 4 e > (1 + e)^2 mu_A mu_B, or cos h < 1: what decides that there is a last collision.
proof::Statement collisions_end();

// The parameters of a family: its laws hold for any values of them.
std::set<std::string> any_wedge();

struct WedgeEvents {
  Theorem wall;
  Theorem momentum_P, momentum_Q, restitution_P, restitution_Q;
  Theorem a_0, b_0, c_0;
  Theorem after_A, after_C, after_B, after_C_prime;  // velocities after a collision from before
};
WedgeEvents wedge_events(Kernel& kernel, const Laws& laws, const Restitution& contact);

struct WedgeSpeeds {
  Theorem r_P, r_Q;                 // approach speeds, by definition
  Theorem first_P, first_Q;         // r_P(1), r_Q(1)
  Theorem next_P, next_Q, cycle_Q;  // cycle_Q in terms of the cycle before alone
};
WedgeSpeeds wedge_speeds(Kernel& kernel, const WedgeEvents& events);

struct WedgeMotion {           // between collisions, in approach speeds
  Theorem x_P, x_Q, D_P, D_Q;  // by definition
  Theorem first_x_P, first_x_Q, x_P_next, x_Q_cycle;
  Theorem first_D, D_cycle, D_half;
};
WedgeMotion wedge_motion(Kernel& kernel, const Laws& laws, const WedgeEvents& events,
                         const WedgeSpeeds& speeds);

// A regime of the wedge: sigma(j) solves sigma(j + 1) = 2 C sigma(j) - sigma(j - 1), sigma(0) = 0,
// sigma(1) = 1. It is sin(j h)/sin(h), j, or sinh(j eta)/sinh(eta), as C is below, at or above 1.
struct Regime {
  std::string id;  // prefix of the steps' ids
  GiNaC::exmap parameters;
  GiNaC::ex g;
  std::function<GiNaC::ex(const GiNaC::ex&)> sigma;
  std::vector<proof::Statement> assuming;
};
struct WedgeSolution {
  Theorem r_P, r_Q;
  Theorem tau_P, tau_Q;
  Theorem d_P, d_Q;
};
WedgeSolution wedge_solution(Kernel& kernel, const Regime& regime, const WedgeSpeeds& speeds,
                             const WedgeMotion& motion);

struct WedgeTheorem {
  Theorem r_P_definition, r_Q_definition;
  Theorem g, h;
  Theorem r_P, r_Q;
  Theorem next_P_defined;  // r_P(n + 1) = v_A(n) - v_C'(n)
  Theorem before_P, before_Q;
  Theorem N_C;
};
struct WedgeVelocities {
  Theorem v_A, v_B, v_C, v_C_prime;
  // From the approach speeds alone, whether collisions end or not, n >= 1; v_C from v_A.
  Theorem v_A_from_speeds, v_B_from_speeds, v_C_prime_from_speeds, v_C_from_A;
};
WedgeVelocities wedge_velocities(Kernel& kernel, const WedgeEvents& events,
                                 const WedgeTheorem& theorem);

// Any masses and any restitution, where the collisions end.
struct Wedge {
  WedgeEvents events;
  WedgeSpeeds speeds;
  WedgeMotion motion;
  WedgeTheorem theorem;
  WedgeSolution solution;
  WedgeVelocities velocities;
  Theorem tau;
};
Wedge wedge(Kernel& kernel, const Laws& laws, const Restitution& contact);

// Equal blocks, elastic contacts, the wall: the wedge theorem holds them all.
struct EqualBlocks {  // with restitution e, where the collisions end
  Theorem h, a, b, c, c_prime, N_C, tau_P, tau_Q, d_P, d_Q;
};
EqualBlocks special_cases(Kernel& kernel, const Wedge& wedge, const Restitution& contact,
                          const Power& power, const Counting& counting, const Times& times,
                          const Paper& paper);

// Where the collisions never end.
struct Collapse {
  Theorem alpha_c;     // equal blocks: the heaviest ball with a collapse
  Theorem t_infinity;  // in mu_A and xi, with
  GiNaC::ex share_of_B;
};
Collapse collapse(Kernel& kernel, const Wedge& wedge);

// Equal blocks and restitution: what is left after the last collision, or when collisions have collapsed.
void inelastic_end(Kernel& kernel, const EqualBlocks& equal, const Collapse& collapse);

// What reaches B of the energy.
void transmission(Kernel& kernel, const EqualBlocks& equal, const Collapse& collapse);

}  // namespace magicmass::derivation
