// SPDX-License-Identifier: GPL-2.0-or-later
// Error and time as the work grows: along a scale, a family for each x.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "report/family.hpp"
#include "report/rows.hpp"
#include "report/statistics.hpp"
#include "report/timing.hpp"

namespace magicmass::report {

struct Scale {
  std::string name;      ///< "n", "alpha"
  std::string words;     ///< "n at alpha = 1e-12"
  std::string quantity;  ///< Quantity::name
  std::vector<double> x;
  std::vector<Family> families;  ///< one for each x
};

/// The velocities against n at one alpha, up to the last collision, and at the last collision against alpha, from 1
/// down; each x with a few inputs close by, so that no lucky one speaks for it.
std::vector<Scale> growth_scales(bool quick);

struct GrowthPoint {
  double x = 0.0;
  double ns = std::numeric_limits<double>::quiet_NaN();
  double max_ulp = std::numeric_limits<double>::quiet_NaN();        ///< over the members
  double over_envelope = std::numeric_limits<double>::quiet_NaN();  ///< over the members
};

/// How a contestant does along a scale; exponents where three points or more have a value.
struct Growth {
  std::string contestant, precision, quantity;
  std::string scale, words;  ///< of the Scale
  std::vector<GrowthPoint> points;
  std::optional<PowerLaw> time, error;
  bool is_reproducible = true;  ///< as the Contestant says
};

using MeasureErrors = std::function<std::vector<ErrorRow>(const Contestant&, const Family&)>;

/// Every contestant of the scale's quantity that can do some of it.
std::vector<Growth> growth_along(const Scale& scale, const std::vector<Contestant>& contestants,
                                 const MeasureErrors& errors, const TimingPlan& plan);

/// Nanoseconds an evaluation against the length of the array of inputs, from the first-level cache to memory. Of a
/// long array each measurement takes the next 4096 inputs, so what it reads has gone through the caches once
/// around. Contestants in double that take one input a call and less than a microsecond on the first that they can do.
std::vector<Growth> growth_with_array_length(const std::string& quantity,
                                             const std::vector<Input>& inputs,
                                             const std::vector<Contestant>& contestants,
                                             const std::vector<std::size_t>& lengths,
                                             const Plan& plan);

/// Nanoseconds against a number that one piece of work takes, such as the digits asked for.
Growth growth_of_work(const std::string& contestant, const Scale& scale,
                      const std::function<void(double x)>& work, const Plan& plan);

}  // namespace magicmass::report
