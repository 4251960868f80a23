// SPDX-License-Identifier: GPL-2.0-or-later
// Errors and times of each implementation on each family.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <cln/rational.h>

#include "magicmass/numbers/values.hpp"
#include "report/families.hpp"
#include "report/implementations.hpp"
#include "report/timing.hpp"

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
