// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/report.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <iterator>

#include "answers/errors.hpp"

namespace report {
namespace {

using namespace answers;

std::string printed(const char* format, double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}
/// Four digits: more would tell nothing.
Cell short_cell(double value) {
  return real_cell(std::strtod(printed("%.4g", value).c_str(), nullptr));
}
Cell hex_cell(double value) {
  return value == 0 ? missing_cell() : text_cell(printed("%a", value));
}

Fields fields_of(const Measurement& one) {
  const Errors& errors = one.errors;
  const bool has_index = one.quantity != Quantity::terminal && one.quantity != Quantity::counts;
  const bool has_worst = errors.max_ulp > 0 || errors.wrong > 0;
  return {{"evaluator", text_cell(one.evaluator)},
          {"quantity", text_cell(name_of(one.quantity))},
          {"family", one.family.empty() ? missing_cell() : text_cell(one.family)},
          {"samples", whole_cell(errors.samples)},
          {"max_ulp", short_cell(errors.max_ulp)},
          {"worst_alpha", hex_cell(errors.worst.alpha)},
          {"worst_index", has_worst && has_index ? whole_cell(errors.worst.index) : missing_cell()},
          {"over_envelope", short_cell(errors.over_envelope)},
          {"misrounded", whole_cell(errors.misrounded)},
          {"wrong", whole_cell(errors.wrong)},
          {"ns", short_cell(one.times.ns)},
          {"ratio", short_cell(one.times.ratio)},
          {"ratio_low", short_cell(one.times.ratio_low)},
          {"ratio_high", short_cell(one.times.ratio_high)}};
}

/// The measurements of one implementation: their worst family, sums over all, and the times on
/// everyday inputs.
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

}  // namespace

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

std::string document_of(const std::vector<Measurement>& measurements, bool is_markdown) {
  const auto those = [&](Quantity quantity, std::string Measurement::*of, const std::string& name) {
    std::vector<Measurement> some;
    std::ranges::copy_if(measurements, std::back_inserter(some), [&](const Measurement& one) {
      return one.quantity == quantity && one.*of == name;
    });
    return some;
  };
  std::string summary =
      "Errors are in ulp; ratio is the time over naive's on the same inputs. First what\n"
      "was seen over all families: the worst one, sums, the ratio on everyday inputs.\n";
  std::string blocks;
  for (const auto& [quantity, name] : quantities) {
    std::vector<Measurement> sums;
    for (const Implementation& one : implementations()) {
      const auto its = those(quantity, &Measurement::evaluator, one.name);
      if (one.quantity == quantity && !its.empty()) sums.push_back(over_families(its));
    }
    const Names of_sums{"evaluator", "family", "max_ulp", "misrounded", "wrong", "ratio"};
    summary += section(name, selected(table_of(sums), of_sums), is_markdown);
    for (const Family& family : families()) {
      const Table its = table_of(those(quantity, &Measurement::family, family.name));
      const Names columns{"evaluator", "max_ulp", "over_envelope", "misrounded",
                          "wrong",     "ns",      "ratio"};
      blocks += section(name + ", " + family.name + ": " + family.description,
                        selected(its, columns), is_markdown);
    }
  }
  return summary + blocks;
}

Answer report(const Request& request) {
  Plan plan = request.has("quick") ? quick_plan() : Plan();
  plan.only = request.text("only");
  std::vector<std::string> names;
  for (const auto& [quantity, name] : quantities) names.push_back(name);
  for (const Family& family : families()) names.push_back(family.name);
  for (const Implementation& one : plan.implementations)
    if (std::count(names.begin(), names.end(), one.name) == 0) names.push_back(one.name);
  if (!plan.only.empty() && std::count(names.begin(), names.end(), plan.only) == 0) {
    throw InvalidInput("report: no quantity, family or evaluator " + shown_text(plan.only) +
                       "; allowed: " + joined(names));
  }
  const std::vector<Measurement> measurements = measure(plan);
  if (request.format == "json" || request.format == "csv") return {table_of(measurements)};
  return {{}, document_of(measurements, request.format == "markdown")};
}

}  // namespace report
