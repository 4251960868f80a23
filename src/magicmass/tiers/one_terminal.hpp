// SPDX-License-Identifier: MIT
// The last velocities of one alpha as tier `fast` gives them, and its count.
#pragma once

#include <cmath>
#include <cstdint>

#include "magicmass/arithmetic/bounded.hpp"
#include "magicmass/arithmetic/pair.hpp"
#include "magicmass/arithmetic/tabled.hpp"
#include "magicmass/arithmetic/tracked.hpp"
#include "magicmass/kernels/angle.hpp"
#include "magicmass/kernels/terminal.hpp"
#include "magicmass/kernels/terminal_below_one.hpp"
#include "magicmass/terminal.hpp"
#include "magicmass/tiers/clear_count.hpp"
#include "magicmass/tiers/count_from_angle.hpp"
#include "magicmass/tiers/two_stages.hpp"

namespace magicmass::tiers {
inline namespace MAGICMASS_TARGET {

/// Where the numbers of an alpha are usual ones, and how those below are.
inline constexpr double least_usual = 0x1p-120;
using Usual = arithmetic::Tabled<double, arithmetic::Alphas::usual>;
using Vanishing = arithmetic::Tabled<double, arithmetic::Alphas::vanishing>;

/// Of h/2 for an alpha below 1: the arctangent's with t^2 < alpha/2, and what the root and the product before it leave out.
[[gnu::always_inline]] inline double relative_error_of_angle(double alpha) {
  return arithmetic::smaller(0x1p-51 * alpha, 0x1p-60) + 0x1p-95;
}

/// In place, as a double that is stored alone and loaded beside another is waited for.
[[gnu::always_inline]] inline void put(const generated::TerminalValues<double>& velocities,
                                       magicmass::Terminal& result) {
  result.a_t = velocities.a_t;
  result.b_t = velocities.b_t;
  result.c_t = velocities.c_t;
  result.rho = velocities.rho;
}

/// Next to a threshold, where the tables do not tell; tan(psi/4) within 2^-90.
[[gnu::noinline]] inline std::int64_t total_of_closest(TurnsToPi turns, double alpha,
                                                       arithmetic::Pair<double> tangent) {
  const auto quarter_psi = arctangent(arithmetic::Tracked<double>(tangent, tangent.high)).pair;
  const std::int64_t total = total_from_angle(turns, quarter_psi, 0x1p-83);
  if (total != 0) [[likely]]
    return total;
  const auto psi = generated::AngleKernel<arithmetic::Bounded<double>>::evaluate(alpha);
  return total_from_angle(turns, scaled(psi.pair, 0.25), psi.error / psi.pair.high + 0x1p-100);
}

/// What N_A cycles leave of a quarter turn.
struct Offset {
  double turn;   ///< to the quarter turn: negative where the last collision is a P, N_B = N_A - 1
  double slack;  ///< how much less than psi/4 it is: negative where N_A is another (offset.at_most)

  /// Whether N_A is right and the sign of `turn` known, where both are known within `unsure`.
  [[gnu::always_inline]] bool tells(double unsure) const {
    return arithmetic::magnitude(turn) > unsure && slack > unsure;
  }
};
template <class Number>
[[gnu::always_inline]] inline Offset offset_of(typename Number::ArcTangent quarter_psi,
                                               double N_A) {
  const arithmetic::Pair<double> left =
      (scaled(Number::pi(), 0.5) - quarter_psi * (2.0 * N_A)).pair;
  return {.turn = left.high + left.low,
          .slack = (quarter_psi.pair.high - arithmetic::magnitude(left.high)) +
                   (quarter_psi.pair.low - arithmetic::times_sign_of(left.low, left.high))};
}

/// By the total, or where that is 0 by the offset.
[[gnu::always_inline]] inline Counts counts_of(Offset offset, std::int64_t N_A,
                                               std::int64_t total) {
  if (total != 0) [[unlikely]]
    return {(total + 1) >> 1, total >> 1};
  return {N_A, N_A - (offset.turn < 0.0)};
}

/// alpha from 2^-90 to 1: N_A is below 2^45, and whatever the table says of it within 1.
[[gnu::always_inline]] inline bool usual_terminal(double alpha, magicmass::Terminal& result) {
  generated::TerminalBelowOneKernel<Usual> kernel;
  kernel.alpha = alpha;
  const TurnsToPi turns = turns_to_pi(alpha);
  kernel.stage_1();
  kernel.stage_2();
  kernel.N_A = arithmetic::nearest_whole(turns.cycles);
  Offset offset = offset_of<Usual>(kernel.angle, kernel.N_A);
  std::int64_t total = 0;
  // far from both thresholds no more is asked
  const double size = arithmetic::magnitude(offset.turn), part = 0x1p-16 * kernel.angle.pair.high;
  if (!(size > part && size + part < kernel.angle.pair.high)) [[unlikely]] {
    const double unsure = 2.0 * relative_error_of_angle(alpha);
    if (offset.slack < -unsure) {  // the quotient was next to the one above or below
      kernel.N_A += std::copysign(1.0, offset.turn);
      offset = offset_of<Usual>(kernel.angle, kernel.N_A);
    }
    // the velocities of both sides are the same numbers there, and do not wait
    if (!offset.tells(unsure)) [[unlikely]] {
      total = total_of_closest(turns, alpha, kernel.tan_quarter.pair);
      if (total == 0) return false;
    }
  }
  result.counts = counts_of(offset, static_cast<std::int64_t>(kernel.N_A), total);
  kernel.stage_3();
  put(kernel.rounded_result(), result);
  return true;
}

/// Of psi/4 of a vanishing alpha: the root of alpha/2 leaves out half an alpha.
inline constexpr double relative_error_of_vanishing = 0x1p-90;

/// Below 2^-90, where N_A may need two doubles.
[[gnu::noinline]] inline bool vanishing_terminal(double alpha, magicmass::Terminal& result) {
  generated::TerminalBelowOneKernel<Vanishing> kernel;
  kernel.alpha = alpha;
  kernel.stage_1();
  kernel.stage_2();
  const auto angle = kernel.angle;
  // pi/(2 h) of the angle h/2, whose square is alpha/2: within 2^-51 of itself
  const double cycles = (0x1.921fb54442d18p-1 * angle.pair.high) * (1.0 / (0.5 * alpha));
  if (!(cycles < 0x1p62)) return false;
  // from 2^51 on what is whole, and as near as the quotient itself is known
  kernel.N_A = arithmetic::nearest_whole(cycles);
  // What that is off by, a 2^-51st of itself, are further cycles of h each, 1/h being (2/pi) cycles. N_A times an angle larger by
  // further/N_A of itself has them, 1/N_A being (4/pi) psi/4.
  constexpr double two_per_pi = 0x1.45f306dc9c883p-1;
  const double further = arithmetic::nearest_whole(offset_of<Vanishing>(angle, kernel.N_A).turn *
                                                   (two_per_pi * cycles));
  kernel.angle.pair.low += further * ((2.0 * two_per_pi * angle.pair.high) * angle.pair.high);
  const Offset offset = offset_of<Vanishing>(kernel.angle, kernel.N_A);
  std::int64_t total = 0;
  if (!offset.tells(2.0 * relative_error_of_vanishing)) [[unlikely]] {
    total = total_of_closest({2.0 * cycles, 0x1p-50}, alpha, angle.pair);
    if (total == 0) return false;
  }
  const auto N_A = static_cast<std::int64_t>(kernel.N_A) + static_cast<std::int64_t>(further);
  result.counts = counts_of(offset, N_A, total);
  kernel.stage_3();
  put(kernel.rounded_result(), result);
  return true;
}

/// alpha from 2^-900 to 2^960. False where the tables' numbers do not tell the count, or it is 2^63 or more.
inline bool fast_terminal(double alpha, magicmass::Terminal& result) {
  if (alpha >= 1.0) {
    generated::TerminalKernel<arithmetic::Tabled<double>> kernel;
    kernel.alpha = alpha;
    result.counts = {1, 1};
    kernel.first();
    auto velocities = kernel.rounded_result();
    // a pair's square so small has a low part that is no double, and depends on how it is computed (theorem offset.rho)
    if (velocities.rho < 0x1p-960) [[unlikely]]
      velocities.rho = velocities.b_t * velocities.b_t;
    put(velocities, result);
    return true;
  }
  if (alpha < 0x1p-90) [[unlikely]]
    return vanishing_terminal(alpha, result);
  return usual_terminal(alpha, result);
}

/// The number of collisions of an alpha from 2^-900 to 1; 0 where that is not told.
inline std::int64_t total_below_1(double alpha) {
  const TurnsToPi turns = turns_to_pi(alpha);
  if (alpha < least_usual) {
    const Vanishing tangent = Vanishing::half_arcsecant_tangent(alpha);
    return total_from_angle(turns, tangent.pair, relative_error_of_vanishing);
  }
  const Usual tangent = Usual::half_arcsecant_tangent(alpha);
  const auto quarter_psi = half_arcsecant(alpha, tangent).pair;
  const std::int64_t total = total_from_angle(turns, quarter_psi, relative_error_of_angle(alpha));
  return total != 0 ? total : total_of_closest(turns, alpha, tangent.pair);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::tiers
