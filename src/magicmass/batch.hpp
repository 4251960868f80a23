// SPDX-License-Identifier: MIT
// Many inputs at once: one contiguous span a quantity, in and out. Nothing is allocated and nothing is
// modified but the outputs. Spans may be of any length and alignment, but all of a call have the same size, and
// outputs overlap neither each other nor an input: else InvalidInput is thrown and nothing is written.
// An input without an answer (alpha not positive and finite, n negative) gets NaN, or -1 for a count, in its
// place. The last argument is for tests and measurements; results are the same bits with every instruction set, and
// InvalidInput is thrown where the machine does not have it.
#pragma once

#include <cstdint>
#include <span>

#include "magicmass/batch/instruction_set.hpp"

namespace magicmass {

/// N_A and N_B (Ee & Lee Appendix sec:N-app), exact for every positive finite alpha, as those of
/// count_collisions(alpha); -1 also where N_A + N_B is 2^63 or more, which is so for alpha below about 5.8e-38.
void count_collisions(std::span<const double> alpha, std::span<std::int64_t> N_A,
                      std::span<std::int64_t> N_B,
                      InstructionSet instruction_set = best_instruction_set());

/// All velocities just after the n-th collisions (Ee & Lee eqs. eq:a-final to eq:c'-final) in units of V, n = first_n,
/// first_n + 1, ...; NaN before n = 0 and past n = N_A. Each is within 3 eps of the largest velocity of its body in the
/// whole sequence (c and c' are those of one body), whatever n. A call begins with a few hundred nanoseconds of work,
/// so long spans pay.
void velocity_stream(double alpha, std::int64_t first_n, std::span<double> a, std::span<double> b,
                     std::span<double> c, std::span<double> c_prime,
                     InstructionSet instruction_set = best_instruction_set());

namespace fast {
/// All velocities just after the n-th collisions of alpha (Ee & Lee eqs. eq:a-final to eq:c'-final), in units of V,
/// where 0 <= n <= N_A(alpha). Each within 4 times max(1/2, cond/2) ulp, cond = |alpha y'/y|. From theorems tangent.*.
void velocities(std::span<const double> alpha, std::span<const std::int64_t> n, std::span<double> a,
                std::span<double> b, std::span<double> c, std::span<double> c_prime,
                InstructionSet instruction_set = best_instruction_set());
}  // namespace fast
namespace accurate {
/// The nearest doubles; else as fast::velocities. From theorems tangent.*.
void velocities(std::span<const double> alpha, std::span<const std::int64_t> n, std::span<double> a,
                std::span<double> b, std::span<double> c, std::span<double> c_prime,
                InstructionSet instruction_set = best_instruction_set());
}  // namespace accurate

namespace fast {
/// The same at one n for all alpha: for n = 1 and 2 from the rational forms, theorems fixed_n.*, which take less time.
void velocities(std::span<const double> alpha, std::int64_t n, std::span<double> a,
                std::span<double> b, std::span<double> c, std::span<double> c_prime,
                InstructionSet instruction_set = best_instruction_set());
}  // namespace fast
namespace accurate {
/// The nearest doubles; else as fast::velocities. From theorems tangent.* and fixed_n.*.
void velocities(std::span<const double> alpha, std::int64_t n, std::span<double> a,
                std::span<double> b, std::span<double> c, std::span<double> c_prime,
                InstructionSet instruction_set = best_instruction_set());
}  // namespace accurate

namespace fast {
/// Exact counts and the velocities after the last collision (Ee & Lee eqs. eq:a-terminal, eq:b-terminal, eq:ct), in
/// units of V, with the errors as above. From theorems offset.*. Where the counts do not fit 64 bits they are -1 and
/// the velocities NaN.
void terminal(std::span<const double> alpha, std::span<std::int64_t> N_A,
              std::span<std::int64_t> N_B, std::span<double> a_t, std::span<double> b_t,
              std::span<double> c_t, InstructionSet instruction_set = best_instruction_set());
}  // namespace fast
namespace accurate {
/// The nearest doubles; else as fast::terminal. From theorems offset.*.
void terminal(std::span<const double> alpha, std::span<std::int64_t> N_A,
              std::span<std::int64_t> N_B, std::span<double> a_t, std::span<double> b_t,
              std::span<double> c_t, InstructionSet instruction_set = best_instruction_set());
}  // namespace accurate

namespace fast {
/// The fraction rho of the energy that B takes where every contact has the restitution 2^-400 <= e <= 1, within 4 times
/// max(1/2, cond/2) ulp, cond the sum of the condition numbers in alpha and e. NaN where the collisions never end,
/// alpha <= alpha_c(e) = (1 - sqrt(e))^2/(2 sqrt(e)), where alpha is closer to that than 2^-95 of it, and for e < 1
/// where there are 2^51 collisions or more. Throws InvalidInput for another e. From theorems transmission.*.
void transmission(std::span<const double> alpha, double e, std::span<double> rho,
                  InstructionSet instruction_set = best_instruction_set());
}  // namespace fast

namespace fast {
/// Magic and deficient mass ratios alpha_k and beta_k (Ee & Lee, Table II: exact:ak, exact:bk), k = first_k, first_k +
/// 1, ...; NaN for k < 1 and past the largest std::int64_t. Within 1 ulp. From theorems ratios.*.
void ratios(std::int64_t first_k, std::span<double> magic, std::span<double> deficient,
            InstructionSet instruction_set = best_instruction_set());
}  // namespace fast
namespace accurate {
/// The nearest doubles; else as fast::ratios. From theorems ratios.*.
void ratios(std::int64_t first_k, std::span<double> magic, std::span<double> deficient,
            InstructionSet instruction_set = best_instruction_set());
}  // namespace accurate

}  // namespace magicmass
