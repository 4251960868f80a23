// SPDX-License-Identifier: MIT
// Exact counts and terminal velocities by the block: the generated kernel where it is valid, the function for one input
// where it is not or where a rounding stays open.
#pragma once

#include <cstddef>
#include <cstdint>

#include "magicmass/batch/blocks.hpp"
#include "magicmass/batch/counts.hpp"
#include "magicmass/batch/one_by_one.hpp"
#include "magicmass/batch/open_rows.hpp"
#include "magicmass/kernels/terminal.hpp"
#include "magicmass/kernels/terminal_in_rows.hpp"

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

template <class Number>
void terminal_block_by_block(const double* alpha, std::int64_t* N_A, std::int64_t* N_B, double* a_t,
                             double* b_t, double* c_t, std::size_t size) {
  block_by_block(
      size,
      [](std::size_t, std::size_t rows, const double* of_alpha, std::int64_t* of_N_A,
         std::int64_t* of_N_B, double* of_a, double* of_b, double* of_c) {
        count_block(rows, of_alpha, of_N_A, of_N_B);
        alignas(64) arithmetic::BlockOfDoubles cycles;
        alignas(64) arithmetic::BlockOfDoubles turns;
        RowBits outside{};
        for (std::size_t i = 0; i < rows; i += arithmetic::widest) {
          const RowBits A = load_bits(of_N_A + i);
          outside |= out_of_domain(load_bits(of_alpha + i));
          arithmetic::store(as_doubles(A), &cycles[i]);
          // 1 after a Q, -1 after a P
          const RowBits is_P = load_bits(of_N_B + i) - A;
          arithmetic::store(
              Row(std::bit_cast<Row::Doubles>((is_P & std::numeric_limits<std::int64_t>::min()) |
                                              std::bit_cast<std::int64_t>(1.0))),
              &turns[i]);
        }
        const bool is_any_outside = has_negative(outside);
        arithmetic::Certainty<Number> certain;
        if constexpr (rounds_results<Number>)
          generated::terminal_in_rows_block<Number>(rows, of_alpha, cycles.data(), turns.data(),
                                                    of_a, of_b, of_c);
        else
          generated::terminal_block<Number>(rows, of_alpha, cycles.data(), turns.data(), of_a, of_b,
                                            of_c, nullptr, certain);
        if (!is_any_outside && certain.is_all(rows)) return;
        for (std::size_t i = 0; i < rows; ++i) {
          if (is_in_domain(of_alpha[i]) && !is_open(certain, i)) continue;
          const auto one = rounding_is_tested<Number> ? accurate_terminal(of_alpha[i])
                                                      : fast_terminal(of_alpha[i]);
          of_a[i] = one.a_t;
          of_b[i] = one.b_t;
          of_c[i] = one.c_t;
        }
      },
      alpha, N_A, N_B, a_t, b_t, c_t);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::batch
