// SPDX-License-Identifier: MIT
// Tier fast: within 4 envelopes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "magicmass/numbers/errors.hpp"
#include "magicmass/numbers/values.hpp"

/// What accurate.hpp says holds here, but for the errors: they are at most 4 envelopes of
/// max(1/2, |alpha y'/(2 y)|) ulp, half of which rounding alpha alone would cost, and without
/// restitution 2^-50 of the largest velocity of that body; counts are exact. A zero may have either
/// sign, as may a value that is smaller than its promised error.
namespace magicmass::fast {
/// Inputs, units and refusals are accurate's.
Velocities velocities(double alpha, std::int64_t n);
Collision collision(double alpha, std::int64_t j);
double angle(double alpha);
Ratios ratios(std::int64_t k);
void velocities(std::span<const double> alpha, std::span<const std::int64_t> n,
                const VelocityColumns& columns);
void terminal(std::span<const double> alpha, const TerminalColumns& columns);
std::optional<Terminal> terminal(double alpha);
/// The same where each collision has restitution e, 0 < e <= 1, else InvalidInput: errors are at
/// most 4 envelopes of max(1/2, (|alpha y_alpha| + |e y_e|)/|2 y|) ulp, counts are exact. nullopt:
/// the collisions never end (accurate::collapse; decided exactly), or accurate's where e is 1.
/// Throws Undecided where 1 - (1 - e)^2/(4 e alpha (2 + alpha)), which is 0 where collapse begins,
/// is above 0 and below 2^-80, or where more than some 2^62 collisions take place, e < 1, or more
/// than two with e below 2^-380.
std::optional<Terminal> terminal(double alpha, double e);
/// The same for any masses, or two and a wall: within 4 envelopes of max(1/2, (|m y_m| + |w y_w| +
/// |e y_e|)/|2 y|) ulp, m and w those of `masses`, and before a wall, where all may come to rest,
/// within 2^-190 at least; a wall's velocity and share are 0. InvalidInput unless m is positive, w
/// not negative and both finite. Undecided also where more than some 2^62 take place with e = 1, or
/// more than two with M_A/M_B above 2^128 or M_C/M_A above 2^190.
std::optional<Terminal> terminal(const Masses& masses, double e);
}  // namespace magicmass::fast
