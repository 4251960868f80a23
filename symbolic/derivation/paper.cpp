// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/paper.hpp"

#include "derivation/paper/equations.hpp"
#include "magicmass/errors.hpp"

namespace magicmass::derivation {

const std::map<std::string, Equations>& paper_chapters() {
  static const std::map<std::string, Equations> chapters{
      {"orthogonal", orthogonal_equations()}, {"frame", frame_equations()},
      {"mapping", mapping_equations()},       {"table", table_equations()},
      {"multiples", multiples_equations()},   {"contact", contact_equations()},
      {"cycle", cycle_equations()},           {"rotation", rotation_equations()},
      {"power", power_equations()},           {"counting", counting_equations()},
      {"ratios", ratios_equations()},         {"restitution", restitution_equations()},
      {"terminal", terminal_equations()},     {"small_alpha", small_alpha_equations()},
  };
  return chapters;
}

const proof::Statement& Paper::at(const std::string& label) const {
  const auto found = equations_.find(label);
  if (found == equations_.end()) throw InvalidInput("no equation of the paper is called " + label);
  return found->second;
}

Paper paper() {
  Equations all;
  for (const auto& [chapter, equations] : paper_chapters())
    all.insert(equations.begin(), equations.end());
  return Paper(std::move(all));
}

}  // namespace magicmass::derivation
