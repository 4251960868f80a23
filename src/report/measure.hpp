// SPDX-License-Identifier: GPL-2.0-or-later
// Errors and times of each implementation on each family.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <cln/rational.h>

#include "magicmass/numbers/values.hpp"
#include "report/implementations.hpp"

namespace report {

struct Truth {
  Input input;
  std::vector<cln::cl_RA> values = {};  ///< exact where n is small, else to 120 bits
  std::vector<double> rounded = {};     ///< the nearest doubles, with certainty
  std::vector<double> envelopes = {};   ///< max(1/2, |alpha y'/(2 y)|) in ulp; infinite where y = 0
  std::optional<magicmass::Counts> counts = {};  ///< of terminal and counts
};
Truth truth(Quantity quantity, const Input& input);

/// Where the exact value is 0 only 0 is right, and there is no ulp error. Counts have errors of
/// their own only where nothing else is asked: |got - exact|.
struct Errors {
  std::size_t samples = 0;
  double max_ulp = 0;        ///< infinite where a result is not finite
  Input worst = {};          ///< the input of max_ulp, or of the first wrong answer where that is 0
  double over_envelope = 0;  ///< the largest error over its envelope
  std::size_t misrounded = 0;  ///< values other than the nearest double
  std::size_t wrong = 0;       ///< counts, and values of the wrong sign
  friend bool operator==(const Errors&, const Errors&) = default;
};
/// Row i of the results belongs to truths[i].
Errors errors_of(const Columns& results, std::span<const Truth* const> truths);

struct Pair {
  std::function<void()> naive, ours;
  std::size_t evaluations;  ///< of one call of either
};
struct Times {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  double ns = none;                            ///< of one evaluation, the rounds' median
  double ratio = none;                         ///< ours over naive, the rounds' median
  double ratio_low = none, ratio_high = none;  ///< the least and the largest of the rounds
};
struct Rounds {
  std::size_t count = 9;
  double shortest_ns = 1e6;  ///< of one measurement
};

/// In each round each pair comes once, in random order, and in it either one first: what disturbs
/// the machine for a while disturbs a pair alike. A call that is not timed goes before each
/// measurement, and calls are repeated until it is long enough.
std::vector<Times> timed(const std::vector<Pair>& pairs, const Rounds& rounds);

struct Plan {
  std::vector<Implementation> implementations = report::implementations();
  std::size_t draws = 1000;  ///< of a family
  Rounds rounds = {};        ///< none: errors alone
  std::string only = {};     ///< a quantity, family or evaluator; "" for all
};

struct Measurement {
  std::string evaluator;
  Quantity quantity;
  std::string family;
  Errors errors;
  Times times;
};

/// A measurement for each implementation that takes any input of the family. Where there are
/// rounds, a quantity's first implementation is "naive".
std::vector<Measurement> measure(const Plan& plan);

}  // namespace report
