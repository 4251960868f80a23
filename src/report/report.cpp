// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/report.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>

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

Row row_of(const Measurement& one) {
  const Errors& errors = one.errors;
  const bool has_index = one.quantity != Quantity::terminal && one.quantity != Quantity::counts;
  const bool has_worst = errors.max_ulp > 0 || errors.wrong > 0;
  return {text_cell(one.evaluator),
          text_cell(name_of(one.quantity)),
          one.family.empty() ? missing_cell() : text_cell(one.family),
          whole_cell(errors.samples),
          short_cell(errors.max_ulp),
          hex_cell(errors.worst.alpha),
          has_worst && has_index ? whole_cell(errors.worst.index) : missing_cell(),
          short_cell(errors.over_envelope),
          whole_cell(errors.misrounded),
          whole_cell(errors.wrong),
          short_cell(one.times.ns),
          short_cell(one.times.ratio),
          short_cell(one.times.ratio_low),
          short_cell(one.times.ratio_high)};
}

/// Its worst family, sums over all, and its times on everyday inputs; nothing where there are none.
std::optional<Measurement> over_families(const std::vector<Measurement>& measurements,
                                         const Implementation& implementation) {
  std::optional<Measurement> all;
  for (const Measurement& one : measurements) {
    if (one.evaluator != implementation.name || one.quantity != implementation.quantity) continue;
    if (!all) all = {one.evaluator, one.quantity, "", {}, {}};
    if (one.errors.max_ulp > all->errors.max_ulp) all->family = one.family;
    all->errors.max_ulp = std::max(all->errors.max_ulp, one.errors.max_ulp);
    all->errors.misrounded += one.errors.misrounded;
    all->errors.wrong += one.errors.wrong;
    if (one.family == "everyday") all->times = one.times;
  }
  return all;
}

}  // namespace

Plan quick_plan() { return {.draws = 60, .rounds = {.shortest_ns = 1e5}}; }

Table table_of(const std::vector<Measurement>& measurements,
               const std::vector<std::string>& names) {
  Table table;
  const Names all{"evaluator",   "quantity",    "family",        "samples",    "max_ulp",
                  "worst_alpha", "worst_index", "over_envelope", "misrounded", "wrong",
                  "ns",          "ratio",       "ratio_low",     "ratio_high"};
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!names.empty() && std::count(names.begin(), names.end(), all[i]) == 0) continue;
    places.push_back(i);
    table.columns.push_back(all[i]);
  }
  for (const Measurement& one : measurements) {
    const Row row = row_of(one);
    table.rows.emplace_back();
    for (const std::size_t place : places) table.rows.back().push_back(row[place]);
  }
  return table;
}

std::string document_of(const std::vector<Measurement>& measurements, bool is_markdown) {
  const auto section = [&](const std::string& heading, const Table& table) {
    return table.rows.empty() ? std::string()
           : is_markdown      ? "\n## " + heading + "\n\n" + markdown(table)
                              : "\n" + heading + "\n\n" + written(table, Format::text);
  };
  std::string summary =
      "Errors are in ulp; ratio is the time over naive's on the same inputs. First what\n"
      "was seen over all families: the worst one, sums, the ratio on everyday inputs.\n";
  std::string blocks;
  for (const auto& [quantity, name] : quantities) {
    std::vector<Measurement> sums;
    for (const Implementation& one : implementations())
      if (const auto all = over_families(measurements, one); all && one.quantity == quantity)
        sums.push_back(*all);
    summary += section(
        name, table_of(sums, {"evaluator", "family", "max_ulp", "misrounded", "wrong", "ratio"}));
    for (const Family& family : families()) {
      std::vector<Measurement> its;
      for (const Measurement& one : measurements)
        if (one.quantity == quantity && one.family == family.name) its.push_back(one);
      blocks += section(name + ", " + family.name + ": " + family.description,
                        table_of(its, {"evaluator", "max_ulp", "over_envelope", "misrounded",
                                       "wrong", "ns", "ratio"}));
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
  if (request.format == "json" || request.format == "csv") return {table_of(measurements, {}), ""};
  return {{}, document_of(measurements, request.format == "markdown")};
}

}  // namespace report
