// SPDX-License-Identifier: MIT
// Exact counts by the block. With q = pi/h and cos h = 1/(1+alpha) the total is ceil(q) - 1, and q = P(alpha)/sqrt(alpha) with
// P analytic for alpha > -1. Single precision decides nearly all; a group of rows that it leaves open is done again in double
// precision, and a row that this leaves open by the exact function for one alpha.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "magicmass/batch/blocks.hpp"
#include "magicmass/batch/count_polynomials.hpp"
#include "magicmass/batch/decision_lanes.hpp"
#include "magicmass/batch/exact_count.hpp"

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

/// False if a row was left open; then nothing written counts.
[[gnu::always_inline]] inline bool count_in_singles(std::size_t rows, const double* alpha,
                                                    std::int64_t* N_A, std::int64_t* N_B) {
  // Taken off a double's bits, this leaves the bits of a float above 29 others, and zeros above, for 2^-127 <= alpha < 2^129 and no other:
  // all that is negative, smaller, larger, infinite or not a number has one of the upper four bits set.
  constexpr std::uint64_t bias = std::uint64_t{1023 - 127} << 52U;
  constexpr std::uint64_t above_single = ~std::uint64_t{0} << 60U;
  // Relative errors of q in units of 2^-24, without fused operations (with them in brackets): cutting alpha off 0 to 1; the root
  // by Newton's step from r (1 + root_guess_error): -3.4 to 0 (-0.1 to 0), its roundings 2 (1.5); P 2.4 (2.1), of which the
  // minimax error is 0.6; two products 2. In all -9.8 to 7.4 (-5.7 to 6.6). The coefficients contain a factor 1 - 7.5, so
  // that q below is less than pi/h, and q times `widening`, whose rounding costs 1, is more.
  constexpr float widening = root_guess_error < 0x1p-13 ? 1 + 16 * 0x1p-24F : 1 + 20 * 0x1p-24F;
  Longs outside{};
  Words open{};
  for (std::size_t i = 0; i < rows; i += 2 * arithmetic::widest) {
    const Longs first = load_longs(alpha + i) - bias;
    const Longs second = load_longs(alpha + i + arithmetic::widest) - bias;
    outside |= first | second;
    // From 1 on the total is 2. The bits of what is outside do no harm: no operation here traps.
    const Singles x = smaller((Singles)interleaved(first >> 29U, second << 3U), all(highest_alpha));
    const Singles root = root_guess(x);
    const Singles newton = subtract_product(all(3.0F), x * root, root);
    Singles p = all(single_coefficients[7]);
    for (int k = 6; k >= 0; --k) p = multiply_add(p, x, all(single_coefficients[k]));
    const Words total = whole_part((root * p) * newton, widening, open);
    const Words half = total >> 1U;
    const Longs of_A = (Longs)(total - half);
    const Longs of_B = (Longs)half;
    store_longs(of_A & 0xffffffff, N_A + i);
    store_longs(of_A >> 32U, N_A + i + arithmetic::widest);
    store_longs(of_B & 0xffffffff, N_B + i);
    store_longs(of_B >> 32U, N_B + i + arithmetic::widest);
  }
  return !has_bits((outside & above_single) | (Longs)open);
}

/// Writes -1 for a row left open.
[[gnu::always_inline]] inline void count_in_doubles(std::size_t rows, const double* alpha,
                                                    std::int64_t* N_A, std::int64_t* N_B) {
  using T = Doubles;
  for (std::size_t i = 0; i < rows; i += arithmetic::widest) {
    const T given = arithmetic::load<T>(alpha + i);
    const T x = select(given < T(highest_alpha), given, T(highest_alpha));
    T root = root_guess(x);
    if constexpr (double_root_guess_error > 0x1p-20) {  // Newton's step: within 3/2 2^-28
      root = root * subtract_product(T(1.5), (T(0.5) * x) * root, root);
    }
    T p(double_coefficients[16]);
    for (int k = 15; k >= 0; --k) p = multiply_add(p, x, T(double_coefficients[k]));
    // 1/sqrt(x) = root (1 - e)^(-1/2) = root (1 + e/2 + 3/8 e^2 + 5/16 e^3 + ...), |e| <= 2^-21.
    // In units of 2^-53: the minimax error 7, Horner's scheme 3, the series 1, e 1.5, products and sums 3; less than 2^-49.
    const T e = subtract_product(T(1.0), x * root, root);
    const T before = root * p;
    const T q = multiply_add(before, e * multiply_add(T(0.375), e, T(0.5)), before);
    const T nearest = arithmetic::nearest_whole(q);
    const T::Mask decided = (magnitude(q - nearest) > T(0x1p-48) * q) & (given >= T(0x1p-90)) &
                            (given <= T(0x1.fffffffffffffp+1023));
    const T total = nearest - where(nearest > q, T(1.0));  // q is below 2^47
    const Longs whole =
        std::bit_cast<Longs>((total + T(0x1p52)).v) - std::bit_cast<std::uint64_t>(0x1p52);
    const Longs half = whole >> 1U;
    store_longs((whole - half) | ~(Longs)decided, N_A + i);
    store_longs(half | ~(Longs)decided, N_B + i);
  }
}

/// Exact in every row.
inline void count_with_care(std::size_t rows, const double* alpha, std::int64_t* N_A,
                            std::int64_t* N_B) {
  count_in_doubles(rows, alpha, N_A, N_B);
  for (std::size_t i = 0; i < rows; ++i) {
    if (N_A[i] < 0) count_exactly(alpha[i], N_A + i, N_B + i);
  }
}

/// One block: rows a multiple of group_rows.
inline void count_block(std::size_t rows, const double* alpha, std::int64_t* N_A,
                        std::int64_t* N_B) {
  // Everyday blocks are decided at once, but for one in thirty; far down, and past its range, single
  // precision decides nothing, which the first row foretells.
  const bool is_single = alpha[0] >= 0x1p-28 && alpha[0] <= 0x1p100;
  if (!is_single) return count_with_care(rows, alpha, N_A, N_B);
  if (count_in_singles(rows, alpha, N_A, N_B)) return;
  for (std::size_t i = 0; i < rows; i += group_rows) {
    if (count_in_singles(group_rows, alpha + i, N_A + i, N_B + i)) continue;
    count_with_care(group_rows, alpha + i, N_A + i, N_B + i);
  }
}

inline void count_block_by_block(const double* alpha, std::int64_t* N_A, std::int64_t* N_B,
                                 std::size_t size) {
  block_by_block(
      size,
      [](std::size_t, std::size_t rows, const double* of_alpha, std::int64_t* of_N_A,
         std::int64_t* of_N_B) { count_block(rows, of_alpha, of_N_A, of_N_B); },
      alpha, N_A, N_B);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::batch
