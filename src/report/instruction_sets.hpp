// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "magicmass/batch/instruction_set.hpp"

namespace magicmass::report {

/// Those of this machine, the best first.
inline std::vector<InstructionSet> available_instruction_sets() {
  std::vector<InstructionSet> all;
  for (const InstructionSet one : all_instruction_sets)
    if (is_available(one)) all.insert(all.begin(), one);
  return all;
}

/// Behind a contestant's name: nothing for the best, so that the name is the same on every machine; else _avx2 or _baseline.
inline std::string suffix(InstructionSet set) {
  return set == best_instruction_set() ? "" : "_" + to_text(set);
}

}  // namespace magicmass::report
