// SPDX-License-Identifier: GPL-2.0-or-later
// Rounds of one process share its memory layout, and of compiled formulas the order of terms, so they say nothing of
// the next run's. Batches of rounds, each in a process of its own, do.
#pragma once

#include <cstddef>
#include <vector>

#include "report/rows.hpp"

namespace magicmass::report {

/// So many rounds in all, or a few more, split among batches. 9 batches, as an interval of the median between the second
/// and the second last has 95 %; 6, the fewest that give one, where there are few rounds.
struct BatchPlan {
  std::size_t batches = 9;
  std::size_t rounds = 6;  ///< of each
};
BatchPlan batch_plan(std::size_t rounds);

/// Rows of the batches, each as time_families gives them, made one row each: medians of the medians, the least minimum,
/// the ratio's interval by median_interval over the batches and never narrower than what the clock can tell. Rows
/// that are not in every batch are left out; fewer than 6 batches, stopped early, give no interval.
std::vector<TimeRow> combined(const std::vector<std::vector<TimeRow>>& batches);

}  // namespace magicmass::report
