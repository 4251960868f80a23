// SPDX-License-Identifier: MIT
// Exact counts where a kernel has the angle anyway: h = psi/2 of cos h = 1/(1+alpha) is not computed for them.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "magicmass/batch/decision_lanes.hpp"
#include "magicmass/batch/open_rows.hpp"

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

/// N_A and N_B, and as doubles N_A and, where asked for, 1 after a Q, -1 after a P. False if a row is out of the kernels' domain or
/// was left open; then nothing written counts.
template <class Angles, class... Turns>
[[gnu::always_inline]] inline bool count_from_angles(std::size_t rows, const double* alpha,
                                                     const Angles& angles, std::int64_t* N_A,
                                                     std::int64_t* N_B, double* cycles,
                                                     Turns*... turns) {
  // |pi/2 - N_A h| is at most h/2 (offset.at_most): N_A is the whole number nearest to q = pi/(2 h), and the last collision is a Q if q
  // is above it. The angle h/2, the constant, the quotient and its rounding are off by 2^-52 and thrice 2^-53 of q: less than 2^-50. A q
  // below 2^46 that is further than 2^-48 q from all multiples of 1/2 is decided; of others `slack` is negative.
  constexpr double quarter_pi = 0x1.921fb54442d18p-1;
  // From alpha = 1 on there is one cycle, and it ends with a Q, as with this h/2.
  constexpr double of_two = 0.7;
  constexpr double shift = 0x1.8p52;
  const auto quotient = [&](std::size_t i) {
    const Row quarter_psi = select(arithmetic::load<Row>(alpha + i) >= Row(1.0), Row(of_two),
                                   angles.template rounded<Row>(i));
    return Row(quarter_pi) / quarter_psi;
  };
  RowBits open{};
  Row next = quotient(0);
  for (std::size_t i = 0; i < rows; i += arithmetic::widest) {
    const Row ratio = arithmetic::load<Row>(alpha + i);
    // while the next is divided, this one is looked at
    const Row q = next;
    next = quotient(std::min(i + arithmetic::widest, rows - arithmetic::widest));
    const Row shifted = q + Row(shift);
    const Row nearest = shifted - Row(shift);
    const Row past = q - nearest;
    const Row slack =
        subtract_product(Row(0.25), Row(0x1p-48), q) - magnitude(magnitude(past) - Row(0.25));
    open |= std::bit_cast<RowBits>(slack.v) | out_of_domain(std::bit_cast<RowBits>(ratio.v));
    const RowBits whole = std::bit_cast<RowBits>(shifted.v) - std::bit_cast<std::int64_t>(shift);
    const auto bits_past = std::bit_cast<Longs>(past.v);
    const RowBits less_if_P = whole - std::bit_cast<RowBits>(bits_past >> 63U);
    const Longs sign = bits_past & std::bit_cast<std::uint64_t>(-0.0);
    arithmetic::store(nearest, cycles + i);
    const Row turn(std::bit_cast<Row::Doubles>(sign | std::bit_cast<std::uint64_t>(1.0)));
    (arithmetic::store(turn, turns + i), ...);
    std::memcpy(N_A + i, &whole, sizeof whole);
    std::memcpy(N_B + i, &less_if_P, sizeof less_if_P);
  }
  return !has_negative(open);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::batch
