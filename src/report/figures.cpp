// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <set>
#include <vector>

#include "magicmass/numbers/accurate.hpp"
#include "magicmass/oracle/rational.hpp"
#include "report/report.hpp"

namespace report {
namespace {

using answers::Table;

Table speed_data() {
  Plan plan = quick_plan();
  plan.only = "everyday";
  std::vector<Measurement> all = measure(plan);
  std::erase_if(all, [](const Measurement& one) { return one.quantity != Quantity::velocities; });
  return selected(table_of(all), {"evaluator", "max_ulp", "ns"});
}

/// a_t from below alpha_5 up to 1, denser around the thresholds.
Table error_data() {
  constexpr std::size_t a_t = 0;
  std::set<double> thresholds;
  for (std::int64_t k = 1; k <= 5; ++k) {
    const magicmass::Ratios ratios = magicmass::accurate::ratios(k);
    thresholds.insert({ratios.magic, ratios.deficient});
  }
  std::set<double> alphas = thresholds;
  for (int i = 0; i <= 400; ++i) alphas.insert(0.03 * std::pow(1.1 / 0.03, i / 400.0));
  for (const double threshold : thresholds)
    for (const double side : {-1, 1})
      for (int i = 7; i <= 49; i += 2) alphas.insert(threshold * (1 + std::ldexp(side, -i)));
  std::vector<Input> inputs;
  std::vector<Truth> truths;
  Table table{{"alpha", "threshold", "envelope", "naive", "tangent", "fast", "accurate"}, {}};
  for (const double alpha : alphas) {
    inputs.push_back({alpha, 0});
    truths.push_back(truth(Quantity::terminal, inputs.back()));
    const bool is_threshold = thresholds.contains(alpha);
    table.rows.push_back({answers::real_cell(alpha),
                          is_threshold ? answers::real_cell(alpha) : answers::missing_cell(),
                          answers::real_cell(truths.back().envelopes[a_t])});
  }
  for (const std::string name : {"naive", "tangent", "fast", "accurate"}) {
    Columns results(inputs);
    for (const Implementation& one : implementations())
      if (one.name == name && one.quantity == Quantity::terminal) one.run(results);
    for (std::size_t i = 0; i < inputs.size(); ++i)
      table.rows[i].push_back(answers::real_cell(
          magicmass::oracle::ulp_error(results.values[a_t][i], truths[i].values[a_t])));
  }
  return table;
}

}  // namespace

const std::vector<answers::Figure>& figures() {
  static const std::vector<answers::Figure> all{{"speed", speed_data}, {"error", error_data}};
  return all;
}

}  // namespace report
