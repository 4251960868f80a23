// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "report/contestant.hpp"
#include "report/family.hpp"
#include "report/rounds.hpp"
#include "report/rows.hpp"

namespace magicmass::report {

struct TimingPlan {
  Plan rounds = {};
  /// Inputs of a family that are timed, at most: 512 of 16 bytes fit into every first-level cache.
  std::size_t inputs = 512;
  /// A contestant that is expected to take longer for a pass over its inputs samples half of them, or half of these, ...
  double longest_pass_ns = 1e6;
  double longest_call_ns = 2e7;  ///< inputs that are expected to take longer are not timed
};

/// One row for each family and contestant of its quantity, families in their order; a contestant without an input
/// that it can do has none. Ratios are to the naive contestant in double, on the same inputs, without an interval:
/// rounds of one process share its memory layout, see batches.hpp. All are timed in one set of interleaved
/// rounds; after fewer than 6 of those that were planned, stopped early, there are no rows.
std::vector<TimeRow> time_families(const std::vector<Contestant>& contestants,
                                   const std::vector<Family>& families, const TimingPlan& plan);

/// The inputs on which a contestant is timed, in an order that has nothing to do with the family's: the same in every
/// run.
std::vector<Input> timed_inputs(const Contestant& contestant, std::span<const Input> inputs,
                                const TimingPlan& plan);

/// Of each input the shortest of several single calls, of these the longest; less what the clock takes itself.
struct SlowestCall {
  double ns = 0.0;
  Input input{};
};
SlowestCall slowest_call(const Contestant& contestant, std::span<const Input> inputs);

}  // namespace magicmass::report
