// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "magicmass/arithmetic/lanes.hpp"
#include "magicmass/arithmetic/table_node.hpp"
#include "magicmass/arithmetic/turns_table.hpp"

namespace magicmass::tiers {
inline namespace MAGICMASS_TARGET {

/// pi/h with cos h = 1/(1+alpha), of which the number of collisions is ceil(pi/h) - 1.
struct TurnsToPi {
  double quotient;
  double relative_error;           ///< at most this
  double cycles = 0.5 * quotient;  ///< known as early
};

/// For alpha below 1, or the least bit more.
[[gnu::always_inline]] inline TurnsToPi turns_to_pi(double alpha) {
  // pi/h = G(alpha)/sqrt(alpha), G by a table and its slope: what follows is less than a tenth of the square of what is left of alpha,
  // and there are six roundings, of 2^-53 each. The root and the quotient do not wait for each other.
  const auto node = arithmetic::table_node_inside<2>(arithmetic::turns_table, alpha);
  const double G = node.row[0] + node.row[1] * node.rest;
  const double inverse_root = arithmetic::square_root(alpha) * (1.0 / alpha);
  return {G * inverse_root, 0.2 * (node.rest * node.rest) + 0x1p-49, G * (0.5 * inverse_root)};
}

/// The number of collisions where pi/h, less than 2^63, tells it, else 0.
[[gnu::always_inline]] inline std::int64_t clear_total(TurnsToPi turns) {
  const double unsure = turns.relative_error * turns.quotient;  // from 1/2 on nothing is certain
  const auto below = static_cast<std::int64_t>(turns.quotient);
  const double past = turns.quotient - static_cast<double>(below);
  return past > unsure && past < 1.0 - unsure ? below : 0;
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::tiers
