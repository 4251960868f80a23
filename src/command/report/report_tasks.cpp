// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/report_tasks.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "command/nearest_name.hpp"
#include "report/contestants.hpp"
#include "report/quantities.hpp"

namespace magicmass::command {
namespace {

using report::Contestant;
using report::Family;

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

/// Inputs a family. The oracle of a quantity that is known from the tables alone is a hundred times as slow.
std::size_t usual_size(const ReportRequest& request, const std::string& quantity) {
  const bool is_known = report::quantity_named(quantity).is_known;
  if (request.quick) return is_known ? 96 : 12;
  return is_known ? 2048 : 64;
}

}  // namespace

bool is_baseline(const Contestant& one) { return one.is_naive && one.precision == "double"; }

std::vector<std::string> asked_quantities(const ReportRequest& request) {
  std::set<std::string> known;
  std::vector<std::string> asked;
  for (const report::Quantity& quantity : report::quantities()) {
    known.insert(quantity.name);
    if (is_asked(request.quantities, quantity.name)) asked.push_back(quantity.name);
  }
  require_names("quantity", request.quantities, known);
  std::set<std::string> families;
  for (const std::string& quantity : asked)
    for (const Family& family : report::families(quantity, 1)) families.insert(family.name);
  require_names("family", request.families, families);
  return asked;
}

std::vector<Task> report_tasks(const ReportRequest& request,
                               const std::vector<Contestant>& further) {
  std::set<std::string> evaluator_names;
  std::vector<Task> all;
  for (const std::string& quantity : asked_quantities(request)) {
    Task task{report::contestants(quantity),
              report::families(quantity, request.size.value_or(usual_size(request, quantity)))};
    for (const Contestant& one : further)
      if (one.quantity == quantity) task.contestants.push_back(one);
    sort_for_reading(task.contestants);
    for (const Contestant& one : task.contestants) evaluator_names.insert(one.name);
    std::erase_if(task.families,
                  [&](const Family& one) { return !is_asked(request.families, one.name); });
    std::erase_if(task.contestants, [&](const Contestant& one) {
      return !is_asked(request.evaluators, one.name) && !is_baseline(one);
    });
    all.push_back(std::move(task));
  }
  require_names("evaluator", request.evaluators, evaluator_names);
  return all;
}

report::TimingPlan timing_plan(const ReportRequest& request) {
  report::TimingPlan plan;
  plan.rounds.rounds = request.timing_rounds();
  plan.longest_pass_ns = request.quick ? 2e4 : 1e6;
  plan.longest_call_ns = request.quick ? 1e5 : 2e7;
  if (request.quick) plan.rounds.shortest_ns = 1e4;
  return plan;
}

}  // namespace magicmass::command
