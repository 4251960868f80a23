// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace magicmass::report {
namespace {

/// Least rank r >= 1, counted from 0, with P(fewer than r + 1 of `size` fair coins fall heads) > 2.5 %: between the
/// values of this rank from either end the median lies with 95 % or more.
std::optional<std::size_t> outer_rank(std::size_t size) {
  double probability = std::pow(0.5, static_cast<double>(size));  // of no heads
  double fewer = probability;
  if (fewer > 0.025) return std::nullopt;
  std::size_t rank = 0;
  while (true) {
    probability *= static_cast<double>(size - rank) / static_cast<double>(rank + 1);
    if (fewer + probability > 0.025) return rank;
    fewer += probability;
    ++rank;
  }
}

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) throw std::invalid_argument("median of no values");
  const std::size_t half = values.size() / 2;
  std::sort(values.begin(), values.end());
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::optional<Range> median_interval(std::vector<double> values) {
  const std::optional<std::size_t> rank = outer_rank(values.size());
  if (!rank) return std::nullopt;
  std::sort(values.begin(), values.end());
  return Range{values[*rank], values[values.size() - 1 - *rank]};
}

std::optional<PowerLaw> fit_power_law(std::span<const Point> points) {
  std::vector<Point> logs;
  for (const Point& point : points)
    if (point.x > 0 && point.y > 0 && std::isfinite(point.x) && std::isfinite(point.y))
      logs.push_back({std::log(point.x), std::log(point.y)});
  const auto size = static_cast<double>(logs.size());
  if (logs.size() < 3) return std::nullopt;
  Point mean;
  for (const Point& point : logs) mean = {mean.x + point.x / size, mean.y + point.y / size};
  double xx = 0.0;
  double xy = 0.0;
  for (const Point& point : logs) {
    xx += (point.x - mean.x) * (point.x - mean.x);
    xy += (point.x - mean.x) * (point.y - mean.y);
  }
  if (xx == 0.0) return std::nullopt;
  const double exponent = xy / xx;
  double squares = 0.0;
  for (const Point& point : logs) {
    const double residual = point.y - mean.y - exponent * (point.x - mean.x);
    squares += residual * residual;
  }
  return PowerLaw{exponent, std::sqrt(squares / (size - 2) / xx)};
}

}  // namespace magicmass::report
