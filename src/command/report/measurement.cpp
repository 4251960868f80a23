// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/measurement.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "command/nearest_name.hpp"
#include "command/report/further_contestants.hpp"
#include "command/report/growth_measurement.hpp"
#include "report/contestants.hpp"
#include "report/errors.hpp"
#include "report/oracle.hpp"
#include "report/quantities.hpp"
#include "report/timing.hpp"

namespace magicmass::command {
namespace {

using report::Contestant;
using report::Family;

constexpr const char* twin = "naive again";

bool is_asked(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

void require_names(const std::string& kind, const std::vector<std::string>& asked,
                   const std::set<std::string>& known) {
  for (const std::string& name : asked) require_name(kind, name, {known.begin(), known.end()});
}

/// Naive first, double before the other precisions, else as they come.
void sort_for_reading(std::vector<Contestant>& contestants) {
  const auto place = [](const Contestant& one) {
    return std::pair(one.precision == "double"  ? 0
                     : one.precision == "float" ? 1
                                                : 2,
                     !one.is_naive);
  };
  std::stable_sort(
      contestants.begin(), contestants.end(),
      [&](const Contestant& left, const Contestant& right) { return place(left) < place(right); });
}

bool is_baseline(const Contestant& one) { return one.is_naive && one.precision == "double"; }

/// Everything of one quantity.
struct Task {
  std::vector<Contestant> contestants;
  std::vector<Family> families;
};

std::vector<Task> tasks(const ReportRequest& request, Measurement& measurement) {
  const std::size_t size = request.size.value_or(request.quick ? 128 : 4096);
  std::set<std::string> family_names;
  std::set<std::string> evaluator_names;
  std::set<std::string> quantity_names;
  std::vector<Task> all;
  std::vector<std::string> asked;
  for (const report::Quantity& quantity : report::quantities()) {
    quantity_names.insert(quantity.name);
    if (is_asked(request.quantities, quantity.name)) asked.push_back(quantity.name);
  }
  require_names("quantity", request.quantities, quantity_names);
  const std::vector<Contestant> further =
      further_contestants(request.peers, asked, measurement.remarks);
  for (const std::string& quantity : asked) {
    Task task{report::contestants(quantity), report::families(quantity, size)};
    for (const Contestant& one : further)
      if (one.quantity == quantity) task.contestants.push_back(one);
    sort_for_reading(task.contestants);
    for (const Family& family : task.families) family_names.insert(family.name);
    for (const Contestant& one : task.contestants) evaluator_names.insert(one.name);
    std::erase_if(task.families,
                  [&](const Family& one) { return !is_asked(request.families, one.name); });
    std::erase_if(task.contestants, [&](const Contestant& one) {
      return !is_asked(request.evaluators, one.name) && !is_baseline(one);
    });
    all.push_back(std::move(task));
  }
  require_names("family", request.families, family_names);
  require_names("evaluator", request.evaluators, evaluator_names);
  return all;
}

/// Families whose errors are all there; false if Ctrl-C ended it.
bool measure_errors(const Task& task, report::Oracle& oracle, Progress& progress,
                    std::vector<MeasuredFamily>& measured) {
  for (const Family& family : task.families) {
    MeasuredFamily one{family, {}};
    const auto done = static_cast<double>(&family - task.families.data()) /
                      static_cast<double>(task.families.size());
    for (const Contestant& contestant : task.contestants) {
      if (!progress.step(fmt::format("errors: {}, {}: {} in {}", family.quantity, family.name,
                                     contestant.name, contestant.precision),
                         done))
        return false;
      Entry entry{contestant.name,
                  contestant.precision,
                  contestant.is_naive,
                  contestant.is_reproducible,
                  report::measure(contestant, family, oracle),
                  {}};
      std::erase_if(entry.errors, [](const report::ErrorRow& row) { return row.samples == 0; });
      if (!entry.errors.empty()) one.entries.push_back(std::move(entry));
    }
    measured.push_back(std::move(one));
  }
  return true;
}

void look_at_self(SelfComparison& self, const report::TimeRow& row) {
  if (std::isnan(row.ratio)) return;
  ++self.families;
  if (row.ratio_low <= 1.0 && 1.0 <= row.ratio_high) ++self.holding_one;
  self.lowest = std::min(self.lowest, row.ratio);
  self.highest = std::max(self.highest, row.ratio);
}

void measure_times(const Task& task, const report::TimingPlan& plan,
                   std::vector<MeasuredFamily>& measured, SelfComparison& self) {
  std::vector<Contestant> contestants = task.contestants;
  for (const Contestant& one : task.contestants)
    if (is_baseline(one)) {
      Contestant again = one;
      again.name = twin;
      again.is_naive = false;
      contestants.push_back(std::move(again));
    }
  for (report::TimeRow& row : report::time_families(contestants, task.families, plan)) {
    if (row.contestant == twin) {
      look_at_self(self, row);
      continue;
    }
    for (MeasuredFamily& one : measured)
      if (one.family.name == row.family && one.family.quantity == row.quantity)
        for (Entry& entry : one.entries)
          if (entry.evaluator == row.contestant && entry.precision == row.precision)
            entry.time = row;
  }
}

}  // namespace

const report::ErrorRow& Entry::worst() const {
  return *std::max_element(errors.begin(), errors.end(), [](const auto& left, const auto& right) {
    return std::pair(left.max_ulp, left.wrong) < std::pair(right.max_ulp, right.wrong);
  });
}

Measurement measure(const ReportRequest& request, Progress& progress) {
  Measurement measurement;
  measurement.provenance = provenance();
  progress.step("deriving", 0.0);
  const std::vector<Task> all = tasks(request, measurement);
  report::TimingPlan plan;
  plan.rounds.rounds = request.rounds;
  plan.longest_pass_ns = request.quick ? 2e5 : 2e6;
  plan.longest_call_ns = request.quick ? 1e6 : 2e7;
  if (request.quick) plan.rounds.shortest_ns = 2e4;
  report::Oracle oracle;
  for (const Task& task : all) {
    if (task.families.empty()) continue;
    std::vector<MeasuredFamily> measured;
    const bool has_errors = measure_errors(task, oracle, progress, measured);
    const std::string words = "times: " + task.families.front().quantity;
    plan.rounds.go_on = [&](double done) { return progress.step(words, done); };
    if (has_errors) measure_times(task, plan, measured, measurement.self);
    for (MeasuredFamily& one : measured) measurement.families.push_back(std::move(one));
    oracle.forget();
  }
  if (request.growth && !Progress::was_interrupted())
    for (const Task& task : all)
      measure_growth(task.contestants, request.quick, oracle, plan, progress, measurement.growths);
  if (request.sweeps)
    for (const Task& task : all)
      if (measurement.sweeps.empty())
        measurement.sweeps =
            alpha_sweeps(task.contestants, request.quick ? 400 : 1200, oracle, progress);
  measurement.is_complete = !Progress::was_interrupted();
  return measurement;
}

}  // namespace magicmass::command
