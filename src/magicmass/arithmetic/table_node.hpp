// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "magicmass/arithmetic/target.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// A row of a table, and what is left of the argument.
struct TableNode {
  const double* row;
  double rest;
};

/// x, 0 <= x < 2^40, to the nearest multiple of 2^-8: its row in a table with 256 a unit, and what is left of x, exactly. x has
/// to be in the table.
template <std::size_t columns>
[[gnu::always_inline]] inline TableNode table_node_inside(const double* table, double x) {
  constexpr double shift = 0x1.8p44;  // its last bit is 2^-8, and a double's last 20 bits are clear
  const double shifted = x + shift;
  const std::uint64_t place = std::bit_cast<std::uint64_t>(shifted) & 0xfffff;
  return {table + columns * place, x - (shifted - shift)};
}

/// The same with the last row for what is not in the table.
template <std::size_t columns, std::size_t size>
[[gnu::always_inline]] inline TableNode table_node(const double (&table)[size], double x) {
  constexpr double shift = 0x1.8p44;
  const double shifted = x + shift;
  const std::uint64_t place = std::bit_cast<std::uint64_t>(shifted) & 0xfffff;
  return {table + columns * std::min<std::uint64_t>(place, size / columns - 1),
          x - (shifted - shift)};
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
