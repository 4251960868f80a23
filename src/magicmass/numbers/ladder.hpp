// SPDX-License-Identifier: MIT
// Single numbers, one number type after the other: the tier's own, Slow, MPFR's. nullopt: the
// inputs have no answer. Throw Undecided.
#pragma once

#include <optional>
#include <string>

#include "magicmass/numbers/kernels.hpp"

namespace magicmass::numbers {
/// The shortest text that is read as x.
std::string text_of(double x);
inline bool is_mass_ratio(double alpha) { return alpha > 0.0 && alpha <= 0x1.fffffffffffffp1023; }
std::optional<Velocities> velocities(Tier tier, double alpha, std::int64_t n);
std::optional<Terminal> terminal(Tier tier, double alpha);
}  // namespace magicmass::numbers
