// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>

#include "magicmass/arithmetic/target.hpp"

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

/// Rows of a block: a few kilobytes in all, so that what a second pass needs is still in the first cache.
inline constexpr std::size_t block_rows = 128;
/// A kernel may count on a multiple of this: two of the widest registers of doubles.
inline constexpr std::size_t group_rows = 16;

/// A copy of a short column, filled up to a whole group. A const column is an input: its last group is filled up with
/// its first row, so that a kernel never sees a value that the caller did not give.
template <class Value>
struct Tail {
  alignas(64) std::remove_const_t<Value> rows[block_rows];

  [[gnu::always_inline]] Tail(const Value* column, std::size_t size, std::size_t rounded_size) {
    if constexpr (std::is_const_v<Value>) {
      std::memcpy(rows, column, size * sizeof(Value));
      for (std::size_t i = size; i < rounded_size; ++i) rows[i] = column[0];
    }
  }
  [[gnu::always_inline]] void write_to(Value* column, std::size_t size) const {
    if constexpr (!std::is_const_v<Value>) std::memcpy(column, rows, size * sizeof(Value));
  }
};

/// Calls kernel(first, rows, columns...) for blocks of consecutive rows from `first` on, each a multiple of group_rows long and at
/// most block_rows. Some rows come twice where that fills the last group; columns too short for that are copied.
/// Columns are of const values (inputs) or of values (outputs).
template <class Kernel, class... Values>
[[gnu::always_inline]] inline void block_by_block(std::size_t size, Kernel kernel,
                                                  Values*... columns) {
  std::size_t done = 0;
  for (; size - done >= block_rows; done += block_rows)
    kernel(done, block_rows, (columns + done)...);
  const std::size_t rest = size - done;
  if (rest == 0) return;
  const std::size_t rounded = (rest + group_rows - 1) / group_rows * group_rows;
  if (rounded <= size) {
    const std::size_t first = size - rounded;
    kernel(first, rounded, (columns + first)...);
    return;
  }
  const auto finish = [&](Tail<Values>&&... tails) {
    kernel(std::size_t{0}, rounded, static_cast<Values*>(tails.rows)...);
    (tails.write_to(columns, rest), ...);
  };
  finish(Tail<Values>(columns, rest, rounded)...);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::batch
