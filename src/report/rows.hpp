// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "report/contestant.hpp"

namespace magicmass::report {

/// Where the exact value is 0 there is no ulp and no envelope: such a sample counts in correctly_rounded, wrong_signs
/// and max_eps alone. A result that is not finite has infinite errors. max_ulp, over_envelope, max_eps and
/// max_promise_eps include the climb; the other figures are of the family's own samples.
/// Counts are whole numbers whatever they were computed in: for them ulp is the difference itself, the rest is 0.
/// Errors of one member of one contestant on one family; ulp are those of the contestant's precision.
struct ErrorRow {
  std::string contestant, precision, quantity, member, family;
  std::size_t samples = 0;  ///< inputs of the family that this contestant can take and that exist
  std::size_t climbed = 0;  ///< further inputs tried on the way up from the worst samples
  double max_ulp = 0.0;
  Input worst{};         ///< where max_ulp was seen
  double ulp_999 = 0.0;  ///< 99.9 percentile
  double ulp_median = 0.0;
  double correctly_rounded = 0.0;  ///< share, 0 to 1
  std::size_t wrong_signs = 0;
  double over_envelope = 0.0;   ///< largest error over what rounding alpha alone would cost
  double max_eps = 0.0;         ///< largest absolute error in eps of the body's largest velocity
  Input worst_over_envelope{};  ///< where over_envelope was seen
  double max_promise_eps =
      0.0;  ///< largest error in the unit of eps_bound: as max_eps, but eps V beyond alpha = 1
  Input worst_eps{};         ///< where max_promise_eps was seen
  bool promise_kept = true;  ///< true where nothing is promised
  std::size_t wrong = 0;     ///< counts: answers that are not the exact ones
  std::size_t misrounded =
      0;  ///< answers that are not the nearest ones, those of the climb included
};

/// Times of one contestant on one family.
struct TimeRow {
  std::string contestant, precision, quantity, family;
  double ns_median = 0.0, ns_minimum = 0.0;  ///< throughput, per evaluation
  double latency_ns = 0.0;
  double ratio = 0.0;  ///< paired, to naive in double: the median of the batches
  double ratio_low = 0.0, ratio_high = 0.0;  ///< 95 % interval; NaN for a batch by itself
  double slowest_call_ns = 0.0;  ///< one single call; of what works on arrays, with one input
  Input slowest{};               ///< where that was
  std::optional<double> cycles;  ///< from a loop calibrated in the same run
  std::size_t inputs = 0;  ///< timed: a contestant skips what it cannot do, a slow one samples
  std::size_t rounds = 0;
  std::size_t batches = 1;  ///< of rounds, each in a process of its own
  bool is_steady = true;    ///< false: the batches disagree, the interval is wider than a tenth
};

}  // namespace magicmass::report
