// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/exact_angles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational.h>
#include <cln/real.h>

#include "magicmass/errors.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/simulator/three_body.hpp"
#include "report/last_collision.hpp"

namespace magicmass::report {
namespace {

using cln::cl_F;
using cln::cl_I;
using cln::cl_RA;

/// A number and a bound of its relative error, 2^-certain_bits.
struct Approximate {
  cl_F value;
  double certain_bits;
};

/// psi with `precision` bits. The quotient, its root and the arctangent cost a few units each; CLN's manual promises
/// about one a function, and 2^6 in all are allowed for.
cl_F angle(const cl_RA& alpha, long precision) {
  const auto digits = static_cast<unsigned long>(static_cast<double>(precision) * 0.30103) + 2;
  const cl_F quotient = cln::cl_float(alpha / (alpha + 2), cln::float_format(digits));
  return cln::cl_float(cln::atan(cln::sqrt(quotient)), quotient) * cln::cl_float(4, quotient);
}

/// sin(m h), 0 < m h < pi. The argument is good to precision - 7 bits, so the sine to as many less
/// log2(m h/|sin(m h)|), of which 2 are given to everything else.
Approximate sine(const cl_I& m, const cl_F& psi, long precision) {
  const cl_F argument = psi * cln::cl_float(m, psi) / cln::cl_float(2, psi);
  const cl_F value = cln::sin(argument);
  const double growth = cln::double_approx(cln::abs(argument / value));
  return {value, static_cast<double>(precision) - 9 - std::log2(growth + 1)};
}

struct Encounter {
  Approximate t;
  Approximate s;
};

Encounter encounter(const cl_RA& alpha, const cl_I& j, long precision) {
  const cl_F psi = angle(alpha, precision);
  const Approximate below = sine(j + 1, psi, precision);
  const Approximate of_j = sine(j, psi, precision);
  const Approximate of_1 = sine(1, psi, precision);
  const auto bits = [&](const Approximate& above) {
    return std::min(above.certain_bits, below.certain_bits) - 2;
  };
  return {{of_j.value / below.value, bits(of_j)}, {of_1.value / below.value, bits(of_1)}};
}

bool is_certain(const Approximate& y) {
  constexpr double least = 160;
  return y.certain_bits >= least &&
         rounding_is_certain(cln::rational(y.value), static_cast<long>(y.certain_bits));
}

constexpr long first_precision = 256;
constexpr long last_precision = 1L << 14;

/// Raises the precision until compute(precision) has members that all round for certain.
template <class Compute>
auto certain(const Compute& compute) {
  for (long precision = first_precision; precision <= last_precision; precision *= 2)
    if (const auto values = compute(precision); values.second) return values.first;
  throw Undecided("a rounding stays open at every precision tried");
}

/// |alpha y'/y| by the change that alpha (1 + 2^-step_of_angles) makes; that is a third of the precision, so that the
/// difference keeps as much and the curvature costs as much.
constexpr long step_of_angles = 85;
double condition(const cl_F& here, const cl_F& moved) {
  return std::fabs(
      std::ldexp(cln::double_approx((moved - here) / here), static_cast<int>(step_of_angles)));
}
cl_RA moved(const cl_RA& alpha) {
  return alpha * (1 + cl_RA(1) / cl_RA(cln::ash(cl_I(1), step_of_angles)));
}

/// By events in exact rationals: the collision law alone, and the only ones with a tie (t_1 = s_1 = (1+alpha)/2).
std::array<cl_RA, 2> stepped(const cl_RA& alpha, std::int64_t j) {
  const Event<cl_RA> last =
      record_three_body<cl_RA>(alpha, cl_RA(1), cl_RA(1), j + 1).events.back();
  return {last.time, last.positions.b - last.positions.a};
}

}  // namespace

std::vector<ExactValue> exact_angle(const Input& input) {
  const cl_RA alpha = reference::exact(input.alpha);
  const cl_F psi = certain([&](long precision) {
    const cl_F value = angle(alpha, precision);
    return std::pair(value, is_certain({value, static_cast<double>(precision) - 6}));
  });
  ExactValue value = exact_value(cln::rational(psi));
  value.condition = condition(angle(alpha, first_precision), angle(moved(alpha), first_precision));
  return {value};
}

std::vector<ExactValue> exact_encounter(const Input& input) {
  const cl_RA alpha = reference::exact(input.alpha);
  const cl_I j(static_cast<long>(input.index));
  if (input.index >= last_collision(input.alpha).total()) {
    ExactValue none;
    none.exists = false;
    return {none, none};
  }
  std::vector<ExactValue> values;
  constexpr std::int64_t stepped_up_to = 2;
  if (input.index <= stepped_up_to) {
    const auto there = stepped(moved(alpha), input.index);
    for (const cl_RA& y : stepped(alpha, input.index)) {
      values.push_back(exact_value(y));
      if (input.index == 0) continue;  // t_0 = 0 and s_0 = L whatever alpha
      const cl_RA change =
          (there[values.size() - 1] - y) / y * cl_RA(cln::ash(cl_I(1), step_of_angles));
      values.back().condition = reference::nearest<double>(cln::abs(change));
    }
    return values;
  }
  const Encounter one = certain([&](long precision) {
    const Encounter found = encounter(alpha, j, precision);
    return std::pair(found, is_certain(found.t) && is_certain(found.s));
  });
  values = {exact_value(cln::rational(one.t.value)), exact_value(cln::rational(one.s.value))};
  // j up to 2^63 next to a pole costs 126 bits of the difference's own
  constexpr long precision = 3 * first_precision;
  const Encounter here = encounter(alpha, j, precision);
  const Encounter there = encounter(moved(alpha), j, precision);
  values[0].condition = condition(here.t.value, there.t.value);
  values[1].condition = condition(here.s.value, there.s.value);
  return values;
}

}  // namespace magicmass::report
