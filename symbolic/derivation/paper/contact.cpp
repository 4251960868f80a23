// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "derivation/matrices.hpp"
#include "derivation/paper/equations.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;

Equations contact_equations() {
  const ex n = symbol("n"), alpha = symbol("alpha"), theta = symbol("theta"),
           Gamma = symbol("Gamma");
  const ex root = sqrt(alpha);
  return {
      {"eq:ac", {a(n - 1) + alpha * c_prime(n - 1), a(n) + alpha * c(n)}},
      {"eq:Euc-Pn",
       {pow(a(n - 1), 2) + pow(root * c_prime(n - 1), 2), pow(a(n), 2) + pow(root * c(n), 2)}},
      {"eq:bcp", {b(n - 1) + alpha * c(n), b(n) + alpha * c_prime(n)}},
      {"eq:Euc-Qn",
       {pow(b(n - 1), 2) + pow(root * c(n), 2), pow(b(n), 2) + pow(root * c_prime(n), 2)}},
      {"eq:energy-conservation-PnQn",
       {pow(a(n - 1), 2) + pow(b(n - 1), 2) + pow(root * c_prime(n - 1), 2),
        pow(a(n), 2) + pow(b(n), 2) + pow(root * c_prime(n), 2)}},
      {"eq:Euc-Pn-linear", {a(n - 1) - c_prime(n - 1), -a(n) + c(n)}},
      {"eq:Euc-Qn-linear", {b(n - 1) - c(n), -b(n) + c_prime(n)}},
      {"eq:Gamma",
       {Gamma, (matrix{{1 - alpha, 2 * root}, {2 * root, -(1 - alpha)}} / (1 + alpha)).evalm()}},
      {"def:gamma", {Gamma, (plane_rotation(theta) * matrix{{1, 0}, {0, -1}}).evalm()}},
      {"def:theta", {theta, 2 * atan(root)}},
  };
}

}  // namespace magicmass::derivation
