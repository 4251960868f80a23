// SPDX-License-Identifier: MIT
// Exact counts and terminal velocities by the block: the generated kernel where it is valid, the function for one input
// where it is not or where a rounding stays open.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "magicmass/batch/blocks.hpp"
#include "magicmass/batch/counts.hpp"
#include "magicmass/batch/counts_from_angles.hpp"
#include "magicmass/batch/one_by_one.hpp"
#include "magicmass/batch/open_rows.hpp"
#include "magicmass/batch/terminal_from_one.hpp"
#include "magicmass/kernels/terminal.hpp"
#include "magicmass/kernels/terminal_in_rows.hpp"

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

/// N_A, and where asked for 1 after a Q, -1 after a P.
template <class... Turns>
void to_doubles(std::size_t rows, const std::int64_t* N_A, const std::int64_t* N_B, double* cycles,
                Turns*... turns) {
  for (std::size_t i = 0; i < rows; ++i) {
    cycles[i] = static_cast<double>(N_A[i]);
    ((turns[i] = N_A[i] == N_B[i] ? 1.0 : -1.0), ...);
  }
}

/// One cycle in each row. False if a row is out of the kernels' domain.
inline bool count_from_one(std::size_t rows, const double* alpha, std::int64_t* N_A,
                           std::int64_t* N_B) {
  RowBits outside{};
  for (std::size_t i = 0; i < rows; i += arithmetic::widest)
    outside |= out_of_domain(load_bits(alpha + i));
  std::fill_n(N_A, rows, 1);
  std::fill_n(N_B, rows, 1);
  return !has_negative(outside);
}

/// Rows out of the kernels' domain may get anything.
inline void count_in_domain(std::size_t rows, const double* alpha, std::int64_t* N_A,
                            std::int64_t* N_B) {
  if (std::all_of(alpha, alpha + rows, [](double x) { return is_in_domain(x); }))
    return count_block(rows, alpha, N_A, N_B);
  for (std::size_t i = 0; i < rows; ++i) {
    N_A[i] = N_B[i] = 1;
    if (is_in_domain(alpha[i])) count_exactly(alpha[i], N_A + i, N_B + i);
  }
}

template <class Number>
void terminal_block_by_block(const double* alpha, std::int64_t* N_A, std::int64_t* N_B, double* a_t,
                             double* b_t, double* c_t, std::size_t size) {
  block_by_block(
      size,
      [](std::size_t, std::size_t rows, const double* of_alpha, std::int64_t* of_N_A,
         std::int64_t* of_N_B, double* of_a, double* of_b, double* of_c) {
        const auto put = [&](std::size_t i, const Terminal& one) {
          of_N_A[i] = one.counts.N_A;
          of_N_B[i] = one.counts.N_B;
          of_a[i] = one.a_t;
          of_b[i] = one.b_t;
          of_c[i] = one.c_t;
        };
        const auto one_row = [&](std::size_t i) {
          put(i, rounding_is_tested<Number> ? accurate_terminal(of_alpha[i])
                                            : fast_terminal(of_alpha[i]));
        };
        // where the kernels decide nothing; a row among others that they know is as it would be among these
        if (std::none_of(of_alpha, of_alpha + rows, [](double x) { return is_in_domain(x); })) {
          for (std::size_t i = 0; i < rows; ++i) one_row(i);
          return;
        }
        bool is_decided = true;
        const auto count = [&](const auto& angles, double* cycles, auto*... turns) {
          is_decided = count_from_angles(rows, of_alpha, angles, of_N_A, of_N_B, cycles, turns...);
          if (is_decided) return;
          count_in_domain(rows, of_alpha, of_N_A, of_N_B);
          to_doubles(rows, of_N_A, of_N_B, cycles, turns...);
        };
        arithmetic::Certainty<Number> certain;
        if constexpr (rounds_results<Number>) {
          const RowsFromOne from_one(rows, of_alpha);
          if (from_one.count() == rows)
            is_decided = count_from_one(rows, of_alpha, of_N_A, of_N_B);
          else
            generated::terminal_in_rows_block<Number>(rows, of_alpha, count, of_a, of_b, of_c);
          from_one.write(of_a, of_b, of_c);
        } else {
          generated::terminal_block<Number>(rows, of_alpha, count, of_a, of_b, of_c, nullptr,
                                            certain);
        }
        for_open_rows(
            rows, certain, !is_decided, [&](std::size_t i) { return !is_in_domain(of_alpha[i]); },
            [&](std::size_t i) {
              if (is_in_domain(of_alpha[i]))
                put(i, open_terminal(of_alpha[i], {of_N_A[i], of_N_B[i]}));
              else
                one_row(i);
            });
      },
      alpha, N_A, N_B, a_t, b_t, c_t);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::batch
