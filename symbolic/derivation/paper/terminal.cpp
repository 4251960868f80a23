// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "derivation/paper/equations.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::numeric;

Equations terminal_equations() {
  const ex psi = symbol("psi"), alpha = symbol("alpha"), V = symbol("V");
  const ex N_A = symbol("N_A"), N_B = symbol("N_B"), half = numeric(1, 2);
  const ex beta_k = symbol("beta_k");
  const ex c_t = (V - a(N_A) - b(N_B)) / alpha;
  return {
      {"eq:NA-constraint", {a(N_A), Relation::less_equal, c_prime(N_A)}},
      {"eq:NA-constraint-simple, before", {sin((N_A - half) * psi), Relation::greater, 0}},
      {"eq:NA-constraint-simple, after", {sin((N_A + half) * psi), Relation::less_equal, 0}},
      {"eq:NB-constraint", {c(N_B + 1), Relation::less_equal, b(N_B)}},
      {"eq:NB-constraint-simple, before", {sin(N_B * psi), Relation::greater, 0}},
      {"eq:NB-constraint-simple, after", {sin((N_B + 1) * psi), Relation::less_equal, 0}},
      {"eq:ct, after Q", {c_prime(N_B), c_t}},
      {"eq:ct, after P", {c(N_A), c_t}},
      {"sec:result, a_t < 0", {0, Relation::greater, a(N_A)}},
      {"sec:result, b_t <= V", {b(N_B), Relation::less_equal, V}},
      {"sec:result, a_t at alpha_k", {a(N_A), 0}},
      {"sec:result, c_t at alpha_k", {c_prime(N_B), 0}},
      {"sec:result, b_t at alpha_k", {b(N_B), V}},
      {"sec:result, a_t at beta_k", {a(N_A), -beta_k * V / (2 + beta_k)}},
      {"sec:result, b_t at beta_k", {b(N_B), 2 * V / (2 + beta_k)}},
      {"sec:result, c_t at beta_k", {c(N_A), 2 * V / (2 + beta_k)}},
  };
}

}  // namespace magicmass::derivation
