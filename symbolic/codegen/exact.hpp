// SPDX-License-Identifier: GPL-2.0-or-later
// Between rationals and doubles, exactly; and numbers as the generator prints them.
#pragma once

#include <string>

#include <cln/rational.h>

namespace codegen {
cln::cl_RA exact(double x);           ///< Refused: NaN, infinity
double nearest(const cln::cl_RA& x);  ///< ties to even; |x| from 2^-960 to 2^1000, or 0
double upper(const cln::cl_RA& x);    ///< a double that is at least x
bool is_double(const cln::cl_RA& x);
bool is_power_of_2(double x);  ///< or minus one
/// pi, off by less than 2^-400.
const cln::cl_RA& pi();

std::string hex(double x);
/// "2^-73.6", at least x.
std::string as_power_of_2(double x);
}  // namespace codegen
