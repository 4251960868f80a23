// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <map>
#include <string>

#include <fmt/format.h>

#include "command/report/report_tables.hpp"
#include "magicmass/errors.hpp"

namespace magicmass::command {
namespace {

std::string ns(const std::optional<report::TimeRow>& time, double report::TimeRow::*which) {
  return time ? short_number((*time).*which) : "-";
}

std::string ulp(const Entry& entry, double value) {
  return (entry.is_reproducible ? "" : "~") + short_number(value);
}

std::string family_table(const MeasuredFamily& one) {
  std::string text = fmt::format("\n## {}, {}\n\n{}\n\n", one.family.quantity, one.family.name,
                                 one.family.description);
  text +=
      markdown_head({"evaluator", "type", "member", "max ulp", "99.9 %", "median",
                     "rounded correctly", "over envelope", "max eps", "wrong", "worst input", "ns",
                     "least", "latency", "cycles", "slowest call", "ratio to naive (95 %)"},
                    3);
  for (const Entry& entry : one.entries)
    for (const report::ErrorRow& error : entry.errors) {
      const auto& time = entry.time;
      text += markdown_row(
          {entry.evaluator, entry.precision, error.member, ulp(entry, error.max_ulp),
           short_number(error.ulp_999), short_number(error.ulp_median),
           fmt::format("{:.1f} %", 100 * error.correctly_rounded),
           short_number(error.over_envelope), short_number(error.max_eps),
           std::to_string(error.wrong + error.wrong_signs),
           shown_input(error.quantity, error.worst), ns(time, &report::TimeRow::ns_median),
           ns(time, &report::TimeRow::ns_minimum), ns(time, &report::TimeRow::latency_ns),
           time && time->cycles ? short_number(*time->cycles) : "-",
           ns(time, &report::TimeRow::slowest_call_ns), shown_ratio_with_interval(time)});
    }
  return text;
}

std::string growth_tables(const std::vector<report::Growth>& growths) {
  std::string text;
  for (const report::Growth& growth : growths) {
    text += fmt::format("\n### {} ({}) against {}\n\n", growth.contestant, growth.precision,
                        growth.words);
    if (const std::string exponents = shown_exponents(growth); !exponents.empty())
      text += exponents + "\n\n";
    text += markdown_head({growth.scale, "ns", "max ulp", "over envelope"}, 0);
    for (const report::GrowthPoint& point : growth.points)
      text += markdown_row({fmt::format("{}", point.x), short_number(point.ns),
                            short_number(point.max_ulp), short_number(point.over_envelope)});
  }
  return text;
}

}  // namespace

std::string markdown_row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) {
    std::string safe;  // | in a cell would end it
    for (const char character : cell)
      safe += character == '|' ? std::string("\\|") : std::string(1, character);
    line += " " + safe + " |";
  }
  return line + "\n";
}

std::string markdown_head(const std::vector<std::string>& names, std::size_t words) {
  std::string line = "|";
  for (std::size_t i = 0; i < names.size(); ++i) line += i < words ? "---|" : "--:|";
  return markdown_row(names) + line + "\n";
}

std::string report_markdown(const Measurement& measurement) {
  std::string text = "# Speed against error\n\n" + markdown_head({"", ""}, 2);
  for (const auto& [name, value] : measurement.provenance) text += markdown_row({name, value});
  text += "\n" + report_legend(measurement) + "\n";
  for (const std::string& remark : measurement.remarks) text += "\n" + remark + "\n";
  for (const MeasuredFamily& one : measurement.families) text += family_table(one);
  text += targets_markdown(measurement.targets);
  if (!measurement.growths.empty())
    text += "\n## As the work grows\n" + growth_tables(measurement.growths);
  return text;
}

}  // namespace magicmass::command
