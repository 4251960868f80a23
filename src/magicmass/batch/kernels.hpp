// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "magicmass/batch/instruction_set.hpp"

namespace magicmass::batch {

/// The batch functions for one instruction set, without checks: arrays of `size` elements, aligned or not, outputs
/// apart from each other and from the inputs.
struct Kernels {
  void (*counts)(const double* alpha, std::int64_t* N_A, std::int64_t* N_B, std::size_t size);
  void (*stream)(double alpha, std::int64_t first_n, double* a, double* b, double* c,
                 double* c_prime, std::size_t size);
};

/// kernels.cpp, compiled once for each: constants, so that asking for one runs none of its code.
namespace tables {
extern const Kernels baseline;
extern const Kernels avx2;
extern const Kernels avx512;
}  // namespace tables

/// Throws InvalidInput where this machine does not have the instruction set.
const Kernels& kernels(InstructionSet instruction_set);

}  // namespace magicmass::batch
