// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "report/contestant.hpp"
#include "report/exact_value.hpp"

namespace magicmass::report {

/// Exact values of everything that is measured. Velocities, counts and ratios are those of src/magicmass/reference;
/// times, distances and angles come from CLN's own functions. No line is shared with an evaluator, and the precision
/// is raised until float, double and long double have one nearest number each. Values are kept, so that
/// contestants asked the same question pay once.
class Oracle {
public:
  /// The quantity's members in order. alpha positive and finite, index in the quantity's domain, else throws
  /// InvalidInput; Undecided if a rounding stayed open at a precision far beyond what it takes (never seen). The
  /// reference lives until forget.
  const std::vector<ExactValue>& at(const std::string& quantity, const Input& input);

  /// Drops what was kept.
  void forget() { known_.clear(); }

private:
  std::map<std::pair<std::string, std::pair<double, std::int64_t>>, std::vector<ExactValue>> known_;
};

}  // namespace magicmass::report
