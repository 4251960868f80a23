// SPDX-License-Identifier: GPL-2.0-or-later
// The oracle's answers in the types of the numeric functions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "magicmass/numbers/values.hpp"

namespace magicmass::testing {
std::optional<Counts> counts_by_oracle(double alpha);
Velocities velocities_by_oracle(double alpha, std::int64_t n);
Terminal terminal_by_oracle(double alpha, const Counts& counts);
Collision collision_by_oracle(double alpha, std::int64_t j);
Ratios ratios_by_oracle(std::int64_t k);
/// psi = 2 atan(sqrt(alpha (2 + alpha))), from floats of 300 digits.
double angle_by_oracle(double alpha);
/// The largest error, in envelopes.
double envelopes_of(const Velocities& got, double alpha, std::int64_t n);
double envelopes_of(const Collision& got, double alpha, std::int64_t j);
double envelopes_of(const Terminal& got, double alpha);
std::string in_hex(double x);
}  // namespace magicmass::testing
