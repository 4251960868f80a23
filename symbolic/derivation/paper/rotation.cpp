// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "derivation/matrices.hpp"
#include "derivation/paper/equations.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;

Equations rotation_equations() {
  const ex alpha = symbol("alpha"), psi = symbol("psi"), n = symbol("n");
  const ex far = sqrt(2 + alpha), mixed = sqrt(alpha / (2 * (2 + alpha)));
  const matrix R{{-1 / sqrt(ex(2)), -mixed, 1 / far},
                 {1 / sqrt(ex(2)), -mixed, 1 / far},
                 {0, sqrt(2 / (2 + alpha)), sqrt(alpha) / far}};
  return {
      {"app:lam-n, axis", {symbol("e_3"), matrix{{1 / far}, {1 / far}, {sqrt(alpha) / far}}}},
      {"eq:R-app", {symbol("R"), R}},
      {"def:psi", {psi, 2 * atan(sqrt(alpha * (2 + alpha)))}},
      {"eq:Lambda-n-final",
       {pow(symbol("Lambda"), n), (ex(R) * rotation_3(n * psi) * R.transpose()).evalm()}},
  };
}

}  // namespace magicmass::derivation
