// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "magicmass/batch/instruction_set.hpp"

namespace magicmass::batch {

/// The batch functions for one instruction set, without checks: arrays of `size` elements, aligned or not, outputs
/// apart from each other and from the inputs.
struct Kernels {
  using Velocities = void (*)(const double* alpha, const std::int64_t* n, double* a, double* b,
                              double* c, double* c_prime, std::size_t size);
  using VelocitiesAtN = void (*)(const double* alpha, std::int64_t n, double* a, double* b,
                                 double* c, double* c_prime, std::size_t size);
  using Terminal = void (*)(const double* alpha, std::int64_t* N_A, std::int64_t* N_B, double* a_t,
                            double* b_t, double* c_t, std::size_t size);
  using Ratios = void (*)(std::int64_t first_k, double* magic, double* deficient, std::size_t size);

  void (*counts)(const double* alpha, std::int64_t* N_A, std::int64_t* N_B, std::size_t size);
  void (*stream)(double alpha, std::int64_t first_n, double* a, double* b, double* c,
                 double* c_prime, std::size_t size);
  Velocities fast_velocities;
  Velocities accurate_velocities;
  VelocitiesAtN fast_velocities_at_n;
  VelocitiesAtN accurate_velocities_at_n;
  Terminal fast_terminal;
  Terminal accurate_terminal;
  void (*transmission)(const double* alpha, double e, double* rho, std::size_t size);
  Ratios fast_ratios;
  Ratios accurate_ratios;
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
