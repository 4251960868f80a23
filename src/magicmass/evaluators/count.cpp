// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

#include "magicmass/angle_product.hpp"
#include "magicmass/evaluators/count_decision.hpp"
#include "magicmass/evaluators/multiword_functions.hpp"
#include "magicmass/evaluators/multiword_pi.hpp"
#include "magicmass/evaluators/ziv.hpp"
#include "magicmass/simulator/valid_input.hpp"
#include "magicmass/tiers/clear_count.hpp"
#include "magicmass/tiers/single_kernels.hpp"

namespace magicmass {
namespace {

/// pi/h, h = psi/2: NearInteger carries the error along, and in floating point it is within margin<Real> relative.
/// There, with u = eps/2, the sum and the quotient under the root cost 2u, halved by the root, which adds u; atan does
/// not magnify a relative error and is taken to be good to 8u (glibc: 2u); pi and the division cost 2u: 12u = 6 eps in
/// all, and 16 eps leave room for what is done with it.
template <class Real>
Real turns_to_pi(double alpha) {
  return std::numbers::pi_v<Real> / (generated::angle_product(Real(alpha)) / Real(2));
}
template <class Real>
constexpr Real margin = 16 * std::numeric_limits<Real>::epsilon();

/// ceil(pi/h) - 1, 3 <= pi/h < 2^64: its integer part if it is certainly past that and short of the next, else nullopt.
/// pi/h is an integer at alpha = 1 alone (Niven: no other rational cos h has an angle commensurable with pi), which
/// does not come here. A double is hardly ever closer to a threshold than 2^-64 of the spacing of doubles, 2^-117 of
/// itself, which four words tell with ease; the larger sizes are there so that nothing rests on "hardly".
struct Total {
  double alpha;

  template <std::size_t Words>
  std::optional<std::uint64_t> operator()() const {
    using Number = NearInteger<Words>;
    const auto quotient = turns_to_pi<Number>(alpha);
    const std::uint64_t below = quotient.together().top();
    const bool is_past = (quotient - Number(below)).certain_sign() > 0;
    const bool is_short = (quotient - Number(below + 1)).certain_sign() < 0;
    return is_past && is_short ? std::optional(below) : std::nullopt;
  }
};

Counts split(std::uint64_t total) {
  return {static_cast<std::int64_t>(total - total / 2), static_cast<std::int64_t>(total / 2)};
}

/// Below this h = 2 atan sqrt(alpha/(2+alpha)) <= sqrt(2 alpha), so pi/h > pi 2^61.5 > 2^63.
constexpr double too_many_below = 0x1p-124;

/// Where a double does not decide.
CountDecision decide_further(double alpha) {
  if (alpha < too_many_below) {
    return {std::nullopt, false};
  }
  using Real = long double;
  const auto quotient = turns_to_pi<Real>(alpha);
  const Real lowest = quotient - margin<Real> * quotient;
  const Real highest = quotient + margin<Real> * quotient;
  if (lowest >= 0x1p63L + 1) {
    return {std::nullopt, false};
  }
  // total = ceil(pi/h) - 1, the largest m with m h < pi
  const auto least = static_cast<std::uint64_t>(std::ceil(lowest)) - 1;
  const auto most = static_cast<std::uint64_t>(std::ceil(highest)) - 1;
  const bool near_tie = least != most;
  const std::uint64_t total = near_tie ? certain("alpha's count", Total{alpha}) : least;
  if (total >= std::uint64_t{1} << 63U) {
    return {std::nullopt, near_tie};
  }
  return {split(total), near_tie};
}

}  // namespace

CountDecision decide_count(double alpha) {
  require_positive_finite("alpha", alpha);
  if (alpha >= 1.0) {
    return {Counts{1, 1}, false};  // pi/3 <= h < pi/2
  }
  if (alpha >= 0x1p-120) {  // pi/h is less than 2^62
    if (const std::int64_t total = tiers::clear_total(tiers::turns_to_pi(alpha)); total != 0)
      return {split(static_cast<std::uint64_t>(total)), false};
  }
  // The margin stays below 2^-4, and the conversions are exact.
  constexpr double largest = 0x1p44;
  if (const auto quotient = turns_to_pi<double>(alpha); quotient < largest) {
    const auto below = static_cast<std::int64_t>(quotient);
    const double past = quotient - static_cast<double>(below);
    const double unsure = margin<double> * quotient;
    if (past > unsure && past < 1.0 - unsure) {
      return {split(static_cast<std::uint64_t>(below)), false};
    }
  }
  return decide_further(alpha);
}

std::optional<Counts> count_collisions(double alpha) {
  if (alpha >= too_many_below && alpha < 1.0) {
    if (alpha >= 0x1p-120) {  // pi/h is less than 2^62
      if (const std::int64_t total = tiers::clear_total(tiers::turns_to_pi(alpha)); total != 0)
        return split(static_cast<std::uint64_t>(total));
    }
    if (const std::int64_t total = tiers::single_kernels().total(alpha); total != 0)
      return split(static_cast<std::uint64_t>(total));
  }
  return decide_count(alpha).counts;
}

}  // namespace magicmass
