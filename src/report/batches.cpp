// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/batches.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "report/statistics.hpp"

namespace magicmass::report {
namespace {

constexpr std::size_t fewest = 6;  // that have an interval, see median_interval
constexpr std::size_t usual = 9;
/// A measurement takes 1000 ticks of the clock at least, a ratio is of two.
constexpr double resolution = 0.002;
constexpr double widest_steady = 0.1;

bool is_same(const TimeRow& one, const TimeRow& other) {
  return one.contestant == other.contestant && one.precision == other.precision &&
         one.quantity == other.quantity && one.family == other.family;
}

std::vector<double> values(const std::vector<TimeRow>& rows, double TimeRow::*member) {
  std::vector<double> all;
  for (const TimeRow& row : rows) all.push_back(row.*member);
  return all;
}

void set_ratio(TimeRow& row, const std::vector<TimeRow>& of_batches) {
  const std::vector<double> ratios = values(of_batches, &TimeRow::ratio);
  if (std::any_of(ratios.begin(), ratios.end(), [](double ratio) { return std::isnan(ratio); }))
    return;
  row.ratio = median(ratios);
  const std::optional<Range> range = median_interval(ratios);
  if (!range) return;
  const bool is_itself = range->low == 1.0 && range->high == 1.0;  // naive to naive
  const double least = is_itself ? 0.0 : resolution * row.ratio;
  row.ratio_low = std::min(range->low, row.ratio - least);
  row.ratio_high = std::max(range->high, row.ratio + least);
  row.is_steady = row.ratio_high - row.ratio_low <= widest_steady * row.ratio;
}

TimeRow combined_row(const std::vector<TimeRow>& of_batches) {
  TimeRow row = of_batches.front();
  const std::vector<double> minima = values(of_batches, &TimeRow::ns_minimum);
  row.ns_minimum = *std::min_element(minima.begin(), minima.end());
  for (double TimeRow::*member : {&TimeRow::ns_median, &TimeRow::latency_ns})
    row.*member = median(values(of_batches, member));
  std::vector<TimeRow> by_slowest = of_batches;
  std::sort(by_slowest.begin(), by_slowest.end(), [](const TimeRow& one, const TimeRow& other) {
    return one.slowest_call_ns < other.slowest_call_ns;
  });
  row.slowest_call_ns = by_slowest[by_slowest.size() / 2].slowest_call_ns;
  row.slowest = by_slowest[by_slowest.size() / 2].slowest;
  set_ratio(row, of_batches);
  row.rounds = 0;
  std::vector<double> cycles;
  for (const TimeRow& batch : of_batches) {
    row.rounds += batch.rounds;
    if (batch.cycles) cycles.push_back(*batch.cycles);
  }
  if (!cycles.empty()) row.cycles = median(cycles);
  row.batches = of_batches.size();
  return row;
}

}  // namespace

BatchPlan batch_plan(std::size_t rounds) {
  const std::size_t batches = std::clamp(rounds / 5, fewest, usual);
  return {batches, (rounds + batches - 1) / batches};
}

std::vector<TimeRow> combined(const std::vector<std::vector<TimeRow>>& batches) {
  std::vector<TimeRow> rows;
  if (batches.empty()) return rows;
  for (const TimeRow& first : batches.front()) {
    std::vector<TimeRow> same;
    for (const std::vector<TimeRow>& batch : batches) {
      const auto found = std::find_if(batch.begin(), batch.end(),
                                      [&](const TimeRow& row) { return is_same(row, first); });
      if (found != batch.end()) same.push_back(*found);
    }
    if (same.size() == batches.size()) rows.push_back(combined_row(same));
  }
  return rows;
}

}  // namespace magicmass::report
