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
#include "magicmass/kernels/velocities_at_1.hpp"
#include "magicmass/kernels/velocities_at_2.hpp"
#include "magicmass/kernels/velocities_in_rows.hpp"

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

/// The columns of one block.
struct VelocityRows {
  double* a;
  double* b;
  double* c;
  double* c_prime;

  template <class Number>
  void set(std::size_t i, double alpha, std::int64_t n) const {
    const auto one =
        rounding_is_tested<Number> ? accurate_velocities(alpha, n) : fast_velocities(alpha, n);
    a[i] = one.a;
    b[i] = one.b;
    c[i] = one.c;
    c_prime[i] = one.c_prime;
  }
};

/// The kernels may take any alpha where n = 0, but only n = 1 from alpha = 1 on.
inline constexpr double ratio_at_0 = 0.5;

/// Numbers that round their results have a kernel of sums, others one of products.
template <class Number, class Certain>
[[gnu::always_inline]] inline void velocities_of_block(std::size_t rows, const double* alpha,
                                                       const double* n, const VelocityRows& result,
                                                       Certain& certain) {
  const auto& [a, b, c, c_prime] = result;
  if constexpr (rounds_results<Number>)
    generated::velocities_in_rows_block<Number>(rows, alpha, n, a, b, c, c_prime);
  else
    generated::velocities_block<Number>(rows, alpha, n, a, b, c, c_prime, certain);
}

template <class Number>
void velocities_block_by_block(const double* alpha, const std::int64_t* n, double* a, double* b,
                               double* c, double* c_prime, std::size_t size) {
  block_by_block(
      size,
      [](std::size_t, std::size_t rows, const double* of_alpha, const std::int64_t* of_n,
         double* of_a, double* of_b, double* of_c, double* of_c_prime) {
        alignas(64) arithmetic::BlockOfDoubles index;
        alignas(64) arithmetic::BlockOfDoubles ratios;
        OutOfDomain outside;
        for (std::size_t i = 0; i < rows; i += arithmetic::widest) {
          const RowBits n_ = load_bits(of_n + i);
          const Row ratio = arithmetic::load<Row>(of_alpha + i);
          outside.see(std::bit_cast<RowBits>(ratio.v), n_);
          const Row of_n_ = as_doubles(n_);
          arithmetic::store(of_n_, &index[i]);
          // before the first collision alpha does not matter
          arithmetic::store(select(of_n_ > Row(0.0), ratio, Row(ratio_at_0)), &ratios[i]);
        }
        const bool is_any_outside = outside.is_any();
        arithmetic::Certainty<Number> certain;
        const VelocityRows result{of_a, of_b, of_c, of_c_prime};
        velocities_of_block<Number>(rows, ratios.data(), index.data(), result, certain);
        for_open_rows(
            rows, certain, is_any_outside,
            [&](std::size_t i) { return !is_in_domain(of_alpha[i], of_n[i]); },
            [&](std::size_t i) { result.set<Number>(i, of_alpha[i], of_n[i]); });
      },
      alpha, n, a, b, c, c_prime);
}

/// The same n for all rows: in the first two cycles a rational function of alpha is cheaper than angles, in the third no more.
/// Few is the number type of the rational functions.
template <class Number, class Few = Number>
void velocities_at_n_block_by_block(const double* alpha, std::int64_t n, double* a, double* b,
                                    double* c, double* c_prime, std::size_t size) {
  alignas(64) arithmetic::BlockOfDoubles index;
  alignas(64) arithmetic::BlockOfDoubles ratios_at_0;
  index.fill(static_cast<double>(n));
  ratios_at_0.fill(ratio_at_0);
  block_by_block(
      size,
      [&index, &ratios_at_0, n](std::size_t, std::size_t rows, const double* of_alpha, double* of_a,
                                double* of_b, double* of_c, double* of_c_prime) {
        OutOfDomain outside;
        for (std::size_t i = 0; i < rows; i += arithmetic::widest)
          outside.see(load_bits(of_alpha + i), RowBits{} + n);
        const bool is_any_outside = outside.is_any();
        arithmetic::Certainty<Few> certain;
        const VelocityRows result{of_a, of_b, of_c, of_c_prime};
        switch (n) {
          case 1:
            generated::velocities_at_1_block<Few>(rows, of_alpha, of_a, of_b, of_c, of_c_prime,
                                                  certain);
            break;
          case 2:
            generated::velocities_at_2_block<Few>(rows, of_alpha, of_a, of_b, of_c, of_c_prime,
                                                  certain);
            break;
          default:
            velocities_of_block<Number>(rows, n == 0 ? ratios_at_0.data() : of_alpha, index.data(),
                                        result, certain);
        }
        for_open_rows(
            rows, certain, is_any_outside,
            [&](std::size_t i) { return !is_in_domain(of_alpha[i], n); },
            [&](std::size_t i) { result.set<Number>(i, of_alpha[i], n); });
      },
      alpha, a, b, c, c_prime);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::batch
