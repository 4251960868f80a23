// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "magicmass/errors.hpp"
#include "magicmass/evaluators/near_integer.hpp"
#include "magicmass/evaluators/nearest_double.hpp"

namespace magicmass {

/// Ziv's strategy: attempt.operator()<Words>(), which returns an optional, at one size after another until there is a
/// value. Throws Undecided if there is none at the last.
template <std::size_t Words, std::size_t... More, class Attempt>
auto until_certain(const char* what, const Attempt& attempt) {
  if (const auto result = attempt.template operator()<Words>()) {
    return *result;
  }
  if constexpr (sizeof...(More) > 0) {
    return until_certain<More...>(what, attempt);
  } else {
    throw Undecided(std::string(what) + " stays open at " + std::to_string(64 * Words) + " bits");
  }
}

/// The same at the sizes used: four words settle nearly everything that was ever tried, and the larger ones are there so
/// that nothing rests on "nearly".
template <class Attempt>
auto certain(const char* what, const Attempt& attempt) {
  return until_certain<4, 8, 16, 24>(what, attempt);
}

/// A grid too fine for any number to be found on it.
inline constexpr int no_grid = 1 << 20;

/// The double nearest to a number that is a multiple of 2^-grid; nullopt if that is not certain.
template <std::size_t Words>
std::optional<double> rounded(const NearInteger<Words>& x, int grid = no_grid) {
  return nearest_double(grid == no_grid ? x.together() : on_grid(x.together(), grid));
}

}  // namespace magicmass
