// SPDX-License-Identifier: MIT
#include "magicmass/tiers/single_kernels.hpp"

namespace magicmass::tiers {

const SingleKernels& single_kernels(InstructionSet instruction_set) {
  switch (instruction_set) {
    case InstructionSet::avx512:
      return tables::avx512;
    case InstructionSet::avx2:
      return tables::avx2;
    case InstructionSet::baseline:
      break;
  }
  return tables::baseline;
}

}  // namespace magicmass::tiers
