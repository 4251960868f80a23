// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/restitution.hpp"

#include <string>

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/real.h>

#include "magicmass/errors.hpp"
#include "magicmass/reference/enclosure.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::reference {
namespace {

using cln::cl_I;
using cln::cl_RA;

/// cos^2 h, rational for rational alpha and e.
cl_RA squared_cosine(const cl_RA& alpha, const cl_RA& e) {
  return cln::square((1 + e) / (1 + alpha)) / (4 * e);
}

/// ceil(pi/h) - 1 for cos^2 h < 1; nullopt where this precision leaves it open. tan^2 h is rational, so nothing cancels;
/// CLN's manual promises pi, sqrt and atan to about the last place, and 2^24 times that for each is allowed here.
std::optional<cl_I> total(const cl_RA& square, long precision) {
  const auto digits = static_cast<unsigned long>(static_cast<double>(precision + 64) * 0.30103) + 2;
  const cln::float_format_t format = cln::float_format(digits);
  const cln::cl_R tangent = cln::sqrt(cln::cl_float((1 - square) / square, format));
  const cl_RA quotient = cln::rational(cln::pi(format) / cln::atan(tangent));
  const cl_RA margin = quotient / cl_RA(cln::ash(cl_I(1), precision + 32));
  const cl_I lowest = cln::ceiling1(quotient - margin);
  if (lowest != cln::ceiling1(quotient + margin)) return std::nullopt;
  return lowest - 1;
}

/// pi/h is whole, and h below pi/2, for these alone: by Niven's theorem no other rational cos 2h = 2 cos^2 h - 1 has an
/// angle commensurable with pi.
std::optional<cl_I> total_at_tie(const cl_RA& square) {
  for (const auto& [quarters, collisions] : {std::pair{1, 2}, {2, 3}, {3, 5}})
    if (4 * square == cl_RA(quarters)) return cl_I(collisions);
  return std::nullopt;
}

LargeCounts split(const cl_I& total) { return {cln::ceiling1(total, 2), cln::floor1(total, 2)}; }

/// Collapse or counts where every mass ratio in [low, high] has the same.
struct Outcome {
  bool decided = false;
  std::optional<LargeCounts> counts = {};
};

Outcome outcome_within(const cl_RA& low, const cl_RA& high, const cl_RA& e, long precision) {
  const cl_RA largest = squared_cosine(low, e);
  const cl_RA least = squared_cosine(high, e);
  if (least >= 1) return {true, std::nullopt};
  if (largest >= 1) return {};
  const std::optional<cl_I> most = total(largest, precision);
  const std::optional<cl_I> fewest = low == high ? most : total(least, precision);
  if (!most || !fewest || *most != *fewest) return {};
  return {true, split(*most)};
}

}  // namespace

std::optional<LargeCounts> count_collisions(const MassRatio& alpha, const cl_RA& e) {
  if (!cln::plusp(e) || e > 1)
    throw InvalidInput("restitution must be above 0 and at most 1, got " + to_text(e));
  const std::optional<cl_RA> rational = exact(alpha);
  if (rational && !cln::plusp(*rational))
    throw InvalidInput("alpha must be a positive finite number, got " + to_text(*rational));
  if (rational)
    if (const std::optional<cl_I> collisions = total_at_tie(squared_cosine(*rational, e)))
      return split(*collisions);
  const Enclosure enclosed = enclosure(alpha);
  const auto length = [](const cl_RA& x) {
    return static_cast<long>(cln::integer_length(cln::numerator(x)) +
                             cln::integer_length(cln::denominator(x)));
  };
  const long start = 64 + 2 * (length(e) + (rational ? length(*rational) : 64));
  for (long precision = start; precision <= 64 * start; precision *= 2) {
    const Interval at = enclosed(precision);
    const Outcome outcome = outcome_within(rational ? *rational : at.low(),
                                           rational ? *rational : at.high(), e, precision);
    if (outcome.decided) return outcome.counts;
  }
  throw Undecided("alpha is closer to a threshold at this restitution than " +
                  std::to_string(64 * start) + " bits can tell");
}

}  // namespace magicmass::reference
