#include "report/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "magicmass/numbers/accurate.hpp"
#include "magicmass/oracle/rational.hpp"

namespace report {
namespace {

using namespace answers;

/// Four digits: more would tell nothing.
Cell short_cell(double value) {
  return real_cell(std::strtod(formatted("%.4g", value).c_str(), nullptr));
}

Fields fields_of(const Measurement& one) {
  const Errors& errors = one.errors;
  const bool has_index = one.quantity != Quantity::terminal && one.quantity != Quantity::counts;
  const double worst = errors.worst.alpha;
  const bool has_worst = errors.max_ulp > 0 || errors.wrong > 0;
  return {{"evaluator", text_cell(one.evaluator)},
          {"quantity", text_cell(name_of(one.quantity))},
          {"family", one.family.empty() ? missing_cell() : text_cell(one.family)},
          {"samples", whole_cell(errors.samples)},
          {"max_ulp", short_cell(errors.max_ulp)},
          {"worst_alpha", worst == 0 ? missing_cell() : text_cell(formatted("%a", worst))},
          {"worst_index", has_worst && has_index ? whole_cell(errors.worst.index) : missing_cell()},
          {"over_envelope", short_cell(errors.over_envelope)},
          {"misrounded", whole_cell(errors.misrounded)},
          {"wrong", whole_cell(errors.wrong)},
          {"ns", short_cell(one.times.ns)},
          {"ratio", short_cell(one.times.ratio)},
          {"ratio_low", short_cell(one.times.ratio_low)},
          {"ratio_high", short_cell(one.times.ratio_high)}};
}

/// Of one implementation: the worst family, sums over all, and the times on everyday inputs.
Measurement over_families(const std::vector<Measurement>& its) {
  Measurement all{its[0].evaluator, its[0].quantity, "", {}, {}};
  for (const Measurement& one : its) {
    if (one.errors.max_ulp > all.errors.max_ulp) all.family = one.family;
    all.errors.max_ulp = std::max(all.errors.max_ulp, one.errors.max_ulp);
    all.errors.misrounded += one.errors.misrounded;
    all.errors.wrong += one.errors.wrong;
    if (one.family == "everyday") all.times = one.times;
  }
  return all;
}

Plan quick_plan() { return {.draws = 60, .rounds = {.shortest_ns = 1e5}}; }

Table table_of(const std::vector<Measurement>& measurements) {
  Table table;
  for (const Measurement& one : measurements) {
    const Table alone = one_row(fields_of(one));
    table.columns = alone.columns;
    table.rows.push_back(alone.rows[0]);
  }
  return table;
}

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
    table.rows.push_back({real_cell(alpha), is_threshold ? real_cell(alpha) : missing_cell(),
                          real_cell(truths.back().envelopes[a_t])});
  }
  for (const std::string name : {"naive", "tangent", "fast", "accurate"}) {
    Columns results(inputs);
    for (const Implementation& one : implementations())
      if (one.name == name && one.quantity == Quantity::terminal) one.run(results);
    for (std::size_t i = 0; i < inputs.size(); ++i)
      table.rows[i].push_back(
          real_cell(magicmass::oracle::ulp_error(results.values[a_t][i], truths[i].values[a_t])));
  }
  return table;
}

}  // namespace

std::string document_of(const std::vector<Measurement>& measurements, bool is_markdown) {
  const auto those = [&](Quantity quantity, std::string Measurement::*of, const std::string& name) {
    std::vector<Measurement> some = measurements;
    std::erase_if(some, [&](const auto& m) { return m.quantity != quantity || m.*of != name; });
    return some;
  };
  // The ratio, which is last, with how far rounds are from it.
  const auto with_spread = [](const std::vector<Measurement>& these, const Names& columns) {
    Table table = selected(table_of(these), columns);
    for (std::size_t i = 0; i < these.size(); ++i) {
      const Times& t = these[i].times;
      const double off = std::max(t.ratio_high - t.ratio, t.ratio - t.ratio_low) / t.ratio;
      if (t.ratio > 0) table.rows[i].back().text += formatted(" +-%.0f %%", 100 * off);
    }
    return table;
  };
  std::string summary =
      "Errors are in ulp; ratio is the time over naive's on the same inputs, with how\n"
      "far the rounds are from it. First what was seen over all families: the worst\n"
      "one, sums, the ratio on everyday inputs.\n";
  std::string blocks;
  for (const auto& [quantity, name] : quantities) {
    std::vector<Measurement> sums;
    for (const Implementation& one : implementations()) {
      const auto its = those(quantity, &Measurement::evaluator, one.name);
      if (one.quantity == quantity && !its.empty()) sums.push_back(over_families(its));
    }
    const Names of_sums{"evaluator", "family", "max_ulp", "misrounded", "wrong", "ratio"};
    summary += section(name, with_spread(sums, of_sums), is_markdown);
    for (const Family& family : families()) {
      const auto its = those(quantity, &Measurement::family, family.name);
      const Names columns{"evaluator", "max_ulp", "over_envelope", "misrounded",
                          "wrong",     "ns",      "ratio"};
      blocks += section(name + ", " + family.name + ": " + family.description,
                        with_spread(its, columns), is_markdown);
    }
  }
  return summary + blocks;
}

Answer report(const Request& request) {
  Plan plan = request.has("quick") ? quick_plan() : Plan();
  plan.only = request.text("only");
  Names names = texts_of(quantities, &std::pair<Quantity, std::string>::second);
  for (const Family& family : families()) names.push_back(family.name);
  for (const Implementation& one : plan.implementations)
    if (std::count(names.begin(), names.end(), one.name) == 0) names.push_back(one.name);
  if (!plan.only.empty() && std::count(names.begin(), names.end(), plan.only) == 0)
    throw InvalidInput("report: no quantity, family or evaluator " + shown_text(plan.only) +
                       "; allowed: " + joined(names));
  const std::vector<Measurement> measurements = measure(plan);
  if (request.format == "json" || request.format == "csv") return {table_of(measurements)};
  return {{}, document_of(measurements, request.format == "markdown")};
}

const std::vector<Figure>& figures() {
  static const std::vector<Figure> all{{"speed", speed_data}, {"error", error_data}};
  return all;
}

}  // namespace report
