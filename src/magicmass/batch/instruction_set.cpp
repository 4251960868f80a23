// SPDX-License-Identifier: MIT
#include "magicmass/batch/instruction_set.hpp"

namespace magicmass {
namespace {

InstructionSet widest_available() {
  InstructionSet best = InstructionSet::baseline;
  for (const InstructionSet instruction_set : all_instruction_sets) {
    if (is_available(instruction_set)) best = instruction_set;
  }
  return best;
}

}  // namespace

std::string to_text(InstructionSet instruction_set) {
  switch (instruction_set) {
    case InstructionSet::avx512:
      return "avx512";
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::baseline:
      break;
  }
  return "baseline";
}

bool is_available(InstructionSet instruction_set) {
  // each of these also asks whether the operating system saves the registers
  switch (instruction_set) {
    case InstructionSet::avx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
    case InstructionSet::avx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case InstructionSet::baseline:
      break;
  }
  return true;
}

InstructionSet best_instruction_set() {
  static const InstructionSet best = widest_available();
  return best;
}

}  // namespace magicmass
