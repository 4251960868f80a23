// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/reproduce/sections.hpp"

namespace magicmass::command {

std::vector<ComparisonSection> comparison_sections() {
  return {ratio_section(),       count_section(),    terminal_section(),
          restitution_section(), collapse_section(), cradle_section()};
}

}  // namespace magicmass::command
