// SPDX-License-Identifier: GPL-2.0-or-later
// Not Google Benchmark: that times one after the other, and has no ratio paired round by round.
#include "report/timing.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <numeric>
#include <random>

namespace report {
namespace {

double nanoseconds(const std::function<void()>& work, std::size_t repetitions) {
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < repetitions; ++i) work();
  const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
  return taken.count();
}

std::size_t long_enough(const std::function<void()>& work, double shortest_ns) {
  std::size_t repetitions = 1;
  while (nanoseconds(work, repetitions) < shortest_ns) repetitions *= 2;
  return repetitions;
}

}  // namespace

std::vector<Times> timed(const std::vector<Pair>& pairs, const Rounds& rounds) {
  struct Seen {
    std::array<std::size_t, 2> repetitions;
    std::vector<double> ns = {}, ratios = {};
  };
  std::vector<Seen> seen;
  for (const Pair& pair : pairs)
    seen.push_back({{long_enough(pair.naive, rounds.shortest_ns),
                     long_enough(pair.ours, rounds.shortest_ns)}});
  std::mt19937_64 random(1);
  std::array<std::size_t, 2> sides{0, 1};  // naive, ours
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t round = 0; round < rounds.count; ++round) {
    std::ranges::shuffle(order, random);
    for (const std::size_t i : order) {
      std::array<double, 2> ns{};
      std::ranges::shuffle(sides, random);
      for (const std::size_t which : sides) {
        const auto& work = which == 0 ? pairs[i].naive : pairs[i].ours;
        work();
        ns[which] = nanoseconds(work, seen[i].repetitions[which]) /
                    double(seen[i].repetitions[which] * pairs[i].evaluations);
      }
      seen[i].ns.push_back(ns[1]);
      seen[i].ratios.push_back(ns[1] / ns[0]);
    }
  }
  std::vector<Times> times;
  for (Seen& one : seen) {
    std::sort(one.ns.begin(), one.ns.end());
    std::sort(one.ratios.begin(), one.ratios.end());
    const std::size_t middle = rounds.count / 2;
    times.push_back({one.ns[middle], one.ratios[middle], one.ratios.front(), one.ratios.back()});
  }
  return times;
}

}  // namespace report
