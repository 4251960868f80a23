// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <tuple>
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
  /// reference lives as long as the oracle.
  const std::vector<ExactValue>& at(const std::string& quantity, const Input& input,
                                    const std::string& derived_form = "");

  /// Exact values of one form of a quantity that the oracle does not know by itself, from a formula evaluated elsewhere;
  /// members that have no value at an input do not exist there. Throws std::logic_error for a quantity that it
  /// knows: of that each form has the same values.
  using Formula = std::function<std::vector<ExactValue>(const Input&)>;
  void learn(const std::string& quantity, const std::string& derived_form, Formula formula);

private:
  std::map<std::tuple<std::string, std::string, double, std::int64_t, double>,
           std::vector<ExactValue>>
      known_;
  std::map<std::pair<std::string, std::string>, Formula> learnt_;
};

}  // namespace magicmass::report
