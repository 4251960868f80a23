// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "derivation/laws.hpp"
#include "derivation/paper.hpp"
#include "proof/kernel.hpp"

// The chapters in their order: each takes the kernel and what it needs of the earlier ones, proves its
// steps in the kernel and returns the theorems that later chapters use.
namespace magicmass::derivation {

using proof::Kernel;
using proof::Theorem;

void orthogonal(Kernel& kernel, const Paper& paper);
void frame(Kernel& kernel, const Paper& paper);

struct Contact {
  Theorem momentum_P, energy_P, momentum_Q, energy_Q;  // the laws at P_n and Q_n
  Theorem a, c, b, c_prime;                            // each after its collision, from before
  Theorem Gamma, theta;
  Theorem momentum, energy;  // of any two bodies
  Theorem v_1, v_2;          // their velocities after, from before
};
Contact contact(Kernel& kernel, const Laws& laws, const Paper& paper);

struct Cycle {
  Theorem Gamma_A, Gamma_B, Lambda;
  Theorem a, b, c_prime;  // from V_(n-1) = (a, b, sqrt(alpha) c')_(n-1)
};
Cycle cycle(Kernel& kernel, const Contact& contact, const Paper& paper);

struct Rotation {
  Theorem R, psi, psi_half_angle, Lambda;  // Lambda = R lambda_3(psi) R^T
  Theorem cos_half_psi;                    // cos(psi/2) = 1/(1 + alpha)
};
Rotation rotation(Kernel& kernel, const Cycle& cycle, const Paper& paper);

// Columns on (a, b, sqrt(alpha) c), for equal blocks: along the wall where C and B touch and across it, in the
// plane that the motion is seen in.
struct Mapping {
  Theorem along_B, across_B;
};
Mapping mapping(Kernel& kernel, const Contact& contact, const Cycle& cycle,
                const Rotation& rotation, const Paper& paper);

struct Table {
  Theorem cos_theta, sin_theta, cos_psi, sin_psi;
};
Table table(Kernel& kernel, const Contact& contact, const Rotation& rotation, const Paper& paper);
void multiples(Kernel& kernel, const Contact& contact, const Rotation& rotation, const Table& table,
               const Paper& paper);

struct Power {
  Theorem a_initial, b_initial, c_initial;
  Theorem V_CM;
  Theorem a, b, c_prime;  // n >= 0, the paper's forms
  Theorem c;              // n >= 1
  Theorem a_product, b_product, c_product, c_prime_product;
};
Power power(Kernel& kernel, const Laws& laws, const Contact& contact, const Cycle& cycle,
            const Rotation& rotation, const Paper& paper);

struct Chebyshev {
  Theorem T;          // T(m) = cos(m psi/2)
  Theorem even, odd;  // T(2 m), T(2 m + 1) from T(m), T(m + 1)
  Theorem a, b, c, c_prime;
};
Chebyshev chebyshev(Kernel& kernel, const Rotation& rotation, const Power& power);

struct Counting {
  Theorem before_P, before_Q;  // approach speeds
  Theorem N, N_A, N_B;
  Theorem equal;                                  // N_A = N_B: the last collision is a Q
  Theorem one_more_above_half, one_more_at_zero;  // N_A = N_B + 1: it is a P
  Theorem psi_increases;
};
Counting counting(Kernel& kernel, const Rotation& rotation, const Power& power, const Paper& paper);

// A mass ratio at which a count is about to change.
struct RatioCase {
  Theorem angle;     // psi = pi/(k + s), the case under study
  Theorem ratio;     // alpha in that case
  Theorem N_A, N_B;  // the counts there
};
struct Ratios {
  Theorem alpha_k, beta_k;                // the paper's forms
  Theorem alpha_k_stable, beta_k_stable;  // without cancellation
  RatioCase magic, deficient;
  Theorem magic_b;  // b_k = V at alpha_k
};
Ratios ratios(Kernel& kernel, const Rotation& rotation, const Power& power,
              const Counting& counting, const Paper& paper);

struct Terminal {
  Theorem psi_below_pi;
  Theorem reached, not_before;      // pi <= (N_B + 1) psi, pi > N_B psi
  Theorem A_reached, A_not_before;  // pi <= (N_A + 1/2) psi, pi > (N_A - 1/2) psi
  Theorem b_below_V;
  Theorem b_at_beta_k;
};
Terminal terminal(Kernel& kernel, const Power& power, const Counting& counting,
                  const Ratios& ratios, const Paper& paper);

// Every beta_k is a strict local minimum of b_t.
void minima(Kernel& kernel, const Rotation& rotation, const Power& power, const Counting& counting,
            const Terminal& terminal);

// psi, theta and the counts for light balls.
void small_alpha(Kernel& kernel, const Rotation& rotation, const Counting& counting,
                 const Paper& paper);

struct Times {
  Theorem t_P, t_Q, s_P, s_Q;
  Theorem t, s;                                // of collision j = 0, 1, 2, ...
  Theorem t_rational, s_rational;              // in T(1), T(j), T(j + 1)
  Theorem t_1, s_1, to_B, gap_Q, to_A, gap_P;  // the laws of uniform motion
  Theorem towards_B, towards_A;                // approach speeds before Q_n and P_n
};
Times times(Kernel& kernel, const Laws& laws, const Power& power, const Counting& counting,
            const Chebyshev& chebyshev);

// From one sine and one cosine.
struct Tangent {
  Theorem tan_quarter, cot_half;  // tan(psi/4), cot(psi/2)
  Theorem a, b, c, c_prime;
  Theorem t, s;
};
Tangent tangent(Kernel& kernel, const Rotation& rotation, const Power& power, const Times& times);

// Terminal velocities.
void offset(Kernel& kernel, const Power& power, const Counting& counting, const Terminal& terminal);

// Velocities of the first cycles.
void fixed_n(Kernel& kernel, const Power& power, const Counting& counting, const Terminal& terminal,
             const Tangent& tangent);

struct Unfolding {
  Theorem t_Q, s_Q;  // from the straight line
};
Unfolding unfolding(Kernel& kernel, const Cycle& cycle, const Power& power, const Mapping& mapping,
                    const Times& times);

void chain(Kernel& kernel, const Contact& contact, const Ratios& ratios,
           const Unfolding& unfolding);

struct Restitution {
  Theorem momentum, restitution;  // the laws of one contact
  Theorem v_1, v_2;               // solved for the velocities after
};
Restitution restitution(Kernel& kernel, const Laws& laws, const Cycle& cycle);

// psi = 2 atan(s/(1 + c)): the angle in (0, pi) with cosine c and sine s > 0. Proves c^2 + s^2 = 1 and
// s > 0 as steps `id`.circle and `id`.side, then defines `name`.
Theorem read_off_angle(Kernel& kernel, const std::string& id, const GiNaC::ex& name,
                       const GiNaC::ex& cosine, const GiNaC::ex& sine, const std::string& words);

}  // namespace magicmass::derivation
