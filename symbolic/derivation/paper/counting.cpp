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

Equations counting_equations() {
  const ex k = symbol("k"), psi = symbol("psi");
  return {
      {"eq:NA-ans", {symbol("N_A"), ceiling(Pi / psi - one_half)}},
      {"eq:NB-ans", {symbol("N_B"), ceiling(Pi / psi - 1)}},
      {"eq:NANB-ans, equal", {symbol("N_A"), ceiling(Pi / psi) - 1}},
      {"eq:NANB-ans, otherwise", {symbol("N_A"), ceiling(Pi / psi)}},
      {"eq:Naatcritical", {k, Pi / psi - one_half}},
      {"eq:Nbatcritical", {k, Pi / psi - 1}},
  };
}

}  // namespace magicmass::derivation
