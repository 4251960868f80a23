// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/velocity_tiers.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

#include <cln/cln.h>

#include "command/alpha_value.hpp"
#include "command/certified.hpp"
#include "magicmass/accurate.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/fast.hpp"
#include "magicmass/reference/decimal.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/velocities.hpp"
#include "magicmass/scenes/shown_text.hpp"
#include "magicmass/velocities_exact.hpp"

namespace magicmass::command {
namespace {

using cln::cl_I;
using cln::cl_RA;

constexpr int digits_of_irrationals = 30;

std::int64_t in_64_bits(const cl_I& n) {
  if (n > cl_I(std::numeric_limits<std::int64_t>::max()))
    throw Undecided("n = " + reference::to_text(n) +
                    " does not fit 64 bits; use --tier exact --digits D");
  return cln::cl_I_to_long(n);
}

generated::Velocities<double> fast_velocities(const MassRatio& alpha, const cl_I& n) {
  return fast::velocities(nearest_double(alpha), in_64_bits(n));
}

/// Bits of the denominators: (1 + alpha)^(2n+1) is what Chebyshev polynomials of 1/(1 + alpha) divide by.
cl_I exact_length(const cl_RA& alpha, const cl_I& n) {
  const cl_I base = cln::numerator(alpha) + cln::denominator(alpha);
  return (2 * n + 1) * cl_I(static_cast<unsigned long>(cln::integer_length(base)));
}

generated::Velocities<cl_RA> exact_velocities(const cl_RA& alpha, const cl_I& n) {
  if (exact_length(alpha, n) > reference::longest_exact_velocity)
    throw Undecided("the exact fractions at n = " + reference::to_text(n) + " have about " +
                    reference::to_text(exact_length(alpha, n)) + " bits; use --digits D instead");
  return generated::velocities_exact<cl_RA, cl_I>(alpha, n);
}

bool all_goes_to_B(const MassRatio& alpha, const cl_I& n) {
  const auto* magic = std::get_if<Magic>(&alpha);
  return magic != nullptr && n == cl_I(magic->k);
}

/// Enough bits to begin with: intervals widen by a few bits each time n halves.
long starting_precision(const MassRatio& alpha, const cl_I& n, int digits) {
  const auto length = static_cast<long>(to_text(alpha).size());
  return 128 + 4L * digits + 8 * static_cast<long>(cln::integer_length(n)) + 8 * length;
}

/// One of the velocities, or what is made of them.
template <class Member>
reference::Enclosure enclosure_of(const MassRatio& alpha, const cl_I& n, Member member) {
  return [=](long precision) {
    return member(reference::enclosed_velocities(reference::enclosure(alpha), n, precision));
  };
}
const auto square_of_b = [](const auto& v) { return v.b * v.b; };

reference::CycleVelocities<std::string> certified_velocities(const MassRatio& alpha, const cl_I& n,
                                                             int digits) {
  if (!all_goes_to_B(alpha, n)) return reference::certified_digits(alpha, n, digits);
  const auto c = enclosure_of(alpha, n, [](const auto& v) { return v.c; });
  return {"0", "1", certified_decimal(c, digits, starting_precision(alpha, n, digits)), "0"};
}

/// The doubles next to the velocities at alpha as it is written, and to (b_n/V)^2.
struct NearestVelocities {
  generated::Velocities<double> v;
  double square_of_b;
};
NearestVelocities accurate_velocities(const MassRatio& alpha, const cl_I& n) {
  const std::optional<cl_RA> rational = reference::exact(alpha);
  const auto nearest = [](const cl_RA& x) { return reference::nearest<double>(x); };
  if (rational && exact_length(*rational, n) < cl_I(1L << 14)) {  // it may be half way between two
    const auto v = exact_velocities(*rational, n);
    return {{nearest(v.a), nearest(v.b), nearest(v.c), nearest(v.c_prime)}, nearest(v.b * v.b)};
  }
  const auto certain = [&](auto member) {
    return certified_double(enclosure_of(alpha, n, member),
                            starting_precision(alpha, n, digits_of_irrationals));
  };
  const double c = certain([](const auto& v) { return v.c; });
  if (all_goes_to_B(alpha, n)) return {{0.0, 1.0, c, 0.0}, 1.0};
  return {{certain([](const auto& v) { return v.a; }), certain([](const auto& v) { return v.b; }),
           c, certain([](const auto& v) { return v.c_prime; })},
          certain(square_of_b)};
}

/// (b_n / V)^2 to `digits` digits.
std::string certified_square_of_b(const MassRatio& alpha, const cl_I& n, int digits) {
  if (all_goes_to_B(alpha, n)) return "1";
  // A square that ends within the digits is a fraction no longer than about 4 bits a digit.
  const cl_I short_length(std::max(1L << 14, 8L * digits));
  const std::optional<cl_RA> rational = reference::exact(alpha);
  if (rational && exact_length(*rational, n) < short_length) {
    const cl_RA b = exact_velocities(*rational, n).b;
    return reference::to_decimal(b * b, digits);
  }
  return certified_decimal(enclosure_of(alpha, n, square_of_b), digits,
                           starting_precision(alpha, n, digits));
}

Cell fraction_cell(const cl_RA& value) { return text_cell(reference::to_text(value)); }

/// a at P_(N_A), b at Q_(N_B), c at the later of both.
template <class Value, class Velocities>
Last<Value> last_of(const Velocities& at_N_A, const Velocities& at_N_B,
                    const reference::LargeCounts& counts) {
  return {at_N_A.a, at_N_B.b, counts.N_A == counts.N_B ? at_N_B.c_prime : at_N_A.c};
}

}  // namespace

VelocityCells velocities(const MassRatio& alpha, const cl_I& n, const Accuracy& accuracy) {
  if (accuracy.tier != "exact") {
    const auto* value = std::get_if<double>(&alpha);
    const auto v = accuracy.tier == "fast" ? fast_velocities(alpha, n)
                   : value != nullptr      ? accurate::velocities(*value, in_64_bits(n))
                                           : accurate_velocities(alpha, n).v;
    return {number_cell(v.a), number_cell(v.b), number_cell(v.c), number_cell(v.c_prime)};
  }
  const std::optional<cl_RA> rational = reference::exact(alpha);
  if (rational && !accuracy.digits) {
    const auto v = exact_velocities(*rational, n);
    return {fraction_cell(v.a), fraction_cell(v.b), fraction_cell(v.c), fraction_cell(v.c_prime)};
  }
  const auto v = certified_velocities(alpha, n, accuracy.digits.value_or(digits_of_irrationals));
  return {text_cell(v.a), text_cell(v.b), text_cell(v.c), text_cell(v.c_prime)};
}

Last<double> fast_terminal_velocities(const MassRatio& alpha,
                                      const reference::LargeCounts& counts) {
  // the double's own counts may be others where alpha is none
  if (const auto* value = std::get_if<double>(&alpha))
    if (const auto end = fast::terminal(*value)) return {end->a_t, end->b_t, end->c_t};
  return last_of<double>(fast_velocities(alpha, counts.N_A), fast_velocities(alpha, counts.N_B),
                         counts);
}

Last<cl_RA> exact_terminal_velocities(const cl_RA& alpha, const reference::LargeCounts& counts) {
  return last_of<cl_RA>(exact_velocities(alpha, counts.N_A), exact_velocities(alpha, counts.N_B),
                        counts);
}

TerminalCells terminal_velocities(const MassRatio& alpha, const reference::LargeCounts& counts,
                                  const Accuracy& accuracy) {
  if (accuracy.tier == "fast") {
    const Last<double> v = fast_terminal_velocities(alpha, counts);
    return {number_cell(v.a), number_cell(v.b), number_cell(v.c), number_cell(v.b * v.b)};
  }
  if (accuracy.tier == "accurate") {
    const auto* value = std::get_if<double>(&alpha);
    if (const auto end = value != nullptr ? accurate::terminal(*value) : std::nullopt)
      return {number_cell(end->a_t), number_cell(end->b_t), number_cell(end->c_t),
              number_cell(end->rho)};
    const NearestVelocities at_N_B = accurate_velocities(alpha, counts.N_B);
    const auto v = last_of<double>(accurate_velocities(alpha, counts.N_A).v, at_N_B.v, counts);
    return {number_cell(v.a), number_cell(v.b), number_cell(v.c), number_cell(at_N_B.square_of_b)};
  }
  const std::optional<cl_RA> rational = reference::exact(alpha);
  if (rational && !accuracy.digits) {
    const Last<cl_RA> v = exact_terminal_velocities(*rational, counts);
    return {fraction_cell(v.a), fraction_cell(v.b), fraction_cell(v.c), fraction_cell(v.b * v.b)};
  }
  const int digits = accuracy.digits.value_or(digits_of_irrationals);
  const auto at_N_A = certified_velocities(alpha, counts.N_A, digits);
  const auto at_N_B =
      counts.N_A == counts.N_B ? at_N_A : certified_velocities(alpha, counts.N_B, digits);
  const auto v = last_of<std::string>(at_N_A, at_N_B, counts);
  return {text_cell(v.a), text_cell(v.b), text_cell(v.c),
          text_cell(certified_square_of_b(alpha, counts.N_B, digits))};
}

}  // namespace magicmass::command
