// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "derivation/paper/equations.hpp"
#include "proof/families.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;

// The paper's a_n, b_n, c_n, c'_n with restitution are the wedge's between equal blocks.
Equations restitution_equations() {
  const ex n = symbol("n"), alpha = symbol("alpha"), e = symbol("e");
  const GiNaC::exmap equal{{symbol("mu_A"), 1 / (1 + alpha)}, {symbol("mu_B"), 1 / (1 + alpha)}};
  const auto between = [&](const ex& family) { return family.subs(equal); };
  const ex a_before = between(v_A(n - 1)), a_after = between(v_A(n)),
           b_before = between(v_B(n - 1)), b_after = between(v_B(n)), c_n = between(v_C(n)),
           c_before = between(v_C_prime(n - 1)), c_after = between(v_C_prime(n));
  return {
      {"sec:result, inelastic P momentum", {a_before + alpha * c_before, a_after + alpha * c_n}},
      {"sec:result, inelastic P restitution", {e * (a_before - c_before), c_n - a_after}},
      {"sec:result, inelastic Q momentum", {b_before + alpha * c_n, b_after + alpha * c_after}},
      {"sec:result, inelastic Q restitution", {e * (c_n - b_before), b_after - c_after}},
  };
}

}  // namespace magicmass::derivation
