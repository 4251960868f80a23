// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/ratios.hpp"

#include <optional>

#include "magicmass/errors.hpp"
#include "magicmass/reference/decimal.hpp"
#include "magicmass/reference/enclosure.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::reference {
namespace {

using cln::cl_I;
using cln::cl_RA;

/// Raises the precision until convert(Interval) -> optional<Value> answers. The ratio is at least 2^-126, so the
/// start is past its leading bits; being irrational (or, as magic:1, the point 1) it ends no tie's wait.
template <class Value, class Convert>
Value refined(const MassRatio& ratio, long bits, const Convert& convert) {
  const Enclosure source = enclosure(ratio);
  for (long precision = bits + 160;; precision *= 2) {
    const Interval interval = source(precision);
    if (interval.sign() != Sign::positive) {
      continue;
    }
    if (const std::optional<Value> value = convert(interval)) {
      return *value;
    }
  }
}

std::string digits_of(const MassRatio& ratio, int digits) {
  if (digits < 1) {
    throw InvalidInput("the number of digits must be 1 or more, got " + std::to_string(digits));
  }
  return refined<std::string>(
      ratio, 4L * digits, [&](const Interval& x) -> std::optional<std::string> {
        const std::string low = to_decimal(x.low(), digits);
        return low == to_decimal(x.high(), digits) ? std::optional(low) : std::nullopt;
      });
}

template <std::floating_point Float>
Float nearest_of(const MassRatio& ratio) {
  return refined<Float>(ratio, 64, [](const Interval& x) -> std::optional<Float> {
    const auto low = nearest<Float>(x.low());
    return low == nearest<Float>(x.high()) ? std::optional(low) : std::nullopt;
  });
}

cl_RA within(const MassRatio& ratio, long bits) {
  return refined<cl_RA>(ratio, bits, [&](const Interval& x) -> std::optional<cl_RA> {
    const cl_RA low = x.low();
    const bool close = (x.high() - low) * cln::ash(cl_I(1), bits) < low;
    return close ? std::optional(low) : std::nullopt;
  });
}

}  // namespace

std::string ratio_digits(const Magic& ratio, int digits) { return digits_of(ratio, digits); }
std::string ratio_digits(const Deficient& ratio, int digits) { return digits_of(ratio, digits); }

template <std::floating_point Float>
Float nearest_ratio(const Magic& ratio) {
  return nearest_of<Float>(ratio);
}

template <std::floating_point Float>
Float nearest_ratio(const Deficient& ratio) {
  return nearest_of<Float>(ratio);
}

template float nearest_ratio<float>(const Magic&);
template double nearest_ratio<double>(const Magic&);
template long double nearest_ratio<long double>(const Magic&);
template float nearest_ratio<float>(const Deficient&);
template double nearest_ratio<double>(const Deficient&);
template long double nearest_ratio<long double>(const Deficient&);

cl_RA ratio_within(const Magic& ratio, long bits) { return within(ratio, bits); }
cl_RA ratio_within(const Deficient& ratio, long bits) { return within(ratio, bits); }

}  // namespace magicmass::reference
