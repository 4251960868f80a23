// SPDX-License-Identifier: MIT
// How many collisions take place, exactly, and which threshold is nearest. Thread-safe.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "magicmass/numbers/errors.hpp"
#include "magicmass/numbers/values.hpp"

namespace magicmass {
/// Exact N_A and N_B for every double alpha > 0, on thresholds and as close to them as doubles are.
/// nullopt: N_A + N_B is 2^63 or more, which is so for alpha below about 5.8e-38.
/// Throws InvalidInput unless alpha is positive and finite.
std::optional<Counts> count_collisions(double alpha);
/// The same for arrays: rows without an answer are -1; an empty span is not wanted.
/// Throws InvalidInput if sizes differ or columns overlap, NotIeee.
void count_collisions(std::span<const double> alpha, std::span<std::int64_t> N_A,
                      std::span<std::int64_t> N_B);
/// The magic or deficient mass ratio with the smallest |distance|. nullopt and InvalidInput as for
/// count_collisions; some 20 microseconds.
std::optional<Threshold> nearest_threshold(double alpha);
}  // namespace magicmass
