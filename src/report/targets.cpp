// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/targets.hpp"

#include <cmath>

#include "report/instruction_sets.hpp"
#include "report/target_measures.hpp"

namespace magicmass::report {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

using namespace measures;

/// For each quantity that has tiers.
std::vector<Target> of_each_quantity(const Target& one,
                                     const std::vector<std::string>& quantities) {
  std::vector<Target> all;
  for (const std::string& quantity : quantities) {
    all.push_back(one);
    all.back().name += ": " + quantity;
    all.back().quantity = quantity;
  }
  return all;
}

bool reaches(const Target& target, double seen, double limit) {
  return !std::isnan(limit) && (target.is_at_least ? seen >= limit : seen <= limit);
}

Verdict verdict_on(const Target& target, const Seen& seen) {
  if (reaches(target, seen.value, target.aim)) return Verdict::aim_reached;
  return std::isnan(target.must) || reaches(target, seen.value, target.must) ? Verdict::met
                                                                             : Verdict::missed;
}

}  // namespace

std::string name(Verdict verdict) {
  return verdict == Verdict::aim_reached ? "aim" : verdict == Verdict::met ? "yes" : "no";
}

const std::vector<Target>& targets() {
  static const std::vector<Target> table = [] {
    const std::vector<std::string> scalar = {"velocities", "elastic_terminal", "encounters",
                                             "ratios", "angle"};
    const std::vector<std::string> with_alpha = {"velocities", "elastic_terminal", "encounters",
                                                 "angle"};
    std::vector<Target> all;
    const auto add = [&](const std::vector<Target>& more) {
      all.insert(all.end(), more.begin(), more.end());
    };
    add(of_each_quantity({.name = "accurate, time / naive",
                          .measure = relative_time,
                          .evaluators = {"accurate"},
                          .other = "naive",
                          .must = 3,
                          .aim = 1.2,
                          .unit = "x"},
                         scalar));
    add(of_each_quantity({.name = "accurate, certified arithmetic",
                          .measure = fallback_share,
                          .evaluators = {"accurate"},
                          .must = 0.01,
                          .aim = 0,
                          .unit = "%"},
                         with_alpha));
    add({{.name = "accurate, slowest single call",
          .measure = slowest_call,
          .evaluators = {"accurate"},
          .must = 1,
          .aim = none,
          .unit = "ms"},
         {.name = "accurate, slowest call / median",
          .measure = slowest_over_median,
          .evaluators = {"accurate"},
          .must = none,
          .aim = 20,
          .unit = "x"},
         {.name = "accurate, not correctly rounded",
          .measure = misrounded,
          .evaluators = {"accurate", "batch_accurate"},
          .must = 0,
          .aim = 0},
         {.name = "counts, wrong answers",
          .measure = wrong_counts,
          .evaluators = {"count_collisions", "batch_count", "fast", "batch_fast", "accurate",
                         "batch_accurate"},
          .must = 0,
          .aim = 0}});
    add(of_each_quantity({.name = "fast, time / naive",
                          .measure = relative_time,
                          .evaluators = {"fast"},
                          .other = "naive",
                          .must = 0.8,
                          .aim = 0.45,
                          .unit = "x"},
                         scalar));
    add({{.name = "fast, time / naive, slowest family",
          .measure = slowest_family,
          .evaluators = {"fast"},
          .must = 1,
          .aim = none,
          .unit = "x"},
         {.name = "fast, largest error / envelope",
          .measure = over_envelope,
          .evaluators = {"fast", "batch_fast"},
          .must = 4,
          .aim = 2},
         {.name = "batch (i), speed-up over naive_four_calls",
          .measure = relative_time,
          .quantity = "velocities",
          .evaluators = {"batch_fast"},
          .other = "naive_four_calls",
          .must = 25,
          .aim = 40,
          .unit = "x",
          .is_at_least = true}});
    const auto batch = [&](const std::string& name, const std::string& quantity,
                           const std::vector<std::string>& evaluators, double must, double aim) {
      all.push_back({.name = name,
                     .measure = relative_time,
                     .quantity = quantity,
                     .evaluators = evaluators,
                     .other = "naive",
                     .must = must,
                     .aim = aim,
                     .unit = "x",
                     .is_at_least = true});
    };
    batch("batch (ii), speed-up over naive", "elastic_terminal", {"batch_fast"}, 12, 17);
    batch("batch (ii), baseline x86-64", "elastic_terminal",
          {"batch_fast" + suffix(InstructionSet::baseline)}, 3, 5);
    batch("accurate batch (ii), speed-up", "elastic_terminal", {"batch_accurate"}, 5, 7);
    batch("batch counts alone, speed-up", "counts", {"batch_count"}, 15, 20);
    all.push_back({.name = "stream (iii), time / copy_loop",
                   .measure = relative_time,
                   .quantity = "sequence",
                   .evaluators = {"stream"},
                   .other = "copy_loop",
                   .must = 3,
                   .aim = 1.5,
                   .unit = "x"});
    const auto events = [&](const std::string& name, double must, const std::string& unit,
                            bool is_at_least) {
      all.push_back({.name = name,
                     .measure = event_figure,
                     .must = must,
                     .aim = none,
                     .unit = unit,
                     .is_at_least = is_at_least});
    };
    events(events::velocities, 200, "M/s", true);
    events(events::places, 50, "M/s", true);
    events(events::short_chain, 5, "M/s", true);
    events(events::long_chain, 2, "M/s", true);
    events(events::memory, 200, "", false);
    events(events::growth, 1, "", false);
    return all;
  }();
  return table;
}

std::vector<TargetResult> judged(const Figures& figures) {
  std::vector<TargetResult> results;
  for (const Target& target : targets())
    if (const std::optional<Seen> seen = target.measure(target, figures))
      results.push_back({target, *seen, verdict_on(target, *seen)});
  return results;
}

}  // namespace magicmass::report
