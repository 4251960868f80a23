// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "command/report/progress.hpp"
#include "report/contestant.hpp"
#include "report/oracle.hpp"

namespace magicmass::command {

/// Errors of one velocity at its last collision, n = N_A or N_B, against alpha.
struct AlphaSweep {
  struct Point {
    double alpha = 0.0;
    double envelope = 0.0;    ///< ulp that rounding alpha alone would cost
    std::vector<double> ulp;  ///< of each evaluator; NaN where there is none
  };
  std::string member;
  std::vector<std::string> evaluators;
  std::vector<Point> points;             ///< in order of alpha
  std::vector<double> magic, deficient;  ///< the thresholds within the points' range
};

/// Of a and of b, for naive, the generated evaluators and the tiers in double; alpha from 0.01 to 1.6, `size` of them.
std::vector<AlphaSweep> alpha_sweeps(const std::vector<report::Contestant>& contestants,
                                     std::size_t size, report::Oracle& oracle, Progress& progress);

}  // namespace magicmass::command
