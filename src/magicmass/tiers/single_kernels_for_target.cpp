// SPDX-License-Identifier: MIT
// Compiled once for each instruction set.
#include <algorithm>
#include <cmath>

#include "magicmass/angle_product.hpp"
#include "magicmass/arithmetic/bounded.hpp"
#include "magicmass/arithmetic/pair.hpp"
#include "magicmass/arithmetic/rooted.hpp"
#include "magicmass/arithmetic/tabled.hpp"
#include "magicmass/arithmetic/tracked.hpp"
#include "magicmass/kernels/angle.hpp"
#include "magicmass/kernels/encounters.hpp"
#include "magicmass/kernels/ratios.hpp"
#include "magicmass/kernels/ratios_of_parts.hpp"
#include "magicmass/kernels/terminal.hpp"
#include "magicmass/kernels/velocities.hpp"
#include "magicmass/terminal.hpp"
#include "magicmass/tiers/one_terminal.hpp"
#include "magicmass/tiers/single_kernels.hpp"
#include "magicmass/tiers/two_stages.hpp"

namespace magicmass::tiers {
namespace {

using arithmetic::Bounded;
using arithmetic::OfArcsecant;
using arithmetic::Pair;
using arithmetic::Tabled;
using arithmetic::Tracked;
using arithmetic::Whole;
using generated::AngleKernel;
using generated::Encounters;
using generated::EncountersKernel;
using generated::Ratios;
using generated::RatiosKernel;
using generated::RatiosOfPartsKernel;
using generated::TerminalKernel;
using generated::TerminalValues;
using generated::Velocities;
using generated::VelocitiesKernel;

/// Up to the sine and cosine. An index beyond 2^53 has a low part, a fraction of at most 2^-53, which goes into the angle that it
/// multiplies.
template <class Kernel>
[[gnu::always_inline]] inline void turn(Kernel& kernel, double index, double low) {
  kernel.stage_1();
  kernel.stage_2();
  if (low != 0.0) [[unlikely]]
    kernel.angle.pair.low += kernel.angle.pair.high * (low / index);
  kernel.stage_3();
}

template <class Number>
[[gnu::always_inline]] inline Velocities<double> velocities_of(double alpha, double n,
                                                               double n_low) {
  VelocitiesKernel<Number> kernel;
  kernel.alpha = alpha;
  kernel.n = n;
  turn(kernel, n, n_low);
  return nearest(kernel.result());
}
Velocities<double> fast_velocities(double alpha, double n, double n_low) {
  if (alpha >= 1.0) {
    VelocitiesKernel<Tabled<double>> kernel;
    kernel.alpha = alpha;
    kernel.n = n;
    kernel.first();
    return nearest(kernel.result());
  }
  if (alpha >= least_usual) [[likely]]
    return velocities_of<Usual>(alpha, n, n_low);
  return velocities_of<Vanishing>(alpha, n, n_low);
}

/// The tables' sine is as good from here to pi as before, and beyond of the right sign: where s is not positive j is no collision.
constexpr double largest_turn = 3.145;

/// Next to a threshold, where s of the last collision is larger than the tables' numbers tell.
[[gnu::noinline]] Encounters<double> last_encounters(double alpha, double j) {
  constexpr Encounters<double> unknown{-HUGE_VAL, -HUGE_VAL};
  if (!(j < 0x1p51)) return unknown;
  const auto first = EncountersKernel<Tracked<double>>::evaluate(alpha, j);
  if (first.s.size < HUGE_VAL) return nearest(first);
  const auto second = EncountersKernel<Bounded<double>>::evaluate(alpha, j);
  return second.s.error < HUGE_VAL ? nearest(second) : unknown;
}

template <class Number>
[[gnu::always_inline]] inline Encounters<double> encounters_of(double alpha, double j, double j_low,
                                                               double relative_error) {
  EncountersKernel<Number> kernel;
  kernel.alpha = alpha;
  kernel.j = j;
  turn(kernel, j, j_low);
  const auto result = kernel.rounded_result();
  // The angle's relative error, and twice that of the rest, times j is the error of 1/s = sin((j+1)h)/sin h, but for a
  // factor of 2: rounding alpha alone would cost 2^5 times as much. Its sign is what has to be certain.
  if (kernel.angle.pair.high * (2.0 * j) < largest_turn && result.s > 0.0 &&
      (result.s * j) * relative_error < 0.125) [[likely]]
    return result;
  return last_encounters(alpha, j);
}
/// Below this t and s do not depend on alpha, but for less than 2^-270.
constexpr double least_of_encounters = 0x1p-400;

Encounters<double> fast_encounters(double alpha, double j, double j_low) {
  if (alpha >= least_usual) [[likely]]
    return encounters_of<Usual>(alpha, j, j_low, relative_error_of_angle(alpha));
  return encounters_of<Vanishing>(std::max(alpha, least_of_encounters), j, j_low,
                                  relative_error_of_vanishing);
}

/// Up to here 2 k + 2 is a Whole.
constexpr double largest_short_k = 0x1p24;

template <class Number>
[[gnu::always_inline]] inline Ratios<Pair<double>> ratios_of_parts(Number k) {
  const auto ratios = RatiosOfPartsKernel<Number>::evaluate(k);
  return {ratios.magic.pair, ratios.deficient.pair};
}
Ratios<double> fast_ratios(double k, double k_low) {
  if (k <= largest_short_k) [[likely]]
    return nearest(ratios_of_parts(Whole(k)));
  return nearest(ratios_of_parts(Tabled<double>(Pair<double>(k, k_low))));
}

bool velocities(double alpha, double n, Velocities<double>& result) {
  return in_two_stages<VelocitiesKernel>(result, alpha, n);
}
bool encounters(double alpha, double j, Encounters<double>& result) {
  return in_two_stages<EncountersKernel>(result, alpha, j);
}
double fast_angle(double alpha) {
  if (alpha < 1.0) return AngleKernel<OfArcsecant>::evaluate(alpha).value;
  // the form without a product that might overflow
  return generated::angle_product(arithmetic::Rooted(alpha)).value;
}
bool angle(double alpha, double& result) {
  const auto first = AngleKernel<Tabled<double>>::evaluate(alpha);
  result = nearest(first);
  // the arctangent's bound, and what the root and the product before it leave out
  if (certainly_rounded(first.pair, 0x1p-60)) [[likely]]
    return true;
  return in_two_stages<AngleKernel>(result, alpha);
}
template <class Number>
[[gnu::always_inline]] inline bool nearest_ratios(Number k, Ratios<double>& result) {
  const auto first = ratios_of_parts(k);
  result = nearest(first);
  // the secants' bound, with 1/m^2 below 1/4 k^-2
  const double relative_error = 0x1p-54 / (k.pair.high * k.pair.high) + 0x1p-98;
  return certainly_rounded(normalised(first.magic), relative_error) &&
         certainly_rounded(normalised(first.deficient), relative_error);
}
bool ratios(double k, Ratios<double>& result) {
  if (k <= largest_short_k ? nearest_ratios(Whole(k), result)
                           : nearest_ratios(Tabled<double>(k), result)) [[likely]]
    return true;
  return in_two_stages<RatiosKernel>(result, k);
}
bool terminal(double alpha, double N_A, double turn, TerminalValues<double>& result) {
  return in_two_stages<TerminalKernel>(result, alpha, N_A, turn);
}
bool terminal_in_second_stage(double alpha, double N_A, double turn,
                              TerminalValues<double>& result) {
  return in_second_stage<TerminalKernel>(result, alpha, N_A, turn);
}

}  // namespace

const SingleKernels tables::MAGICMASS_TARGET = {
    .fast_velocities = fast_velocities,
    .fast_encounters = fast_encounters,
    .fast_angle = fast_angle,
    .fast_ratios = fast_ratios,
    .fast_terminal = fast_terminal,
    .total = total_below_1,
    .velocities = velocities,
    .encounters = encounters,
    .angle = angle,
    .ratios = ratios,
    .terminal = terminal,
    .terminal_in_second_stage = terminal_in_second_stage,
};

}  // namespace magicmass::tiers
