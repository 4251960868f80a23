// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/measurement.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "command/report/exact_formulas.hpp"
#include "command/report/further_contestants.hpp"
#include "command/report/growth_measurement.hpp"
#include "command/report/own_function.hpp"
#include "command/report/timing_batch.hpp"
#include "report/batches.hpp"
#include "report/contestants.hpp"
#include "report/errors.hpp"
#include "report/fallbacks.hpp"
#include "report/oracle.hpp"
#include "report/quantities.hpp"

namespace magicmass::command {
namespace {

using report::Contestant;
using report::Family;

/// Every contestant's errors on one family; nothing if Ctrl-C ended it.
std::optional<MeasuredFamily> measure_errors(const Task& task, const Family& family,
                                             const report::Climb& climb, double done,
                                             report::Oracle& oracle, Progress& progress) {
  MeasuredFamily one{family, {}};
  for (const Contestant& contestant : task.contestants) {
    if (!progress.step(fmt::format("errors: {}, {}: {} in {}", family.quantity, family.name,
                                   contestant.name, contestant.precision),
                       done))
      return std::nullopt;
    Entry entry{contestant.name,
                contestant.precision,
                contestant.is_naive,
                contestant.is_reproducible,
                {},
                {}};
    if (!contestant.is_yardstick) entry.errors = report::measure(contestant, family, oracle, climb);
    std::erase_if(entry.errors, [](const report::ErrorRow& row) { return row.samples == 0; });
    if (!entry.errors.empty() || contestant.is_yardstick) one.entries.push_back(std::move(entry));
  }
  return one;
}

void look_at_self(SelfComparison& self, const report::TimeRow& row) {
  if (std::isnan(row.ratio)) return;
  ++self.families;
  if (row.ratio_low <= 1.0 && 1.0 <= row.ratio_high) ++self.holding_one;
  self.lowest = std::min(self.lowest, row.ratio);
  self.highest = std::max(self.highest, row.ratio);
}

void put_in_place(const report::TimeRow& row, Measurement& measurement) {
  if (row.contestant == twin) return look_at_self(measurement.self, row);
  for (MeasuredFamily& one : measurement.families)
    if (one.family.name == row.family && one.family.quantity == row.quantity)
      for (Entry& entry : one.entries)
        if (entry.evaluator == row.contestant && entry.precision == row.precision) entry.time = row;
}

/// Inputs of a climb. The oracle of a quantity that is known from the tables alone is a hundred times as slow.
std::size_t most_climbed(const ReportRequest& request, const Task& task) {
  const bool is_known = !task.contestants.empty() &&
                        report::quantity_named(task.contestants.front().quantity).is_known;
  if (request.quick) return is_known ? 6 : 2;
  return is_known ? 60 : 6;
}

void look_at_targets(const ReportRequest& request, const std::vector<Task>& tasks,
                     std::vector<report::TimeRow> times,
                     std::vector<std::vector<report::TimeRow>> batches,
                     std::vector<report::EventFigure> events, Measurement& measurement) {
  report::Figures figures{{}, std::move(times), std::move(batches), {}};
  for (const MeasuredFamily& one : measurement.families)
    for (const Entry& entry : one.entries)
      figures.errors.insert(figures.errors.end(), entry.errors.begin(), entry.errors.end());
  const std::size_t inputs = request.quick ? 100000 : 1000000;
  if (!Progress::was_interrupted())
    for (const Task& task : tasks)
      for (report::Fallbacks& row : report::count_fallbacks(task.contestants, inputs))
        figures.fallbacks.push_back(std::move(row));
  figures.events = std::move(events);
  measurement.targets = report::judged(figures);
}

/// Contestants that are made from the theorems, peers, and the exact values of quantities that are known from the tables alone.
bool needs_derivation(const ReportRequest& request) {
  std::set<std::string> generated;
  for (const std::string& quantity : asked_quantities(request)) {
    if (!report::quantity_named(quantity).is_known) return true;
    for (const Contestant& one : report::contestants(quantity)) generated.insert(one.name);
  }
  const auto& names = request.evaluators;
  return request.peers || names.empty() ||
         !std::all_of(names.begin(), names.end(),
                      [&](const std::string& name) { return generated.contains(name); });
}

/// Were families, evaluators or quantities named, the simulator's events were not.
bool is_everything(const ReportRequest& request) {
  return request.families.empty() && request.evaluators.empty() && request.quantities.empty();
}

/// Errors family after family, and in between, spread over the whole time that takes, the batches of times.
void measure_families(const ReportRequest& request, const std::vector<Task>& tasks,
                      const std::vector<DerivedForm>& forms, Progress& progress,
                      Measurement& measurement) {
  const std::size_t batches = report::batch_plan(request.timing_rounds()).batches;
  const std::string formulas = in_one_line(forms);
  std::vector<std::vector<report::TimeRow>> times;
  std::size_t all = 0;
  for (const Task& task : tasks) all += task.families.size();
  const auto go_on = [&] {
    for (const Task& task : tasks) {
      const report::Climb climb{most_climbed(request, task)};
      report::Oracle oracle;
      teach(oracle, forms);
      for (const Family& family : task.families) {
        const std::size_t done = measurement.families.size();
        const double share = static_cast<double>(done) / static_cast<double>(all);
        auto errors = measure_errors(task, family, climb, share, oracle, progress);
        if (!errors) return;
        measurement.families.push_back(std::move(*errors));
        while (times.size() * all < batches * (done + 1)) {
          auto rows = timing_batch(request, {times.size(), batches, formulas}, progress);
          if (!rows) return;
          times.push_back(std::move(*rows));
        }
      }
    }
  };
  go_on();
  std::vector<report::TimeRow> rows = report::combined(times);
  for (const report::TimeRow& row : rows) put_in_place(row, measurement);
  std::vector<report::EventFigure> events;
  if (is_everything(request) && !Progress::was_interrupted()) {
    report::Plan plan;
    plan.rounds = request.quick ? 7 : 21;
    plan.go_on = [&](double done) { return progress.step("events of the simulator", done); };
    events = report::event_figures(plan);
  }
  look_at_targets(request, tasks, std::move(rows), std::move(times), std::move(events),
                  measurement);
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
  std::vector<DerivedForm> forms;
  if (needs_derivation(request)) {
    progress.step("deriving", 0.0);
    forms = forms_from_derivation(asked_quantities(request), measurement.remarks);
  }
  const std::vector<Task> tasks =
      report_tasks(request, further_contestants(forms, request, measurement.remarks));
  if (!report::has_sleef())
    measurement.remarks.push_back("skipped: naive_sleef, as this was built without libsleef-dev");
  for (const std::string& quantity : unknown_quantities(forms))
    measurement.remarks.push_back(
        quantity +
        ": known from the generated tables alone, so no transcription to compare with; errors are "
        "against its own theorem, evaluated with more and more digits, at inputs that may be "
        "outside its domain");
  measure_families(request, tasks, forms, progress, measurement);
  report::Oracle oracle;
  if (request.growth && !Progress::was_interrupted())
    for (const Task& task : tasks)
      measure_growth(task.contestants, request.quick, oracle, timing_plan(request), progress,
                     measurement.growths);
  if (request.sweeps)
    for (const Task& task : tasks)
      if (measurement.sweeps.empty())
        measurement.sweeps =
            alpha_sweeps(task.contestants, request.quick ? 400 : 1200, oracle, progress);
  for (std::string& line : own_places(measurement)) measurement.remarks.push_back(std::move(line));
  measurement.is_complete = !Progress::was_interrupted();
  return measurement;
}

}  // namespace magicmass::command
