// SPDX-License-Identifier: GPL-2.0-or-later
// Time beside naive: each implementation and naive on the same inputs, one right after the other.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace report {

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

}  // namespace report
