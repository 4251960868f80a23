// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/exact_velocities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numbers>

#include <cln/integer.h>
#include <cln/real.h>

#include "magicmass/errors.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/velocities.hpp"
#include "report/last_collision.hpp"
#include "report/relative_motion.hpp"

namespace magicmass::report {
namespace {

using cln::cl_I;
using cln::cl_RA;
using reference::CycleVelocities;
using reference::Interval;

template <class Value>
std::array<Value, 4> members(const CycleVelocities<Value>& v) {
  return {v.a, v.b, v.c, v.c_prime};
}

/// log2 of the relative step by which alpha is moved to see what that does.
constexpr long step = 80;

/// 2^step (y(alpha + alpha 2^-step) / y(alpha) - 1) where three digits of it are certain, 0 where it is certainly below 1/16: the
/// envelope asks no more. Negative if neither is so at this precision.
double condition(const Interval& here, const Interval& moved) {
  const cl_RA size = cln::min(cln::abs(here.low()), cln::abs(here.high()));
  if (here.sign() == reference::Sign::open || cln::zerop(size)) return -1;
  const cl_RA slack = (here.high() - here.low()) + (moved.high() - moved.low());
  const cl_RA change = cln::abs(moved.low() - here.low());
  const cl_RA unit = size / cl_RA(cln::ash(cl_I(1), step));
  if (change + slack < unit / 16) return 0;
  if (slack * 1024 > change) return -1;
  return reference::nearest<double>(change / unit);
}

/// What rounding takes: both ends of an enclosure have the same nearest numbers. y is one of them.
bool rounds_alike(const Interval& y) {
  const cl_RA low = y.low();
  const cl_RA high = y.high();
  constexpr long bits_of_value = 130;
  return (high - low) * cl_RA(cln::ash(cl_I(1), bits_of_value)) <
             cln::min(cln::abs(low), cln::abs(high)) &&
         reference::nearest<float>(low) == reference::nearest<float>(high) &&
         reference::nearest<double>(low) == reference::nearest<double>(high) &&
         reference::nearest<long double>(low) == reference::nearest<long double>(high);
}

/// The velocities with their conditions. Where they are short they are computed as fractions: that settles exact
/// zeros and ties, which have denominators that are powers of two.
std::vector<ExactValue> certain_velocities(double ratio, const cl_I& n) {
  const cl_RA alpha = reference::exact(ratio);
  const long size = std::labs(std::ilogb(ratio));
  std::vector<ExactValue> values;
  constexpr long short_length = 2000;
  if (n * (size + 53) * 2 < short_length || alpha == 1)
    for (const cl_RA& y : members(reference::exact_velocities(alpha, n)))
      values.push_back(exact_value(y));
  if (cln::zerop(n)) return values;  // 1, 0, 0, 0 whatever alpha
  const cl_RA moved = alpha * (1 + cl_RA(1) / cl_RA(cln::ash(cl_I(1), step)));
  const long start = 160 + size + size / 2 + 2 * static_cast<long>(cln::integer_length(n));
  for (long precision = start; precision <= 64 * start; precision += precision / 4) {
    const auto here = members(enclosed_velocities(alpha, n, precision));
    if (values.empty()) {
      if (!std::all_of(here.begin(), here.end(), rounds_alike)) continue;
      for (const Interval& y : here) values.push_back(exact_value(y.low()));
    }
    const auto there = members(enclosed_velocities(moved, n, precision));
    bool all_certain = true;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i].high == 0) continue;
      values[i].condition = condition(here[i], there[i]);
      all_certain = all_certain && values[i].condition >= 0;
    }
    if (all_certain) return values;
  }
  throw Undecided("a velocity stays open at every precision tried");
}

}  // namespace

LargestVelocities largest_velocities(double alpha) {
  // The paper's formulas, typed: a unit of measure. c_n = V_CM (1 + sin((n-1/4) psi)/sin(psi/4)) is largest near a
  // quarter turn, and B gains by each of its collisions. Turns below 1e-6 in size can be taken as continuous.
  using Real = long double;
  const Real ratio = alpha;
  const Real V_CM = 1 / (2 + ratio);
  const Real psi = 4 * std::atan(std::sqrt(ratio * V_CM));
  const Real c_1 = 2 / (1 + ratio);
  LargestVelocities largest{1, static_cast<double>(V_CM * (1 + 1 / std::sin(psi / 4)))};
  if (psi < 1e-6L) return largest;
  const LastCollision last = last_collision(alpha);
  const Real turns_B = static_cast<Real>(last.N_B) * psi / 2;
  // sin(psi) has no digit left where psi is near pi
  largest.B = static_cast<double>(last.N_B == 1 ? c_1 * (2 / (1 + 1 / ratio))
                                                : 2 * V_CM * (1 + ratio) * std::sin(turns_B) *
                                                      std::sin(turns_B + psi / 2));
  const auto quarter = static_cast<std::int64_t>(std::numbers::pi_v<Real> / (2 * psi) + 0.25L);
  Real of_C = c_1;
  for (std::int64_t n = std::max<std::int64_t>(1, quarter - 1);
       n <= std::min(last.N_A, quarter + 2); ++n) {
    const auto at = [&](Real quarters) {
      return std::sin((static_cast<Real>(n) + quarters) * psi) / std::sin(psi / 4);
    };
    of_C = std::max(of_C, V_CM * (1 + at(-0.25L)));
    if (n <= last.N_B) of_C = std::max(of_C, std::fabs(V_CM * (1 - at(0.25L))));
  }
  largest.C = static_cast<double>(of_C);
  return largest;
}

std::vector<ExactValue> exact_velocities(const Input& input) {
  std::vector<ExactValue> values =
      certain_velocities(input.alpha, cl_I(static_cast<long>(input.index)));
  const LastCollision last = last_collision(input.alpha);
  const LargestVelocities largest = largest_velocities(input.alpha);
  const std::array<double, 4> scales{1.0, largest.B, largest.C, largest.C};
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i].exists = input.index <= (i % 2 == 0 ? last.N_A : last.N_B);
    values[i].scale = scales[i];
    values[i].promise_scale = input.alpha > 1 ? 1.0 : scales[i];
  }
  return values;
}

std::vector<ExactValue> exact_terminal(double alpha) {
  const LastCollision last = last_collision(alpha);
  const std::vector<ExactValue> of_A = exact_velocities({alpha, last.N_A});
  const std::vector<ExactValue> of_B =
      last.N_B == last.N_A ? of_A : exact_velocities({alpha, last.N_B});
  return {of_A[0], of_B[1], last.N_B == last.N_A ? of_B[3] : of_A[2]};
}

}  // namespace magicmass::report
