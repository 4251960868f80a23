// SPDX-License-Identifier: MIT
// Magic and deficient ratios of consecutive k by the block: the generated kernel where it is valid, the function for one
// k where it is not or where a rounding stays open.
#pragma once

#include <cstddef>
#include <cstdint>

#include "magicmass/batch/blocks.hpp"
#include "magicmass/batch/one_by_one.hpp"
#include "magicmass/batch/open_rows.hpp"
#include "magicmass/kernels/ratios.hpp"

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

template <class Number>
void ratios_block_by_block(std::int64_t first_k, double* magic, double* deficient,
                           std::size_t size) {
  block_by_block(
      size,
      [first_k](std::size_t first, std::size_t rows, double* of_magic, double* of_deficient) {
        // wraps past the largest k to numbers below 1, which have no ratio
        const std::uint64_t next_k = static_cast<std::uint64_t>(first_k) + first;
        alignas(64) arithmetic::BlockOfDoubles index;
        const auto is_valid = [](double k) { return k >= 1.0 && k < 0x1p50; };
        for (std::size_t i = 0; i < rows; ++i) {
          index[i] = static_cast<double>(static_cast<std::int64_t>(next_k + i));
        }
        // consecutive, so all are valid if the ends are and nothing wraps in between
        const bool is_any_outside =
            !is_valid(index[0]) || !is_valid(index[rows - 1]) || index[rows - 1] < index[0];
        arithmetic::Certainty<Number> certain;
        generated::ratios_block<Number>(rows, index.data(), of_magic, of_deficient, certain);
        for_open_rows(
            rows, certain, is_any_outside, [&](std::size_t i) { return !is_valid(index[i]); },
            [&](std::size_t i) {
              const auto k = static_cast<std::int64_t>(next_k + i);
              const auto one = rounding_is_tested<Number> ? accurate_ratios(k) : fast_ratios(k);
              of_magic[i] = one.magic;
              of_deficient[i] = one.deficient;
            });
      },
      magic, deficient);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::batch
