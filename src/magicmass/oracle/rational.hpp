// Between doubles and exact rationals; every rounding is to nearest, ties to even.
#pragma once

#include <string>

#include <cln/integer.h>
#include <cln/rational.h>

namespace magicmass::oracle {

using cln::cl_I;
using cln::cl_RA;

/// The value of a finite double, exactly. Throws std::invalid_argument for an infinity or NaN.
cl_RA exact(double value);

/// The double nearest to x: ties to even, subnormals as they are spaced, infinity from the largest
/// finite double plus half its spacing on.
double nearest(const cl_RA& x);

/// |got - exact| / ulp(exact), rounded to nearest; ulp(y) is the spacing of doubles in the binade
/// of |y|, 2^-1074 below the normal range, 2^971 above it. Infinity if got is not finite.
double ulp_error(double got, const cl_RA& exact_value);

/// Bits of numerator and denominator together.
long length(const cl_RA& x);

/// "p/q" in lowest terms with q > 1, or "p".
std::string to_text(const cl_RA& x);

}  // namespace magicmass::oracle
