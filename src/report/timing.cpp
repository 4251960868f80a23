// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/timing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>

#include "report/errors.hpp"
#include "report/processor_clock.hpp"
#include "report/quantities.hpp"
#include "report/statistics.hpp"

namespace magicmass::report {
namespace {

using Inputs = std::shared_ptr<const std::vector<Input>>;

bool same(const std::vector<Input>& left, const std::vector<Input>& right) {
  return std::equal(left.begin(), left.end(), right.begin(), right.end(),
                    [](const Input& one, const Input& other) {
                      return one.alpha == other.alpha && one.index == other.index &&
                             one.e == other.e;
                    });
}

double once(const std::function<void()>& work) { return on_steady_clock(work)(1); }

double one_call(const Contestant& contestant, const Input& input) {
  const std::span<const Input> one(&input, 1);
  if (contestant.own_clock) return contestant.own_clock(one, 1);
  if (contestant.prepare) return once(contestant.prepare(one).run);
  return once([&] { contestant.evaluate_all(one); });
}

/// Contestants timed on the same inputs of one family, the naive one among them.
struct Comparison {
  const Family* family;
  Inputs inputs;
  std::vector<const Contestant*> contestants;
  std::optional<std::size_t> baseline;
  std::size_t rows = 0;  ///< the first so many contestants want a row here
};

std::vector<Comparison> comparisons(const std::vector<Contestant>& contestants,
                                    const std::vector<Family>& families, const TimingPlan& plan) {
  std::vector<Comparison> all;
  for (const Family& family : families) {
    const std::size_t begin = all.size();
    const Contestant* naive = nullptr;
    for (const Contestant& contestant : contestants) {
      if (contestant.quantity != family.quantity || !plan.rounds.go_on(0.0)) continue;
      if (contestant.is_naive && contestant.precision == "double") naive = &contestant;
      std::vector<Input> inputs = timed_inputs(contestant, family.inputs, plan);
      if (inputs.empty()) continue;
      auto found = std::find_if(all.begin() + static_cast<std::ptrdiff_t>(begin), all.end(),
                                [&](const Comparison& one) { return same(*one.inputs, inputs); });
      if (found == all.end()) {
        auto shared = std::make_shared<const std::vector<Input>>(std::move(inputs));
        all.push_back({&family, std::move(shared), {}, std::nullopt, 0});
        found = all.end() - 1;
      }
      found->contestants.push_back(&contestant);
    }
    for (std::size_t i = begin; i < all.size(); ++i) {
      Comparison& one = all[i];
      one.rows = one.contestants.size();
      if (naive == nullptr || !std::all_of(one.inputs->begin(), one.inputs->end(), naive->can))
        continue;
      const auto found = std::find(one.contestants.begin(), one.contestants.end(), naive);
      one.baseline = static_cast<std::size_t>(found - one.contestants.begin());
      if (found == one.contestants.end()) one.contestants.push_back(naive);
    }
  }
  return all;
}

Timed throughput(const Contestant& contestant, const Inputs& inputs) {
  const auto size = static_cast<double>(inputs->size());
  if (contestant.own_clock)
    return {[&contestant, inputs](std::size_t repetitions) {
              return contestant.own_clock(*inputs, repetitions);
            },
            size};
  if (contestant.prepare) {
    Prepared prepared = contestant.prepare(*inputs);
    return {on_steady_clock(std::move(prepared.run)), prepared.evaluations};
  }
  return {on_steady_clock([&contestant, inputs] { contestant.evaluate_all(*inputs); }), size};
}

Timed latency(const Contestant& contestant, const Inputs& inputs) {
  return {on_steady_clock([&contestant, inputs] { contestant.evaluate_chained(*inputs); }),
          static_cast<double>(inputs->size())};
}

/// Throughputs, then latencies, then the additions that tell cycles.
Group group_of(const Comparison& one) {
  Group group;
  for (const Contestant* contestant : one.contestants)
    group.push_back(throughput(*contestant, one.inputs));
  for (const Contestant* contestant : one.contestants)
    if (contestant->evaluate_chained) group.push_back(latency(*contestant, one.inputs));
  if (const auto additions = dependent_additions()) group.push_back(*additions);
  return group;
}

std::vector<double> paired_ratios(const std::vector<double>& mine,
                                  const std::vector<double>& theirs) {
  std::vector<double> ratios(mine.size());
  std::transform(mine.begin(), mine.end(), theirs.begin(), ratios.begin(),
                 [](double one, double other) { return one / other; });
  return ratios;
}

std::vector<TimeRow> rows_of(const Comparison& one, const std::vector<std::vector<double>>& times) {
  std::vector<TimeRow> rows;
  std::size_t next_latency = one.contestants.size();
  for (std::size_t i = 0; i < one.rows; ++i) {
    const Contestant& contestant = *one.contestants[i];
    const std::vector<double>& mine = times[i];
    TimeRow row;
    row.contestant = contestant.name;
    row.precision = contestant.precision;
    row.quantity = contestant.quantity;
    row.family = one.family->name;
    row.ns_median = median(mine);
    row.ns_minimum = *std::min_element(mine.begin(), mine.end());
    row.latency_ns = row.ratio = row.ratio_low = row.ratio_high =
        std::numeric_limits<double>::quiet_NaN();
    if (contestant.evaluate_chained) row.latency_ns = median(times[next_latency++]);
    if (one.baseline) row.ratio = median(paired_ratios(mine, times[*one.baseline]));
    const SlowestCall slowest = slowest_call(contestant, *one.inputs);
    row.slowest_call_ns = slowest.ns;
    row.slowest = slowest.input;
    if (dependent_additions()) row.cycles = median(paired_ratios(mine, times.back()));
    row.inputs = one.inputs->size();
    row.rounds = mine.size();
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::vector<Input> timed_inputs(const Contestant& contestant, std::span<const Input> inputs,
                                const TimingPlan& plan) {
  constexpr std::uint64_t seed = 1;
  constexpr double usual_ns = 100.0;
  std::vector<Input> timed;
  std::vector<double> calls;
  for (const std::size_t i : RandomOrder(seed).next(inputs.size())) {
    if (timed.size() == plan.inputs) break;
    const Input input = rounded_input(inputs[i], contestant.quantity, contestant.precision);
    const bool has_meaning =
        !takes_alpha(contestant.quantity) || (input.alpha > 0 && std::isfinite(input.alpha));
    if (!has_meaning || !contestant.can(input)) continue;
    const double ns = contestant.expected_ns ? contestant.expected_ns(input) : usual_ns;
    if (ns > plan.longest_call_ns) continue;
    timed.push_back(input);
    calls.push_back(ns);
  }
  const auto pass_over = [&](std::size_t size) {
    return std::accumulate(calls.begin(), calls.begin() + static_cast<std::ptrdiff_t>(size), 0.0);
  };
  std::size_t kept = timed.size();
  while (kept > 1 && pass_over(kept) > plan.longest_pass_ns) kept = (kept + 1) / 2;
  timed.resize(kept);
  return timed;
}

SlowestCall slowest_call(const Contestant& contestant, std::span<const Input> inputs) {
  constexpr int visits = 3;
  std::vector<double> shortest(inputs.size(), std::numeric_limits<double>::infinity());
  double clock = std::numeric_limits<double>::infinity();
  for (int visit = 0; visit < visits; ++visit)
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      if (!contestant.own_clock) clock = std::min(clock, once([] {}));
      shortest[i] = std::min(shortest[i], one_call(contestant, inputs[i]));
    }
  const auto longest = std::max_element(shortest.begin(), shortest.end());
  if (longest == shortest.end()) return {};
  if (contestant.own_clock) clock = 0.0;
  return {std::max(0.0, *longest - clock),
          inputs[static_cast<std::size_t>(longest - shortest.begin())]};
}

std::vector<TimeRow> time_families(const std::vector<Contestant>& contestants,
                                   const std::vector<Family>& families, const TimingPlan& plan) {
  const std::size_t fewest_rounds = std::min<std::size_t>(6, plan.rounds.rounds);
  const std::vector<Comparison> all = comparisons(contestants, families, plan);
  std::vector<Group> groups;
  groups.reserve(all.size());
  for (const Comparison& one : all) groups.push_back(group_of(one));
  const RoundTimes times = interleaved_rounds(groups, plan.rounds);
  std::vector<TimeRow> rows;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!times[i].empty() && times[i].front().size() >= fewest_rounds)
      for (TimeRow& row : rows_of(all[i], times[i])) rows.push_back(std::move(row));
  return rows;
}

}  // namespace magicmass::report
