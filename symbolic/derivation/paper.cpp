// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/paper.hpp"

#include <ginac/ginac.h>

#include "derivation/matrices.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {
namespace {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;
using GiNaC::numeric;
using GiNaC::Pi;
using Equations = std::map<std::string, Statement>;

const ex half = numeric(1, 2);
const ex quarter = numeric(1, 4);

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

Equations velocity_equations() {
  const ex n = symbol("n"), alpha = symbol("alpha"), psi = symbol("psi"), V = symbol("V");
  const ex V_CM = symbol("V_CM");
  return {
      {"sec:result, V_CM", {V_CM, V * cos(psi / 2) / (1 + cos(psi / 2))}},
      {"eq:a-final", {a(n), V_CM * (1 + cos(n * psi) / cos(psi / 2))}},
      {"eq:b-final", {b(n), V_CM * (1 - cos((n + half) * psi) / cos(psi / 2))}},
      {"eq:c-final", {c(n), V_CM * (1 + sin((n - quarter) * psi) / sin(psi / 4))}},
      {"eq:c'-final", {c_prime(n), V_CM * (1 - sin((n + quarter) * psi) / sin(psi / 4))}},
  };
}

Equations counting_equations() {
  const ex k = symbol("k"), psi = symbol("psi");
  return {
      {"eq:NA-ans", {symbol("N_A"), ceiling(Pi / psi - half)}},
      {"eq:NB-ans", {symbol("N_B"), ceiling(Pi / psi - 1)}},
      {"eq:NANB-ans, equal", {symbol("N_A"), ceiling(Pi / psi) - 1}},
      {"eq:NANB-ans, otherwise", {symbol("N_A"), ceiling(Pi / psi)}},
      {"eq:Naatcritical", {k, Pi / psi - half}},
      {"eq:Nbatcritical", {k, Pi / psi - 1}},
  };
}

Equations ratio_equations() {
  const ex k = symbol("k"), alpha = symbol("alpha"), psi = symbol("psi"), V = symbol("V");
  const ex N_A = symbol("N_A"), N_B = symbol("N_B");
  return {
      {"exact:ak", {symbol("alpha_k"), -1 + 1 / cos(Pi / (2 * k + 1))}},
      {"exact:bk", {symbol("beta_k"), -1 + 1 / cos(Pi / (2 * (k + 1)))}},
      {"eq:a-terminal", {a(N_A), V / (2 + alpha) * (1 + (1 + alpha) * cos(N_A * psi))}},
      {"eq:b-terminal", {b(N_B), V / (2 + alpha) * (1 - (1 + alpha) * cos((N_B + half) * psi))}},
      {"eq:magic-b-cond", {cos((N_B + half) * psi), -1}},
      {"eq:magic-b-cond-simple", {N_B, Pi / psi - half}},
      {"app:deficient, a_t", {symbol("a_t"), -alpha * V / (2 + alpha)}},
      {"eq:defb-terminal", {symbol("b_t"), 2 * V / (2 + alpha)}},
      {"eq:def-b-cond", {cos((N_B + half) * psi), -1 / (1 + alpha)}},
      {"app:deficient, N_B", {N_B, Pi / psi - 1}},
  };
}

}  // namespace

Paper paper() {
  Equations all;
  for (Equations part : {contact_equations(), cycle_equations(), rotation_equations(),
                         velocity_equations(), counting_equations(), ratio_equations()})
    all.merge(part);
  return Paper(std::move(all));
}

}  // namespace magicmass::derivation
