// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>

#include "proof/statement.hpp"

// The paper's equations by label, one file a chapter of the derivation. They are claims: the derivation
// must reach them by itself, and nothing is ever computed from them.
namespace magicmass::derivation {

using Equations = std::map<std::string, proof::Statement>;

Equations orthogonal_equations();
Equations frame_equations();
Equations contact_equations();
Equations cycle_equations();
Equations rotation_equations();
Equations mapping_equations();
Equations table_equations();
Equations multiples_equations();
Equations power_equations();
Equations counting_equations();
Equations ratios_equations();
Equations small_alpha_equations();
Equations terminal_equations();

Equations restitution_equations();

}  // namespace magicmass::derivation
