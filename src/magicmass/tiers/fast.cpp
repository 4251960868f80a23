// SPDX-License-Identifier: MIT
#include "magicmass/fast.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "magicmass/accurate.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/evaluators/certified_encounters.hpp"
#include "magicmass/simulator/valid_input.hpp"
#include "magicmass/tiers/first_encounter.hpp"
#include "magicmass/tiers/single_kernels.hpp"

namespace magicmass::fast {
namespace {

/// Apart, so that who never throws saves no registers for it.
[[noreturn, gnu::noinline, gnu::cold]] void refuse(const char* what, std::int64_t index) {
  throw InvalidInput(std::string(what) + ", got " + std::to_string(index));
}

/// Up to here alpha can be split for its products, and 1/(1 + alpha) has all its digits.
constexpr double largest_alpha = 0x1p960;
/// From here on every product has its low part.
constexpr double least_in_pairs = 0x1p-600;
/// Below it n^2 alpha is less than 2^-470 for every n: but for so little of them a_n, c_n, c'_n, t_n and s_n do not depend on alpha,
/// and b_n is in proportion to it. An alpha larger by this, and 2^-210 for 2^-470, serves as well; beyond 2^-594, as products of what is
/// less would be subnormal, which takes processors long.
constexpr double from_tiny(double alpha) { return alpha < 0x1p-850 ? 0x1p512 : 0x1p256; }
/// alpha times that; of a subnormal one its bits, a whole number of 2^-1074, as operations on itself take processors long.
double moved_from_tiny(double alpha) {
  if (alpha < 0x1p-1022) return static_cast<double>(std::bit_cast<std::int64_t>(alpha)) * 0x1p-562;
  return alpha * from_tiny(alpha);
}
/// And beyond the largest a_1 = a_t is -1, and the other velocities are as 1/alpha, to 2^-850 of themselves.
constexpr double from_huge = 0x1p-100;
/// Below this N_A + N_B is beyond 2^63.
constexpr double least_alpha = 0x1p-124;

[[gnu::noinline]] generated::Velocities<double> velocities_at_tiny(double alpha, std::int64_t n) {
  const double back = 1.0 / from_tiny(alpha);
  auto result = tiers::single_kernels().fast_velocities(moved_from_tiny(alpha),
                                                        static_cast<double>(n), tiers::low_part(n));
  result.b *= back;
  return result;
}
[[gnu::noinline, gnu::cold]] generated::Velocities<double> first_at_huge(double alpha) {
  auto result = tiers::single_kernels().fast_velocities(alpha * from_huge, 1.0, 0.0);
  result.b *= from_huge;
  result.c *= from_huge;
  result.c_prime *= from_huge;
  return result;
}
[[gnu::noinline, gnu::cold]] Terminal terminal_at_huge(double alpha) {
  Terminal result;
  tiers::single_kernels().fast_terminal(alpha * from_huge, result);
  result.b_t *= from_huge;
  result.c_t *= from_huge;
  result.rho = result.b_t * result.b_t;
  return result;
}

[[gnu::noinline, gnu::cold]] std::optional<Terminal> terminal_elsewhere(double alpha) {
  if (alpha > largest_alpha && std::isfinite(alpha)) return terminal_at_huge(alpha);
  return accurate::terminal(alpha);
}

/// Whether alpha is from least_alpha to largest_alpha: doubles compare like their bits, and no others are between.
bool has_kernel(double alpha) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(alpha) - bits(least_alpha) <= bits(largest_alpha) - bits(least_alpha);
}

/// Makes the value of an optional where it will be: not zero first, and not copied.
struct InPlace {
  double alpha;
  bool& is_known;

  operator Terminal() const {
    Terminal result;
    is_known = has_kernel(alpha) && tiers::single_kernels().fast_terminal(alpha, result);
    return result;
  }
};

}  // namespace

generated::Velocities<double> velocities(double alpha, std::int64_t n) {
  // what is asked for nearly always, with one look at each argument
  if (alpha >= least_in_pairs && alpha <= largest_alpha && n > 0 && (alpha < 1.0 || n == 1))
      [[likely]]
    return tiers::single_kernels().fast_velocities(alpha, static_cast<double>(n),
                                                   tiers::low_part(n));
  require_positive_finite("alpha", alpha);
  if (n < 0) refuse("n must be 0 or more", n);
  if (n == 0) return {1.0, 0.0, 0.0, 0.0};
  if (alpha >= 1.0 && n > 1)
    refuse("n must be 0 or 1 from alpha = 1 on, where there are two collisions", n);
  return alpha > 1.0 ? first_at_huge(alpha) : velocities_at_tiny(alpha, n);
}

generated::Encounters<double> encounters(double alpha, std::int64_t j) {
  if (alpha > 0.0 && alpha < 1.0 && j > 1) [[likely]] {
    const auto result =
        tiers::single_kernels().fast_encounters(alpha, static_cast<double>(j), tiers::low_part(j));
    if (result.s > 0.0) [[likely]]
      return result;
  }
  require_positive_finite("alpha", alpha);
  if (j < 0) refuse("j must be 0 or more", j);
  if (j == 0) return {0.0, 1.0};
  if (j == 1) return tiers::first_encounter(alpha);
  return certified_encounters(alpha, j);
}

std::optional<Terminal> terminal(double alpha) {
  bool is_known = false;
  std::optional<Terminal> found(std::in_place, InPlace{alpha, is_known});
  if (!is_known) [[unlikely]]
    found = terminal_elsewhere(alpha);
  return found;
}

// Below 1 the root's rounding, at most 1.01 ulp, and the last one. From 1 on two roundings before the root, which halves them, its
// own and the last: at sqrt(alpha/(2 + alpha)) = 0.58, the worst place, 0.3 + 0.3 + 0.7 + 0.5 ulp if all were at their worst together.
double angle(double alpha) {
  if (!(alpha > 0.0 && alpha <= std::numeric_limits<double>::max())) [[unlikely]]
    require_positive_finite("alpha", alpha);
  return tiers::single_kernels().fast_angle(alpha);
}

generated::Ratios<double> ratios(std::int64_t k) {
  if (k < 1) [[unlikely]]
    refuse("k must be 1 or more", k);
  return tiers::single_kernels().fast_ratios(static_cast<double>(k), tiers::low_part(k));
}

}  // namespace magicmass::fast
