// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "magicmass/batch/instruction_set.hpp"

namespace magicmass::testing {

/// Those that this machine can run; the first is always the baseline.
inline std::vector<InstructionSet> available_instruction_sets() {
  std::vector<InstructionSet> sets;
  for (const InstructionSet set : all_instruction_sets) {
    if (is_available(set)) sets.push_back(set);
  }
  return sets;
}

}  // namespace magicmass::testing
