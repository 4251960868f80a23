// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <concepts>

#include <cln/rational.h>

namespace magicmass::report {

/// What an evaluator should have returned for one member, ready to be compared with in machine numbers.
struct ExactValue {
  bool exists = true;  ///< false: no such collision; the formula goes on, physics does not
  long double high = 0,
              low = 0;      ///< their sum is the value within 2^-120 of it, high alone its nearest
  float nearest_float = 0;  ///< the value correctly rounded
  double nearest_double = 0;
  int binade = 0;        ///< floor(log2 |value|); of no meaning where the value is 0
  double condition = 0;  ///< |alpha y'/y|: relative change for a relative change of alpha
  double scale =
      0;  ///< the body's largest velocity at that alpha; for what has no body the value itself
  double promise_scale = 0;  ///< the same, but V (1) for velocities beyond alpha = 1
};

/// y as ExactValue; scales are |y| until told otherwise.
ExactValue exact_value(const cln::cl_RA& y);

/// Do all of float, double and long double round every number within relative 2^-bits of y alike?
bool rounding_is_certain(const cln::cl_RA& y, long bits);

/// How one result compares. At an exact zero ulp and over_envelope are 0.
struct Deviation {
  double ulp = 0;            ///< |got - exact| over the spacing of Real at exact
  double over_envelope = 0;  ///< ulp over max(1/2, condition/2)
  double eps = 0;            ///< |got - exact| in eps of Real times scale
  double promise_eps = 0;    ///< the same with promise_scale
  bool has_ulp = false;      ///< the exact value is not 0
  bool correctly_rounded = false;
  bool wrong_sign = false;  ///< 0 is a sign of its own; NaN has none of them
};

template <std::floating_point Real>
Deviation deviation(Real got, const ExactValue& exact);

}  // namespace magicmass::report
