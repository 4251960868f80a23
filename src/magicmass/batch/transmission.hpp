// SPDX-License-Identifier: MIT
// The energy that reaches B with restitution, by the block.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "magicmass/arithmetic/tracked.hpp"
#include "magicmass/batch/blocks.hpp"
#include "magicmass/batch/one_by_one.hpp"
#include "magicmass/batch/open_rows.hpp"
#include "magicmass/kernels/transmission.hpp"
#include "magicmass/kernels/two_collisions.hpp"

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

/// The root of e, and its powers 2^i: relative error 2^i 2^-103, where that matters at all no more than that of e itself.
struct RootPowers {
  static constexpr std::size_t count = 51;
  std::array<arithmetic::Pair<double>, count> of;

  explicit RootPowers(double e) {
    const double root = std::sqrt(e);
    of[0] = {root, arithmetic::product_error(root, root, e) / (-2.0 * root)};
    for (std::size_t i = 1; i < count; ++i) of[i] = of[i - 1] * of[i - 1];
  }
  arithmetic::Tracked<Row> in_lanes(std::size_t i) const {
    return {{Row(of[i].high), Row(of[i].low)}, Row(of[i].high)};
  }
};

/// root_e^N for whole numbers 0 <= N < 2^51.
[[gnu::always_inline]] inline arithmetic::Tracked<Row> power_of_root(const RootPowers& powers,
                                                                     Row N) {
  arithmetic::Tracked<Row> product(Row(1.0));
  Row left = N;
  for (std::size_t i = 0; i < RootPowers::count && has_negative(left > Row(0.0)); ++i) {
    const Row half = Row(0.5) * left;
    left = arithmetic::nearest_whole(half - Row(0.25));  // half, rounded down
    product = select(half > left, product * powers.in_lanes(i), product);
  }
  return product;
}

/// The number of collisions ceil(pi/h) - 1 with h = 2 angle, from `ratio`, pi/h in doubles. Where pi/h is whole for 2^-70 of itself the
/// choice is open, and of no consequence: the collision in question is at no relative velocity.
[[gnu::always_inline]] inline Row collisions(const arithmetic::Tracked<Row>& angle, Row ratio) {
  const Row nearest = arithmetic::nearest_whole(ratio);
  const auto above_nearest = scaled(arithmetic::Tracked<Row>::pi(), 0.5) - angle * nearest;
  return select(rounded(above_nearest) > Row(0.0), nearest, nearest - Row(1.0));
}

[[gnu::always_inline]] inline Row transmission_row(const RootPowers& powers, double e, Row alpha) {
  using Two = generated::TwoCollisionsKernel<arithmetic::Pair<Row>>;
  generated::TransmissionKernel<arithmetic::Tracked<Row>> kernel;
  kernel.alpha = alpha;
  kernel.root_e = powers.in_lanes(0);
  kernel.stage_1();
  kernel.stage_2();
  const Row ratio = Row(arithmetic::half_pi[0]) / kernel.angle.pair.high;
  kernel.N = collisions(kernel.angle, ratio);
  const Row half = Row(0.5) * kernel.N;
  kernel.is_odd = arithmetic::where(half > arithmetic::nearest_whole(half - Row(0.25)), Row(1.0));
  kernel.is_even = Row(1.0) - kernel.is_odd;
  kernel.decay = power_of_root(powers, kernel.N);
  kernel.stage_3();
  // Two: h may be all but pi/2, and the rest, of which a heavy ball leaves little, would lose its digits.
  const Row rho =
      select(kernel.N < Row(3.0), rounded(Two::evaluate(alpha, Row(e))), rounded(kernel.result()));
  return select(ratio < Row(0x1p51), rho, Row(NAN));
}

inline void transmission_block_by_block(const double* alpha, double e, double* rho,
                                        std::size_t size) {
  const RootPowers powers(e);
  block_by_block(
      size,
      [&powers, e](std::size_t, std::size_t rows, const double* of_alpha, double* of_rho) {
        for (std::size_t i = 0; i < rows; i += arithmetic::widest)
          arithmetic::store(transmission_row(powers, e, arithmetic::load<Row>(of_alpha + i)),
                            of_rho + i);
        for (std::size_t i = 0; i < rows; ++i)
          if (!(of_alpha[i] >= 0x1p-120 && of_alpha[i] <= 0x1p240) ||
              (e == 1.0 && of_rho[i] != of_rho[i]))
            of_rho[i] = transmission(of_alpha[i], e);
      },
      alpha, rho);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::batch
