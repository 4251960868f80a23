// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/exact_value.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <cln/integer.h>

#include "magicmass/reference/rational.hpp"

namespace magicmass::report {
namespace {

template <std::floating_point Real>
Real nearest_of(const ExactValue& exact) {
  if constexpr (std::is_same_v<Real, float>) return exact.nearest_float;
  if constexpr (std::is_same_v<Real, double>) return exact.nearest_double;
  return static_cast<Real>(exact.high);
}

int sign_of(long double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// |error| in units; a scale of 0 has no unit but for no error.
double in_units(long double error, long double unit) {
  if (error == 0) return 0;
  return unit == 0 ? std::numeric_limits<double>::infinity() : static_cast<double>(error / unit);
}

}  // namespace

ExactValue exact_value(const cln::cl_RA& y) {
  ExactValue value;
  value.high = reference::nearest<long double>(y);
  const cln::cl_RA rest = y - reference::exact(value.high);
  value.low = reference::nearest<long double>(rest);
  value.nearest_float = reference::nearest<float>(y);
  value.nearest_double = reference::nearest<double>(y);
  if (value.high != 0) {
    value.binade = std::ilogb(value.high);
    // high may be a power of two that y falls short of
    const bool rounded_up = cln::minusp(rest) != (value.high < 0) && !cln::zerop(rest);
    if (rounded_up && std::scalbn(1.0L, value.binade) == std::fabs(value.high)) --value.binade;
  }
  value.scale = value.promise_scale = static_cast<double>(std::fabs(value.high));
  return value;
}

bool rounding_is_certain(const cln::cl_RA& y, long bits) {
  const cln::cl_RA width = y / cln::cl_RA(cln::ash(cln::cl_I(1), bits));
  const cln::cl_RA below = y - width;
  const cln::cl_RA above = y + width;
  return reference::nearest<float>(below) == reference::nearest<float>(above) &&
         reference::nearest<double>(below) == reference::nearest<double>(above) &&
         reference::nearest<long double>(below) == reference::nearest<long double>(above);
}

template <std::floating_point Real>
Deviation deviation(Real got, const ExactValue& exact) {
  using Limits = std::numeric_limits<Real>;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Deviation result;
  result.has_ulp = exact.high != 0;
  result.correctly_rounded = got == nearest_of<Real>(exact);
  // A value too small for Real rounds to 0, which is then no wrong sign.
  result.wrong_sign =
      std::isnan(got) ||
      (sign_of(static_cast<long double>(got)) != sign_of(exact.high) && !result.correctly_rounded);
  if (!std::isfinite(got)) {
    if (result.correctly_rounded) return result;  // the value itself is out of range
    result.ulp = result.over_envelope = result.has_ulp ? infinity : 0;
    result.eps = result.promise_eps = infinity;
    return result;
  }
  const long double error = std::fabs((static_cast<long double>(got) - exact.high) - exact.low);
  if (result.has_ulp) {
    const int spacing =
        std::clamp(exact.binade - (Limits::digits - 1), Limits::min_exponent - Limits::digits,
                   Limits::max_exponent - Limits::digits);
    result.ulp = static_cast<double>(std::scalbn(error, -spacing));
    result.over_envelope = result.ulp / std::max(0.5, exact.condition / 2);
  }
  const auto eps = static_cast<long double>(Limits::epsilon());
  result.eps = in_units(error, eps * static_cast<long double>(exact.scale));
  result.promise_eps = in_units(error, eps * static_cast<long double>(exact.promise_scale));
  return result;
}

template Deviation deviation<float>(float, const ExactValue&);
template Deviation deviation<double>(double, const ExactValue&);
template Deviation deviation<long double>(long double, const ExactValue&);

}  // namespace magicmass::report
