// SPDX-License-Identifier: MIT
// Velocities by the block: the generated kernel where it is valid, the function for one input where it is not or where
// a rounding stays open.
#pragma once

#include <cstddef>
#include <cstdint>

#include "magicmass/batch/blocks.hpp"
#include "magicmass/batch/one_by_one.hpp"
#include "magicmass/batch/open_rows.hpp"
#include "magicmass/kernels/velocities.hpp"

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

/// The largest n of alpha that the kernel takes, and alpha's domain.
[[gnu::always_inline]] inline RowMask velocities_in_domain(Row alpha, Row n) {
  return (alpha >= Row(0x1p-120)) & (alpha <= Row(0x1p60)) & (n >= Row(0.0)) &
         (n <= arithmetic::select(alpha >= Row(1.0), Row(1.0), Row(0x1p51)));
}

template <class Number>
void velocities_block_by_block(const double* alpha, const std::int64_t* n, double* a, double* b,
                               double* c, double* c_prime, std::size_t size) {
  block_by_block(
      size,
      [](std::size_t rows, const double* of_alpha, const std::int64_t* of_n, double* of_a,
         double* of_b, double* of_c, double* of_c_prime) {
        alignas(64) arithmetic::BlockOfDoubles index;
        OpenRows open;
        for (std::size_t i = 0; i < rows; i += arithmetic::widest) {
          const Row shifted = above_2_52(of_n + i);
          const Row whole = shifted - Row(0x1p52);
          arithmetic::store(whole, &index[i]);
          open.put(i, velocities_in_domain(arithmetic::load<Row>(of_alpha + i), whole) &
                          (shifted >= Row(0x1p52)));
        }
        arithmetic::Certainty<Number> certain;
        generated::velocities_block<Number>(rows, of_alpha, index.data(), of_a, of_b, of_c,
                                            of_c_prime, certain);
        if (!open.any && certain.is_all(rows)) return;
        for (std::size_t i = 0; i < rows; ++i) {
          if (!open.is_open(i, certain)) continue;
          const auto one = rounding_is_tested<Number> ? accurate_velocities(of_alpha[i], of_n[i])
                                                      : fast_velocities(of_alpha[i], of_n[i]);
          of_a[i] = one.a;
          of_b[i] = one.b;
          of_c[i] = one.c;
          of_c_prime[i] = one.c_prime;
        }
      },
      alpha, n, a, b, c, c_prime);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::batch
