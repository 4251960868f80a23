// SPDX-License-Identifier: MIT
// Behind the last rounding test: the generated evaluators on MPFR's numbers, with more and more
// bits until every rounding and sign is certain. All throw Undecided at the last precision. Here is
// what is no tier of kernels.hpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "magicmass/numbers/values.hpp"

namespace magicmass::numbers {
/// The shortest text that is read as x.
std::string text_of(double x);
/// Masses above 0, or per_B 0; 0 < e <= 1; within fast's promise. nullopt: they never end.
std::optional<Terminal> restitution_by_mpfr(Masses masses, double e);
/// (alpha - threshold)/threshold; for alpha_k k >= 2.
double distance_by_mpfr(double alpha, bool is_magic, std::int64_t k);
}  // namespace magicmass::numbers
