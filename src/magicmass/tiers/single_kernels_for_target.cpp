// SPDX-License-Identifier: MIT
// Compiled once for each instruction set.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <type_traits>

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
#include "magicmass/tiers/clear_count.hpp"
#include "magicmass/tiers/count_from_angle.hpp"
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

/// An index beyond 2^53: its low part, a fraction of at most 2^-53, goes into the angle that the index multiplies.
template <class Number>
Number with_low_part(Number angle, double low_over_high) {
  angle.pair.low += angle.pair.high * low_over_high;
  return angle;
}

/// Where the numbers of an alpha are usual ones.
constexpr double least_usual = 0x1p-120;
using Usual = Tabled<double, true>;

Velocities<double> fast_velocities(double alpha, double n, double n_low) {
  if (alpha >= least_usual && alpha < 1.0 && n_low == 0.0) [[likely]] {
    VelocitiesKernel<Usual> kernel;
    kernel.alpha = alpha;
    kernel.n = n;
    kernel.stage_1();
    kernel.stage_2();
    kernel.stage_3();
    return nearest(kernel.result());
  }
  using Kernel = VelocitiesKernel<Tabled<double>>;
  if (n_low == 0.0 || alpha >= 1.0) [[likely]]
    return nearest(Kernel::evaluate(alpha, n));
  Kernel kernel;
  kernel.alpha = alpha;
  kernel.n = n;
  kernel.stage_1();
  kernel.stage_2();
  kernel.angle = with_low_part(kernel.angle, n_low / n);
  kernel.stage_3();
  return nearest(kernel.result());
}

/// Below this the square of a tracked root, 1/alpha, is too large.
constexpr double least_tracked = 0x1p-900;

/// Of h/2 for an alpha below 1: the arctangent's with t^2 < alpha/2, and what the root and the product before it leave out.
double relative_error_of_angle(double alpha) {
  return std::min(0x1p-51 * alpha, 0x1p-60) + 0x1p-95;
}

/// The tables' sine and cosine go as far as this.
constexpr double largest_turn = 3.14;

/// The last collisions of many, from the angle on.
template <class Number>
[[gnu::noinline, gnu::cold]] Encounters<double> last_encounters(EncountersKernel<Number> kernel) {
  const double alpha = kernel.alpha, j = kernel.j;
  constexpr Encounters<double> unknown{-HUGE_VAL, -HUGE_VAL};
  if (kernel.angle.pair.high * (2.0 * j) > 3.15) return unknown;
  // sin x and cos x from pi - x, which is as good as x
  const auto turned = sine_cosine((Number::pi() - kernel.angle * (2.0 * j)) * 1.0);
  kernel.sine = turned.sine;
  kernel.cosine = -turned.cosine;
  // The angle's relative error, and twice that of the rest, times j is the error of 1/s = sin((j+1)h)/sin h, but for a
  // factor of 2: rounding alpha alone would cost 2^5 times as much. Its sign is what has to be certain.
  const auto last = kernel.rounded_result();
  if (last.s > 0.0 && (last.s * j) * relative_error_of_angle(alpha) < 0.125) return last;
  if (!(alpha >= least_tracked && j < 0x1p51)) return unknown;
  // next to a threshold
  const auto first = EncountersKernel<Tracked<double>>::evaluate(alpha, j);
  if (first.s.size < HUGE_VAL) return nearest(first);
  const auto second = EncountersKernel<Bounded<double>>::evaluate(alpha, j);
  return second.s.error < HUGE_VAL ? nearest(second) : unknown;
}

