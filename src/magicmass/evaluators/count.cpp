// SPDX-License-Identifier: MIT
#include "magicmass/evaluators/count.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>

#include "magicmass/angle_product.hpp"
#include "magicmass/cosine_ladder.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/evaluators/fixed_point.hpp"
#include "magicmass/simulator/valid_input.hpp"

namespace magicmass {
namespace {

/// Certain sign of sin(m h) for 0 < m h < 2 pi, or 0, in Words words, as that of sin(m h) sin h, which the generated
/// ladder gives without a square root. 1 + alpha is stored exactly and x = 1/(1+alpha) within 1 ulp. A step at most quadruples an error, so
/// the result is within a small multiple of m^2 <= 2^126 ulp, which FixedPoint tracks. It has to be told from a
/// value of about sin(m h) sin h. A double is hardly ever closer to a threshold than 2^-64 of the spacing of
/// doubles, so that is about 2^-60 (sin h) times 2^-60 (m h against the spacing): 448 bits decide with ease, and
/// the larger sizes are there so that nothing rests on "hardly".
template <std::size_t Words>
int certain_sign_of_sine(std::uint64_t m, double alpha) {
  using Number = FixedPoint<Words>;
  const Number x = Number::reciprocal(Number::one() + Number::from(alpha));
  return generated::sine_ladder(m, x, Number::one()).certain_sign();
}

/// sin(m h) > 0. Exactly 0 only at alpha = 1 (Niven: no other rational cosine has an angle commensurable with pi),
/// which does not come here.
bool sine_is_positive(std::uint64_t m, double alpha) {
  int sign = certain_sign_of_sine<8>(m, alpha);
  if (sign == 0) {
    sign = certain_sign_of_sine<16>(m, alpha);
  }
  if (sign == 0) {
    sign = certain_sign_of_sine<32>(m, alpha);
  }
  if (sign == 0) {
    throw Undecided("alpha is closer to a threshold than 1984 bits can tell, at " +
                    std::to_string(m) + " collisions");
  }
  return sign > 0;
}

/// Largest m in [low, high] with m h < pi, given that low is one and that high h < 2 pi.
std::uint64_t largest_below_pi(std::uint64_t low, std::uint64_t high, double alpha) {
  while (low < high) {
    const std::uint64_t middle = low + (high - low + 1) / 2;
    if (sine_is_positive(middle, alpha)) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  return low;
}

Counts split(std::uint64_t total) {
  return {static_cast<std::int64_t>(total / 2 + total % 2), static_cast<std::int64_t>(total / 2)};
}

}  // namespace

CountDecision decide_count(double alpha) {
  require_positive_finite("alpha", alpha);
  if (alpha >= 1.0) {
    return {Counts{1, 1}, false};  // pi/3 <= h < pi/2
  }
  // h = 2 atan sqrt(alpha/(2+alpha)) <= sqrt(2 alpha), so pi/h > pi 2^61.5 > 2^63 here.
  if (alpha < 0x1p-124) {
    return {std::nullopt, false};
  }
  // With u = eps/2: the sum and the quotient cost 2u, halved by the root, which adds u; atan does not magnify a
  // relative error and is taken to be good to 8u (glibc: 2u); pi and the division cost 2u. 12u = 6 eps in all,
  // and 16 eps leave room for forming the bounds below.
  using Real = long double;
  const Real h = generated::angle_product<Real>(alpha) / 2;
  const Real quotient = std::numbers::pi_v<Real> / h;
  const Real margin = 16 * std::numeric_limits<Real>::epsilon() * quotient;
  const Real lowest = quotient - margin;
  const Real highest = quotient + margin;
  if (lowest >= 0x1p63L + 1) {
    return {std::nullopt, false};
  }
  // total = ceil(pi/h) - 1, the largest m with m h < pi
  const auto least = static_cast<std::uint64_t>(std::ceil(lowest)) - 1;
  const auto most = static_cast<std::uint64_t>(std::ceil(highest)) - 1;
  const bool near_tie = least != most;
  const std::uint64_t total = near_tie ? largest_below_pi(least, most, alpha) : least;
  if (total >= std::uint64_t{1} << 63U) {
    return {std::nullopt, near_tie};
  }
  return {split(total), near_tie};
}

std::optional<Counts> count_collisions(double alpha) { return decide_count(alpha).counts; }

}  // namespace magicmass
