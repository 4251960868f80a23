// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "magicmass/batch/instruction_set.hpp"
#include "magicmass/quantities.hpp"
#include "magicmass/terminal.hpp"

namespace magicmass::tiers {

/// What a double leaves of a whole number n >= 0.
constexpr double low_part(std::int64_t n) {
  if (n <= std::int64_t{1} << 53U) [[likely]]
    return 0.0;
  const auto high = static_cast<double>(n);
  // 2^63 itself is not an int64
  return high < 0x1p63 ? static_cast<double>(n - static_cast<std::int64_t>(high)) : 0.0;
}

/// What the generated kernels give for one input, compiled with and without fused multiply-add: the same bits. The
/// functions that return bool say whether every member is certainly the nearest double.
struct SingleKernels {
  /// n as high + low, each a double, exactly.
  generated::Velocities<double> (*fast_velocities)(double alpha, double n, double n_low);
  /// For alpha below 1, j as high + low. A distance that is not positive: there is no such collision, or it is not known.
  generated::Encounters<double> (*fast_encounters)(double alpha, double j, double j_low);
  double (*fast_angle)(double alpha);
  /// k as high + low, too.
  generated::Ratios<double> (*fast_ratios)(double k, double k_low);
  /// With the counts, for 2^-900 <= alpha <= 2^960; false where these would take more digits or do not fit.
  bool (*fast_terminal)(double alpha, Terminal& result);
  /// N_A + N_B, exactly, for alpha below 1; 0 where that would take more digits or does not fit.
  std::int64_t (*total)(double alpha);

  bool (*velocities)(double alpha, double n, generated::Velocities<double>& result);
  bool (*encounters)(double alpha, double j, generated::Encounters<double>& result);
  bool (*angle)(double alpha, double& result);
  bool (*ratios)(double k, generated::Ratios<double>& result);
  bool (*terminal)(double alpha, double N_A, double turn,
                   generated::TerminalValues<double>& result);
  /// Where the first stage is known not to tell.
  bool (*terminal_in_second_stage)(double alpha, double N_A, double turn,
                                   generated::TerminalValues<double>& result);
};

/// single_kernels_for_target.cpp, compiled once for each instruction set: constants, so that asking for one runs none of
/// its code.
namespace tables {
extern const SingleKernels baseline;
extern const SingleKernels avx2;
extern const SingleKernels avx512;
}  // namespace tables

/// Those for an instruction set that this machine has.
const SingleKernels& single_kernels(InstructionSet instruction_set);

/// Those for the best it has.
inline const SingleKernels& single_kernels() {
  static const SingleKernels& best = single_kernels(best_instruction_set());
  return best;
}

}  // namespace magicmass::tiers
