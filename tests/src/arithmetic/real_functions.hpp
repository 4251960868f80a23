// SPDX-License-Identifier: GPL-2.0-or-later
// CLN's arctangent, sine and cosine of rationals, some 300 bits of them.
#pragma once

#include <cln/float.h>
#include <cln/rational.h>
#include <cln/real.h>

namespace magicmass::testing {

inline cln::cl_F real(const cln::cl_RA& x) {
  static const cln::float_format_t digits = cln::float_format(90);
  return cln::cl_float(x, digits);
}
inline cln::cl_RA exact_arctangent(const cln::cl_RA& x) {
  return x == 0 ? x : cln::rational(cln::realpart(cln::atan(real(x))));
}
inline cln::cl_RA exact_sine(const cln::cl_RA& x) {
  return x == 0 ? x : cln::rational(cln::sin(real(x)));
}
inline cln::cl_RA exact_cosine(const cln::cl_RA& x) {
  return x == 0 ? cln::cl_RA(1) : cln::rational(cln::cos(real(x)));
}

}  // namespace magicmass::testing
