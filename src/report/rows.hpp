// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "report/contestant.hpp"

namespace magicmass::report {

/// Errors of one member of one contestant on one family; ulp are those of the contestant's precision.
struct ErrorRow {
  std::string contestant, precision, quantity, member, family;
  std::size_t samples = 0;
  double max_ulp = 0.0;
  Input worst{};         ///< where max_ulp was seen
  double ulp_999 = 0.0;  ///< 99.9 percentile
  double ulp_median = 0.0;
  double correctly_rounded = 0.0;  ///< share, 0 to 1
  std::size_t wrong_signs = 0;
  double over_envelope = 0.0;  ///< largest error over what rounding alpha alone would cost
  double max_eps = 0.0;        ///< largest absolute error in eps of the body's largest velocity
  std::size_t wrong = 0;       ///< counts: answers that are not the exact ones
};

/// Times of one contestant on one family.
struct TimeRow {
  std::string contestant, precision, quantity, family;
  double ns_median = 0.0, ns_minimum = 0.0;  ///< throughput, per evaluation
  double latency_ns = 0.0;
  double ratio = 0.0, ratio_low = 0.0,
         ratio_high = 0.0;       ///< paired, to naive in double; 95 % interval
  double slowest_call_ns = 0.0;  ///< one single call
  Input slowest{};               ///< where that was
  std::optional<double> cycles;  ///< from a loop calibrated in the same run
  std::size_t inputs = 0;  ///< timed: a contestant skips what it cannot do, a slow one samples
  std::size_t rounds = 0;
};

}  // namespace magicmass::report
