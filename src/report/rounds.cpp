// SPDX-License-Identifier: GPL-2.0-or-later
// Not Google Benchmark: it times one candidate after the other, and has no ratio paired round by round.
#include "report/rounds.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>

namespace magicmass::report {
namespace {

std::size_t long_enough(const Timed& timed, double shortest_ns) {
  constexpr std::size_t most = std::size_t{1} << 40U;  // of work that the compiler has removed
  std::size_t repetitions = 1;
  while (timed.nanoseconds(repetitions) < shortest_ns && repetitions < most) repetitions *= 2;
  return repetitions;
}

}  // namespace

std::function<double(std::size_t)> on_steady_clock(std::function<void()> work) {
  return [work = std::move(work)](std::size_t repetitions) {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < repetitions; ++i) work();
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
    return taken.count();
  };
}

double clock_tick() {
  using Clock = std::chrono::steady_clock;
  std::chrono::duration<double, std::nano> least = std::chrono::seconds(1);
  for (int i = 0; i < 1000; ++i) {
    const auto start = Clock::now();
    auto next = Clock::now();
    while (next == start) next = Clock::now();
    least = std::min<std::chrono::duration<double, std::nano>>(least, next - start);
  }
  return least.count();
}

std::vector<std::size_t> RandomOrder::next(std::size_t size) {
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t left = size; left > 1; --left)
    std::swap(order[left - 1], order[random_.next() % left]);
  return order;
}

RoundTimes interleaved_rounds(const std::vector<Group>& groups, const Plan& plan) {
  const double shortest_ns = std::max(plan.shortest_ns, 1000 * clock_tick());
  RandomOrder order(plan.seed);
  RoundTimes times;
  std::vector<std::vector<std::size_t>> repetitions;
  for (const Group& group : groups) {
    times.emplace_back(group.size());
    repetitions.emplace_back();
    if (!plan.go_on(0.0)) continue;
    for (const Timed& timed : group) repetitions.back().push_back(long_enough(timed, shortest_ns));
  }
  const auto all = static_cast<double>(plan.rounds * std::max<std::size_t>(groups.size(), 1));
  double done = 0.0;
  for (std::size_t round = 0; round < plan.rounds; ++round)
    for (const std::size_t g : order.next(groups.size())) {
      if (!plan.go_on(done / all) || repetitions[g].size() != groups[g].size()) return times;
      for (const std::size_t i : order.next(groups[g].size())) {
        const Timed& timed = groups[g][i];
        timed.nanoseconds(1);
        times[g][i].push_back(timed.nanoseconds(repetitions[g][i]) /
                              (static_cast<double>(repetitions[g][i]) * timed.evaluations));
      }
      done += 1.0;
    }
  return times;
}

}  // namespace magicmass::report
