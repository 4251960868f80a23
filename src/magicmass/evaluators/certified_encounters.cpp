// SPDX-License-Identifier: MIT
#include "magicmass/evaluators/certified_encounters.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "magicmass/counts.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/evaluators/encounter_attempts.hpp"

namespace magicmass {
namespace {

/// j as a natural number.
std::uint64_t require_collision(double alpha, std::int64_t j) {
  const std::optional<Counts> counts = count_collisions(alpha);  // none: 2^63 or more
  if (j < 0) {
    throw InvalidInput("j must be 0 or more, got " + std::to_string(j));
  }
  if (counts && j >= counts->N_A + counts->N_B) {
    throw InvalidInput("j must be below the number of collisions, " +
                       std::to_string(counts->N_A + counts->N_B) + ", got " + std::to_string(j));
  }
  return static_cast<std::uint64_t>(j);
}

}  // namespace

generated::Encounters<double> certified_encounters(double alpha, std::int64_t j) {
  const std::uint64_t collision = require_collision(alpha, j);
  if (collision == 0) {
    return {0.0, 1.0};
  }
  return certain("the rounding of a time or distance",
                 [&]<std::size_t Words>() { return attempt_encounters<Words>(alpha, collision); });
}

}  // namespace magicmass
