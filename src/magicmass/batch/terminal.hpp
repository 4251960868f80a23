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

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

template <class Number>
void terminal_block_by_block(const double* alpha, std::int64_t* N_A, std::int64_t* N_B, double* a_t,
                             double* b_t, double* c_t, std::size_t size) {
  block_by_block(
      size,
      [](std::size_t rows, const double* of_alpha, std::int64_t* of_N_A, std::int64_t* of_N_B,
         double* of_a, double* of_b, double* of_c) {
        count_block(rows, of_alpha, of_N_A, of_N_B);
        alignas(64) arithmetic::BlockOfDoubles cycles;
        alignas(64) arithmetic::BlockOfDoubles turns;
        OpenRows open;
        for (std::size_t i = 0; i < rows; i += arithmetic::widest) {
          const Row x = arithmetic::load<Row>(of_alpha + i);
          const Row A = above_2_52(of_N_A + i);
          const Row B = above_2_52(of_N_B + i);
          const Row of_cycle = A - Row(0x1p52);
          arithmetic::store(of_cycle, &cycles[i]);
          arithmetic::store(Row(1.0) - Row(2.0) * (A - B), &turns[i]);  // 1 after a Q, -1 after a P
          open.put(i, (x >= Row(0x1p-120)) & (x <= Row(0x1p60)) & (A >= Row(0x1p52)) &
                          (of_cycle <= Row(0x1p51)));
        }
        arithmetic::Certainty<Number> certain;
        generated::terminal_block<Number>(rows, of_alpha, cycles.data(), turns.data(), of_a, of_b,
                                          of_c, nullptr, certain);
        if (!open.any && certain.is_all(rows)) return;
        for (std::size_t i = 0; i < rows; ++i) {
          if (!open.is_open(i, certain)) continue;
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
