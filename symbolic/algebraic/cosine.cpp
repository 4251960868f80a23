// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/cosine.hpp"

#include <cln/float.h>
#include <cln/real.h>

namespace magicmass::algebraic {
namespace {

using cln::cl_F;
using cln::cl_I;
using cln::cl_RA;

/// CLN works with 64 bits more than asked, and more by the size of a small angle; its manual promises pi, cos and
/// sin to about the last place, and 2^32 times that is allowed here.
Interval allowed(const cl_F& value, long precision) {
  const cl_RA exact = cln::rational(value);
  const cl_RA slack = cln::abs(exact) / cln::ash(cl_I(1), precision + 32);
  return {exact - slack, exact + slack, precision + 8};
}

}  // namespace

Interval cosine_of_turn(const cl_RA& turn, long precision) {
  cl_RA t = turn - cln::floor1(turn);
  if (t > cl_RA(1) / 2) t = 1 - t;
  if (t > cl_RA(1) / 4) return -cosine_of_turn(cl_RA(1) / 2 - t, precision);
  if (cln::zerop(t)) return {1, precision};
  if (t == cl_RA(1) / 4) return {0, precision};
  if (t == cl_RA(1) / 6) return {cl_RA(1) / 2, precision};
  const long guard = 64 + 2 * static_cast<long>(cln::integer_length(cln::denominator(t)));
  const cln::float_format_t format = cln::float_format(
      static_cast<unsigned long>(static_cast<double>(precision + guard) * 0.30103) + 3);
  const cl_F pi = cln::pi(format);
  return t <= cl_RA(1) / 8
             ? allowed(cln::cos(pi * cln::cl_float(2 * t, format)), precision)
             : allowed(cln::sin(pi * cln::cl_float(cl_RA(1) / 2 - 2 * t, format)), precision);
}

}  // namespace magicmass::algebraic
