// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/count.hpp"

#include <cstddef>
#include <optional>
#include <vector>

#include "magicmass/counts.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/reference/cycle_map.hpp"
#include "magicmass/reference/interval.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::reference {
namespace {

using cln::cl_I;
using cln::cl_RA;

/// Contact by contact in exact rationals, so that bodies at rest relative to each other are seen not to meet.
LargeCounts step_exactly(const cl_RA& alpha) {
  LargeCounts counts{0, 0};
  BodyVelocities<cl_RA> v = initial_velocities<cl_RA>();
  for (;;) {
    if (!(v.c < v.a)) {
      return counts;
    }
    v = meet_A(alpha, v);
    counts.N_A = counts.N_A + 1;
    if (!(v.b < v.c)) {
      return counts;
    }
    v = meet_B(alpha, v);
    counts.N_B = counts.N_B + 1;
  }
}

/// Do two bodies with this closing speed approach? nullopt where the interval leaves it open.
std::optional<bool> approach(const Interval& closing) {
  const Sign sign = closing.sign();
  return sign == Sign::open ? std::nullopt : std::optional(sign == Sign::positive);
}

/// The search at one precision; nullopt if some sign stayed open.
///
/// Let f(n) be the speed with which A and C approach after n cycles, physics or not. Each contact is a reflection of
/// (a, b, sqrt(alpha) c), so a cycle is a rotation by a fixed angle psi = 2 h, h the acute angle between the two
/// mirrors, about the direction of common motion, of which f is free: f is a pure sinusoid in n. The approach
/// speeds before contacts 1, 2, 3, ... are the heights of one vector above mirrors that turn by h each time and
/// begin at height sin h: they run as sin h, sin 2h, sin 3h, ..., positive up to the last collision, not positive
/// for as many after it. So f(n) = sin((2n+1) h), n = 2^i up to the first failure stays below the second zero,
/// 2 pi, and the largest n with f(n) > 0 has its bits found from the top.
std::optional<LargeCounts> search(const cl_RA& alpha, long precision) {
  const Interval ratio(alpha, precision);
  const BodyVelocities<Interval> start = initial_velocities<Interval>();
  std::vector<LinearMap<Interval>> powers{cycle_map(ratio)};  // powers[i] is 2^i cycles
  for (;;) {
    const BodyVelocities<Interval> v = apply(powers.back(), start);
    const std::optional<bool> meet = approach(v.a - v.c);
    if (!meet) {
      return std::nullopt;
    }
    if (!*meet) {
      break;
    }
    powers.push_back(compose(powers.back(), powers.back()));
  }
  cl_I cycles(0);
  BodyVelocities<Interval> last = start;
  for (std::size_t i = powers.size() - 1; i-- > 0;) {
    const BodyVelocities<Interval> v = apply(powers[i], last);
    const std::optional<bool> meet = approach(v.a - v.c);
    if (!meet) {
      return std::nullopt;
    }
    if (*meet) {
      last = v;
      cycles = cycles + cln::ash(cl_I(1), static_cast<long>(i));
    }
  }
  // `last` is just before A's last contact; B may or may not be met once more after it.
  const BodyVelocities<Interval> after = meet_A(ratio, last);
  const std::optional<bool> meet_again = approach(after.c - after.b);
  if (!meet_again) {
    return std::nullopt;
  }
  const cl_I N_A = cycles + 1;
  return LargeCounts{N_A, *meet_again ? N_A : cycles};
}

}  // namespace

LargeCounts count_collisions(const cl_RA& alpha) {
  if (!cln::plusp(alpha)) {
    throw InvalidInput("alpha must be a positive finite number, got " + to_text(alpha));
  }
  const cl_RA few_collisions_from = cl_RA(1) / 100;
  if (alpha >= few_collisions_from) {
    return step_exactly(alpha);
  }
  // Matrix entries reach alpha^(-1/2) and a squaring adds about 3 bits, alpha^(-1/2) cycles: 2 log2(1/alpha) in
  // all; telling alpha from a threshold takes what alpha's own digits take.
  const long length = static_cast<long>(cln::integer_length(cln::numerator(alpha)) +
                                        cln::integer_length(cln::denominator(alpha)));
  const long start = 64 + 2 * length;
  for (long precision = start; precision <= 64 * start; precision *= 2) {
    if (const std::optional<LargeCounts> counts = search(alpha, precision)) {
      return *counts;
    }
  }
  throw Undecided("alpha is closer to a threshold than " + std::to_string(64 * start) +
                  " bits can tell");
}

LargeCounts count_collisions(const MassRatio& alpha) {
  if (const auto* magic = std::get_if<Magic>(&alpha)) return {magic->k, magic->k};
  if (const auto* deficient = std::get_if<Deficient>(&alpha))
    return {cln::cl_I(deficient->k) + 1, deficient->k};
  if (const auto* value = std::get_if<double>(&alpha))
    if (const std::optional<Counts> counts = magicmass::count_collisions(*value))
      return {counts->N_A, counts->N_B};
  return count_collisions(*exact(alpha));
}

}  // namespace magicmass::reference
