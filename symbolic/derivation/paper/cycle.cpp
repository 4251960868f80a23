// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "derivation/matrices.hpp"
#include "derivation/paper/equations.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;

Equations cycle_equations() {
  const ex n = symbol("n"), alpha = symbol("alpha"), theta = symbol("theta");
  const ex root = sqrt(alpha), s = sin(theta), c_ = cos(theta);
  const ex P_3 = reflection_3();
  return {
      {"app:Vn, Gamma_A", {symbol("Gamma_A"), (rotation_2(-theta) * P_3).evalm()}},
      {"app:Vn, Gamma_B", {symbol("Gamma_B"), (rotation_1(theta) * P_3).evalm()}},
      {"eq:Lambda",
       {symbol("Lambda"), matrix{{(1 - alpha) / (1 + alpha), 0, 2 * root / (1 + alpha)},
                                 {4 * alpha / pow(1 + alpha, 2), (1 - alpha) / (1 + alpha),
                                  -2 * (1 - alpha) * root / pow(1 + alpha, 2)},
                                 {-2 * (1 - alpha) * root / pow(1 + alpha, 2),
                                  2 * root / (1 + alpha), pow(1 - alpha, 2) / pow(1 + alpha, 2)}}}},
      {"eq:Lambda-app",
       {symbol("Lambda"), matrix{{c_, 0, s}, {pow(s, 2), c_, -s * c_}, {-s * c_, s, pow(c_, 2)}}}},
      {"eq:V2",
       {pow(a(n), 2) + pow(b(n), 2) + alpha * pow(c_prime(n), 2),
        pow(a(n - 1), 2) + pow(b(n - 1), 2) + alpha * pow(c_prime(n - 1), 2)}},
  };
}

}  // namespace magicmass::derivation
