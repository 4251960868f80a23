// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/quantities.hpp"

namespace magicmass::tiers {

/// What the generated kernels give for one input, compiled with and without fused multiply-add: the same bits. The
/// functions that return bool say whether every member is certainly the nearest double.
struct SingleKernels {
  /// n as high + low, each a double, exactly.
  generated::Velocities<double> (*fast_velocities)(double alpha, double n, double n_low);
  generated::Encounters<double> (*fast_encounters)(double alpha, double j);
  double (*fast_angle)(double alpha);
  generated::Ratios<double> (*fast_ratios)(double k);

  bool (*velocities)(double alpha, double n, generated::Velocities<double>& result);
  bool (*encounters)(double alpha, double j, generated::Encounters<double>& result);
  bool (*angle)(double alpha, double& result);
  bool (*ratios)(double k, generated::Ratios<double>& result);
};

/// Those for this machine.
const SingleKernels& single_kernels();

/// Each, for tests and reports; the second only where the processor has AVX2 and FMA.
const SingleKernels& single_kernels_baseline();
const SingleKernels& single_kernels_avx2();

}  // namespace magicmass::tiers
