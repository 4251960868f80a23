// SPDX-License-Identifier: MIT
// The rows of a block from alpha = 1 on: few, and with a kernel of their own they cost the others nothing but a look.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include <immintrin.h>

#include "magicmass/arithmetic/rough_functions.hpp"
#include "magicmass/batch/blocks.hpp"
#include "magicmass/batch/open_rows.hpp"
#include "magicmass/kernels/terminal_from_one.hpp"

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

/// A bit a lane, the lowest for the first.
[[gnu::always_inline]] inline std::uint64_t bit_per_lane(RowBits mask) {
#if defined(__AVX512F__)
  return _mm512_movepi64_mask(std::bit_cast<__m512i>(mask));
#elif defined(__AVX2__)
  return static_cast<std::uint64_t>(_mm256_movemask_pd(std::bit_cast<__m256d>(mask)));
#else
  return static_cast<std::uint64_t>(_mm_movemask_pd(std::bit_cast<__m128d>(mask)));
#endif
}

/// The velocities of those rows of a block, side by side, and where they belong. They are computed first and written last: so
/// nothing waits for them.
class RowsFromOne {
public:
  [[gnu::always_inline]] RowsFromOne(std::size_t rows, const double* alpha) {
    std::uint64_t bits = 0, further = 0;  // of the first 64 rows, and of the others
    for (std::size_t i = 0; i < rows; i += lanes) {
      const std::uint64_t more = bit_per_lane(arithmetic::load<Row>(alpha + i) >= Row(1.0));
      (i < word ? bits : further) |= more << (i % word);
    }
    count_ = static_cast<std::size_t>(std::popcount(bits) + std::popcount(further));
    std::size_t first = 0, place = 0;
    for (; filled_ < count_; filled_ += at_once)
      for (std::size_t k = filled_; k < filled_ + at_once; ++k) {
        first = bits == 0 ? word : first;
        const std::uint64_t now = bits == 0 ? further : bits;
        further = bits == 0 ? 0 : further;
        // the last row fills up what is left
        place = now == 0 ? place : first + static_cast<std::size_t>(std::countr_zero(now));
        bits = now & (now - 1);
        ratios_[k] = alpha[place];
        places_[k] = static_cast<std::uint32_t>(place);
      }
    generated::terminal_from_one_block<arithmetic::Rough<Row>>(filled_, ratios_, a_t_, b_t_, c_t_);
  }

  std::size_t count() const { return count_; }

  [[gnu::always_inline]] void write(double* a_t, double* b_t, double* c_t) const {
    for (std::size_t i = 0; i < filled_; i += at_once)
      for (std::size_t k = i; k < i + at_once; ++k) {
        a_t[places_[k]] = a_t_[k];
        b_t[places_[k]] = b_t_[k];
        c_t[places_[k]] = c_t_[k];
      }
  }

private:
  static constexpr std::size_t word = 64, lanes = arithmetic::widest;
  /// How often a loop turns is foreseen more often if it does so many a turn; within a turn nothing branches.
  static constexpr std::size_t at_once = 8;
  static_assert(block_rows == 2 * word && word % at_once == 0 && at_once % lanes == 0);

  std::size_t count_ = 0;
  std::size_t filled_ = 0;
  std::uint32_t places_[block_rows];
  alignas(64) double ratios_[block_rows];
  alignas(64) double a_t_[block_rows];
  alignas(64) double b_t_[block_rows];
  alignas(64) double c_t_[block_rows];
};

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::batch
