// SPDX-License-Identifier: MIT
#include "magicmass/fast.hpp"

#include <string>

#include "magicmass/accurate.hpp"
#include "magicmass/angle_closed.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/evaluators/certified_encounters.hpp"
#include "magicmass/evaluators/certified_velocities.hpp"
#include "magicmass/evaluators/count.hpp"
#include "magicmass/simulator/valid_input.hpp"
#include "magicmass/tiers/first_encounter.hpp"
#include "magicmass/tiers/single_kernels.hpp"

namespace magicmass::fast {
namespace {

void require_not_negative(const char* name, std::int64_t index) {
  if (index < 0) {
    throw InvalidInput(std::string(name) + " must be 0 or more, got " + std::to_string(index));
  }
}

/// Up to here alpha can be split for its products, and 1/(1 + alpha) has all its digits.
constexpr double largest_alpha = 0x1p960;
/// Below this N_A + N_B is beyond 2^63.
constexpr double least_alpha = 0x1p-124;

}  // namespace

generated::Velocities<double> velocities(double alpha, std::int64_t n) {
  require_positive_finite("alpha", alpha);
  require_not_negative("n", n);
  if (n == 0) return {1.0, 0.0, 0.0, 0.0};
  if (alpha >= 1.0 && n > 1) {
    throw InvalidInput("n must be 0 or 1 from alpha = 1 on, where there are two collisions, got " +
                       std::to_string(n));
  }
  if (alpha > largest_alpha) [[unlikely]]
    return certified_velocities(alpha, n);
  return tiers::single_kernels().fast_velocities(alpha, static_cast<double>(n), tiers::low_part(n));
}

generated::Encounters<double> encounters(double alpha, std::int64_t j) {
  require_positive_finite("alpha", alpha);
  require_not_negative("j", j);
  if (j == 0) return {0.0, 1.0};
  if (j == 1) return tiers::first_encounter(alpha);
  if (alpha < 1.0 && j < std::int64_t{1} << 51U) [[likely]] {
    const auto result = tiers::single_kernels().fast_encounters(alpha, static_cast<double>(j));
    if (result.s > 0.0) [[likely]]
      return result;
  }
  return certified_encounters(alpha, j);
}

std::optional<Terminal> terminal(double alpha) {
  Counts counts;
  generated::Terminal<double> result;
  if (!(alpha >= least_alpha && alpha <= largest_alpha &&
        tiers::single_kernels().fast_terminal(alpha, counts, result))) [[unlikely]] {
    const std::optional<Counts> exact = count_collisions(alpha);
    if (!exact) return std::nullopt;
    if (alpha > largest_alpha) return accurate::terminal(alpha);
    counts = *exact;
    result = tiers::single_kernels().fast_terminal_at(alpha, static_cast<double>(counts.N_A),
                                                      tiers::low_part(counts.N_A),
                                                      counts.N_B == counts.N_A ? 1.0 : -1.0);
  }
  return Terminal{counts, result.a_t, result.b_t, result.c_t, result.rho};
}

// The paper's own form loses no digit: two roundings before the root, which halves them, and two after, within 1.5 ulp with
// a libm's arctangent that is good to 0.6.
double angle(double alpha) {
  require_positive_finite("alpha", alpha);
  return generated::angle_closed(alpha);
}

generated::Ratios<double> ratios(std::int64_t k) {
  if (k < 1) throw InvalidInput("k must be 1 or more, got " + std::to_string(k));
  return tiers::single_kernels().fast_ratios(static_cast<double>(k), tiers::low_part(k));
}

}  // namespace magicmass::fast
