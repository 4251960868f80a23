// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "derivation/paper/equations.hpp"
#include "derivation/shorthand.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::numeric;

namespace {
const ex quarter = numeric(1, 4);
}  // namespace

Equations power_equations() {
  const ex n = symbol("n"), alpha = symbol("alpha"), psi = symbol("psi"), V = symbol("V");
  const ex V_CM = symbol("V_CM");
  return {
      {"sec:result, V_CM", {V_CM, V * cos(psi / 2) / (1 + cos(psi / 2))}},
      {"eq:a-final", {a(n), V_CM * (1 + cos(n * psi) / cos(psi / 2))}},
      {"eq:b-final", {b(n), V_CM * (1 - cos((n + one_half) * psi) / cos(psi / 2))}},
      {"eq:c-final", {c(n), V_CM * (1 + sin((n - quarter) * psi) / sin(psi / 4))}},
      {"eq:c'-final", {c_prime(n), V_CM * (1 - sin((n + quarter) * psi) / sin(psi / 4))}},
  };
}

}  // namespace magicmass::derivation
