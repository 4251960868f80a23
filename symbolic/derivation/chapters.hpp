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

struct Contact {
  Theorem momentum_P, energy_P, momentum_Q, energy_Q;  // the laws at P_n and Q_n
  Theorem a, c, b, c_prime;                            // each after its collision, from before
  Theorem Gamma, theta;
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
  Theorem psi_increases;
};
Counting counting(Kernel& kernel, const Rotation& rotation, const Power& power, const Paper& paper);

struct Ratios {
  Theorem alpha_k, beta_k;                // the paper's forms
  Theorem alpha_k_stable, beta_k_stable;  // without cancellation
};
Ratios ratios(Kernel& kernel, const Rotation& rotation, const Power& power,
              const Counting& counting, const Paper& paper);

struct Times {
  Theorem t_P, t_Q, s_P, s_Q;
  Theorem t, s;                    // of collision j = 0, 1, 2, ...
  Theorem t_rational, s_rational;  // in T(1), T(j), T(j + 1)
};
Times times(Kernel& kernel, const Laws& laws, const Power& power, const Counting& counting,
            const Chebyshev& chebyshev);

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
