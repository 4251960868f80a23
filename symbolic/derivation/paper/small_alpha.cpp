// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "derivation/paper/equations.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::Pi;

Equations small_alpha_equations() {
  const ex alpha = symbol("alpha"), root = sqrt(2 * alpha);
  return {
      {"app:Vn, small alpha", {symbol("theta"), Relation::asymptotic, 2 * sqrt(alpha)}},
      {"app:lam-n, small alpha", {symbol("psi"), Relation::asymptotic, 2 * root}},
      {"eq:NA-approx, N_A", {symbol("N_A"), Relation::asymptotic, Pi / (2 * root)}},
      {"eq:NA-approx, N_B", {symbol("N_B"), Relation::asymptotic, Pi / (2 * root)}},
  };
}

}  // namespace magicmass::derivation
