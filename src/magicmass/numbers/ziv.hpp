// SPDX-License-Identifier: MIT
// Behind the last rounding test: the generated evaluators on MPFR's numbers, with more and more
// bits until every rounding and sign is certain. All throw Undecided at the last precision.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "magicmass/numbers/values.hpp"

namespace magicmass::numbers {
/// The shortest text that is read as x.
std::string text_of(double x);
/// alpha > 0, 1 <= n <= N_A.
Velocities velocities_by_mpfr(double alpha, std::int64_t n);
/// alpha > 0 with N_A, N_B < 2^63.
Terminal terminal_by_mpfr(double alpha);
/// Masses above 0, or per_B 0; 0 < e <= 1; within fast's promise. nullopt: they never end.
std::optional<Terminal> restitution_by_mpfr(Masses masses, double e);
/// alpha > 0, 1 <= j < N_A + N_B.
Collision collision_by_mpfr(double alpha, std::int64_t j);
/// alpha > 0.
double angle_by_mpfr(double alpha);
/// k >= 2.
double magic_by_mpfr(std::int64_t k);
/// k >= 1.
double deficient_by_mpfr(std::int64_t k);
/// (alpha - threshold)/threshold; for alpha_k k >= 2.
double distance_by_mpfr(double alpha, bool is_magic, std::int64_t k);
}  // namespace magicmass::numbers
