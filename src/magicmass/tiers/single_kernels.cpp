// SPDX-License-Identifier: MIT
#include "magicmass/tiers/single_kernels.hpp"

namespace magicmass::tiers {

const SingleKernels& single_kernels() {
  static const SingleKernels& best =
      __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? single_kernels_avx2()
                                                                      : single_kernels_baseline();
  return best;
}

}  // namespace magicmass::tiers
