// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/demo/interleaved_timing.hpp"

#include <algorithm>
#include <chrono>

namespace magicmass::command {
namespace {

double nanoseconds(const std::function<void()>& work, int repetitions) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < repetitions; ++i) work();
  const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
  return taken.count();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::vector<Timing> interleaved_timing(const std::vector<std::function<void()>>& works,
                                       std::size_t evaluations, std::size_t baseline) {
  constexpr double shortest_round = 2e5;
  int repetitions = 1;
  for (const auto& work : works)
    while (nanoseconds(work, repetitions) < shortest_round) repetitions *= 2;
  std::vector<std::vector<double>> times(works.size());
  for (int round = 0; round < timing_rounds; ++round)
    for (std::size_t i = 0; i < works.size(); ++i)
      times[i].push_back(nanoseconds(works[i], repetitions) /
                         (repetitions * static_cast<double>(evaluations)));
  std::vector<Timing> timings;
  for (const std::vector<double>& mine : times) {
    std::vector<double> ratios;
    for (std::size_t round = 0; round < mine.size(); ++round)
      ratios.push_back(mine[round] / times[baseline][round]);
    const auto [shortest, longest] = std::minmax_element(mine.begin(), mine.end());
    timings.push_back({median(mine), *shortest, *longest, median(ratios)});
  }
  return timings;
}

}  // namespace magicmass::command
