// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "magicmass/arithmetic/block.hpp"

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

using Row = arithmetic::Lanes<arithmetic::widest>;
using RowMask = Row::Mask;

/// Whole numbers 0 <= n < 2^52 as doubles plus 2^52; anything else gives a double out of [2^52, 2^53).
[[gnu::always_inline]] inline Row above_2_52(const std::int64_t* from) {
  RowMask bits;
  std::memcpy(&bits, from, sizeof bits);
  return Row(std::bit_cast<Row::Doubles>(bits ^ (RowMask{} + std::bit_cast<std::int64_t>(0x1p52))));
}

[[gnu::always_inline]] inline bool is_all_set(RowMask mask) {
  std::int64_t all = -1;
  for (int lane = 0; lane < arithmetic::widest; ++lane) all &= mask[lane];
  return all == -1;
}

/// Which rows are in a kernel's domain; the others, and those whose rounding it leaves open, are done one by one.
struct OpenRows {
  alignas(64) std::array<std::int64_t, arithmetic::block_size> is_in_domain;
  bool any = false;

  [[gnu::always_inline]] void put(std::size_t i, RowMask in_domain) {
    std::memcpy(&is_in_domain[i], &in_domain, sizeof in_domain);
    any = any || !is_all_set(in_domain);
  }
  template <class Number>
  [[gnu::always_inline]] bool is_open(std::size_t i,
                                      const arithmetic::Certainty<Number>& certain) const {
    if constexpr (requires { certain.all; })
      return is_in_domain[i] == 0 || certain.all[i] == 0;
    else
      return is_in_domain[i] == 0;
  }
};

template <class Number>
constexpr bool rounding_is_tested = requires(arithmetic::Certainty<Number> certain) {
  certain.all;
};

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::batch
