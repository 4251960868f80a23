// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <vector>

namespace magicmass::command {

/// Nanoseconds an evaluation over all rounds, and the median over rounds of the ratio to the baseline's time in
/// the same round.
struct Timing {
  double median;
  double shortest;
  double longest;
  double ratio;
};

inline constexpr int timing_rounds = 31;

/// Each piece of work makes `evaluations` evaluations a call. In every round each of them runs once for about a
/// fifth of a millisecond or more, one after the other, so that what disturbs the machine disturbs them alike.
std::vector<Timing> interleaved_timing(const std::vector<std::function<void()>>& works,
                                       std::size_t evaluations, std::size_t baseline);

}  // namespace magicmass::command
