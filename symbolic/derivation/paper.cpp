// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/paper.hpp"

#include "derivation/paper/equations.hpp"

namespace magicmass::derivation {

Paper paper() {
  Equations all;
  for (Equations part :
       {orthogonal_equations(), frame_equations(), contact_equations(), cycle_equations(),
        rotation_equations(), mapping_equations(), table_equations(), multiples_equations(),
        power_equations(), counting_equations(), ratios_equations()})
    all.merge(part);
  return Paper(std::move(all));
}

}  // namespace magicmass::derivation
