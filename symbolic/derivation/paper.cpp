// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/paper.hpp"

#include "derivation/paper/equations.hpp"

namespace magicmass::derivation {

Paper paper() {
  Equations all;
  for (Equations part :
       {contact_equations(), cycle_equations(), rotation_equations(), power_equations(),
        counting_equations(), ratios_equations(), restitution_equations()})
    all.merge(part);
  return Paper(std::move(all));
}

}  // namespace magicmass::derivation
