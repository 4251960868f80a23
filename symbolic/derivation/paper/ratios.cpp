// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "derivation/paper/equations.hpp"
#include "derivation/shorthand.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;

Equations ratios_equations() {
  const ex k = symbol("k"), alpha = symbol("alpha"), psi = symbol("psi"), V = symbol("V");
  const ex N_A = symbol("N_A"), N_B = symbol("N_B");
  return {
      {"exact:ak", {symbol("alpha_k"), -1 + 1 / cos(Pi / (2 * k + 1))}},
      {"exact:bk", {symbol("beta_k"), -1 + 1 / cos(Pi / (2 * (k + 1)))}},
      {"eq:a-terminal", {a(N_A), V / (2 + alpha) * (1 + (1 + alpha) * cos(N_A * psi))}},
      {"eq:b-terminal",
       {b(N_B), V / (2 + alpha) * (1 - (1 + alpha) * cos((N_B + one_half) * psi))}},
      {"eq:magic-b-cond", {cos((N_B + one_half) * psi), -1}},
      {"eq:magic-b-cond-simple", {N_B, Pi / psi - one_half}},
      {"app:deficient, a_t", {symbol("a_t"), -alpha * V / (2 + alpha)}},
      {"eq:defb-terminal", {symbol("b_t"), 2 * V / (2 + alpha)}},
      {"eq:def-b-cond", {cos((N_B + one_half) * psi), -1 / (1 + alpha)}},
      {"app:deficient, N_B", {N_B, Pi / psi - 1}},
  };
}

}  // namespace magicmass::derivation
