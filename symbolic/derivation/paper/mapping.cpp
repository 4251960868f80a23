// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "derivation/paper/equations.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;

Equations mapping_equations() {
  const ex root_1 = sqrt(symbol("M_1")), root_2 = sqrt(symbol("M_2"));
  const auto projection = [&](const char* v_1, const char* v_2) {
    return root_1 * (root_1 * symbol(v_1)) + root_2 * (root_2 * symbol(v_2));
  };
  return {{"sec:comparison, projection", {projection("u_1", "u_2"), projection("v_1", "v_2")}}};
}

}  // namespace magicmass::derivation