template <class Number>
[[gnu::always_inline]] inline Encounters<double> encounters_of(double alpha, double j,
                                                               double j_low) {
  EncountersKernel<Number> kernel;
  kernel.alpha = alpha;
  kernel.j = j;
  kernel.stage_1();
  kernel.stage_2();
  if (j_low != 0.0) [[unlikely]]
    kernel.angle = with_low_part(kernel.angle, j_low / j);
  if (!(kernel.angle.pair.high * (2.0 * j) < largest_turn)) [[unlikely]]
    return last_encounters(kernel);
  kernel.stage_3();
  return kernel.rounded_result();
}
Encounters<double> fast_encounters(double alpha, double j, double j_low) {
  if (alpha >= least_usual && alpha < 1.0) [[likely]]
    return encounters_of<Usual>(alpha, j, j_low);
  return encounters_of<Tabled<double>>(alpha, j, j_low);
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

/// In place, as a double that is stored alone and loaded beside another is waited for.
template <class Number>
[[gnu::always_inline]] inline void put(const TerminalKernel<Number>& kernel,
                                       magicmass::Terminal& result) {
  auto velocities = kernel.rounded_result();
  if constexpr (!std::is_same_v<Number, Usual>) {
    // a pair's square so small has a low part that is no double, and depends on how it is computed (theorem offset.rho)
    if (velocities.rho < 0x1p-960) [[unlikely]]
      velocities.rho = velocities.b_t * velocities.b_t;
  }
  result.a_t = velocities.a_t;
  result.b_t = velocities.b_t;
  result.c_t = velocities.c_t;
  result.rho = velocities.rho;
}

/// Next to a threshold, where the tables do not tell.
[[gnu::noinline, gnu::cold]] std::int64_t total_of_closest(TurnsToPi turns, double alpha) {
  const auto psi = AngleKernel<Bounded<double>>::evaluate(alpha);
  return total_from_angle(turns, scaled(psi.pair, 0.25), psi.error / psi.pair.high + 0x1p-100);
}

template <class Number>
[[gnu::always_inline]] inline bool terminal_below_1(double alpha, magicmass::Terminal& result) {
  TerminalKernel<Number> kernel;
  kernel.alpha = alpha;
  const TurnsToPi turns = turns_to_pi(alpha);
  const bool can_tell = std::is_same_v<Number, Usual> || turns.quotient < 0x1p63;
  std::int64_t total = can_tell ? clear_total(turns) : 0;
  kernel.stage_1();
  kernel.stage_2();
  if (total == 0) [[unlikely]] {
    total = total_from_angle(turns, kernel.angle.pair, relative_error_of_angle(alpha));
    if (total == 0) [[unlikely]]
      total = total_of_closest(turns, alpha);
    if (total == 0) return false;
  }
  result.counts = {(total + 1) >> 1, total >> 1};
  kernel.N_A = static_cast<double>(result.counts.N_A);
  // -1 after a P, where the total is odd
  kernel.turn = std::bit_cast<double>(std::bit_cast<std::uint64_t>(1.0) |
                                      static_cast<std::uint64_t>(total) << 63U);
  if (total >> 54 != 0) [[unlikely]]
    kernel.angle = with_low_part(kernel.angle, low_part(result.counts.N_A) / kernel.N_A);
  kernel.stage_3();
  put(kernel, result);
  return true;
}
[[gnu::noinline, gnu::cold]] bool terminal_far_below_1(double alpha, magicmass::Terminal& result) {
  return terminal_below_1<Tabled<double>>(alpha, result);
}
bool fast_terminal(double alpha, magicmass::Terminal& result) {
  if (alpha >= 1.0) {
    TerminalKernel<Tabled<double>> kernel;
    kernel.alpha = alpha;
    result.counts = {1, 1};
    kernel.first();
    put(kernel, result);
    return true;
  }
  if (!(alpha >= least_usual)) [[unlikely]]
    return terminal_far_below_1(alpha, result);
  return terminal_below_1<Usual>(alpha, result);
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

}  // namespace

const SingleKernels tables::MAGICMASS_TARGET = {
    .fast_velocities = fast_velocities,
    .fast_encounters = fast_encounters,
    .fast_angle = fast_angle,
    .fast_ratios = fast_ratios,
    .fast_terminal = fast_terminal,
    .velocities = velocities,
    .encounters = encounters,
    .angle = angle,
    .ratios = ratios,
    .terminal = terminal,
};

}  // namespace magicmass::tiers
