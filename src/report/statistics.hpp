// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace magicmass::report {

/// Throws std::invalid_argument for no values. Of an even number: the mean of the middle two.
double median(std::vector<double> values);

struct Range {
  double low = 0.0, high = 0.0;
};

/// A 95 % interval of the median, between two of the values: whatever the distribution, a value is below the median
/// as often as above it, so the ranks follow from the binomial distribution. Nothing for fewer than 6 values.
std::optional<Range> median_interval(std::vector<double> values);

struct Point {
  double x = 0.0, y = 0.0;
};

/// y = constant * x^exponent; spread is the standard error of the exponent.
struct PowerLaw {
  double exponent = 0.0, spread = 0.0;
};

/// Least squares through (log x, log y), over the points where both are positive and finite; nothing for fewer than
/// three of them or a single x.
std::optional<PowerLaw> fit_power_law(std::span<const Point> points);

}  // namespace magicmass::report
