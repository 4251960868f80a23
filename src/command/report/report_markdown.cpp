// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <map>
#include <string>

#include <fmt/format.h>

#include "command/report/report_tables.hpp"
#include "magicmass/errors.hpp"

namespace magicmass::command {
namespace {

constexpr std::string_view headline_begin = "<!-- written by `magicmass report --headline`: -->\n";
constexpr std::string_view headline_end = "<!-- end -->\n";

/// A row of a Markdown table; `|` in a cell would end it.
std::string row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) {
    std::string safe;
    for (const char character : cell)
      safe += character == '|' ? std::string("\\|") : std::string(1, character);
    line += " " + safe + " |";
  }
  return line + "\n";
}

std::string head(const std::vector<std::string>& names, std::size_t words) {
  std::string line = "|";
  for (std::size_t i = 0; i < names.size(); ++i) line += i < words ? "---|" : "--:|";
  return row(names) + line + "\n";
}

std::string ratio(const std::optional<report::TimeRow>& time) {
  if (!time || std::isnan(time->ratio)) return "-";
  return fmt::format("{} ({} to {})", shown_ratio(*time), short_number(time->ratio_low),
                     short_number(time->ratio_high));
}

std::string ns(const std::optional<report::TimeRow>& time, double report::TimeRow::*which) {
  return time ? short_number((*time).*which) : "-";
}

std::string ulp(const Entry& entry, double value) {
  return (entry.is_reproducible ? "" : "~") + short_number(value);
}

std::string family_table(const MeasuredFamily& one) {
  std::string text = fmt::format("\n## {}, {}\n\n{}\n\n", one.family.quantity, one.family.name,
                                 one.family.description);
  text += head({"evaluator", "type", "member", "max ulp", "99.9 %", "median", "rounded correctly",
                "over envelope", "max eps", "wrong", "worst input", "ns", "least", "latency",
                "cycles", "slowest call", "ratio to naive (95 %)"},
               3);
  for (const Entry& entry : one.entries)
    for (const report::ErrorRow& error : entry.errors) {
      const auto& time = entry.time;
      text += row({entry.evaluator, entry.precision, error.member, ulp(entry, error.max_ulp),
                   short_number(error.ulp_999), short_number(error.ulp_median),
                   fmt::format("{:.1f} %", 100 * error.correctly_rounded),
                   short_number(error.over_envelope), short_number(error.max_eps),
                   std::to_string(error.quantity == "counts" ? error.wrong : error.wrong_signs),
                   shown_input(error.quantity, error.worst), ns(time, &report::TimeRow::ns_median),
                   ns(time, &report::TimeRow::ns_minimum), ns(time, &report::TimeRow::latency_ns),
                   time && time->cycles ? short_number(*time->cycles) : "-",
                   ns(time, &report::TimeRow::slowest_call_ns), ratio(time)});
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
    text += head({growth.scale, "ns", "max ulp", "over envelope"}, 0);
    for (const report::GrowthPoint& point : growth.points)
      text += row({fmt::format("{}", point.x), short_number(point.ns), short_number(point.max_ulp),
                   short_number(point.over_envelope)});
  }
  return text;
}

/// Where an evaluator did worst, and how it did on the last, easiest family.
struct Summary {
  const Entry* hardest = nullptr;
  const report::Family* hardest_family = nullptr;
  const Entry* easiest = nullptr;
  std::size_t wrong = 0, asked = 0;
};

}  // namespace

std::string report_markdown(const Measurement& measurement) {
  std::string text = "# Speed against error\n\n" + head({"", ""}, 2);
  for (const auto& [name, value] : measurement.provenance) text += row({name, value});
  text += "\n" + report_legend(measurement) + "\n";
  for (const std::string& remark : measurement.remarks) text += "\n" + remark + "\n";
  for (const MeasuredFamily& one : measurement.families) text += family_table(one);
  if (!measurement.growths.empty())
    text += "\n## As the work grows\n" + growth_tables(measurement.growths);
  return text;
}

std::string report_headline(const Measurement& measurement) {
  std::vector<std::pair<std::string, std::string>> order;
  std::map<std::pair<std::string, std::string>, Summary> summaries;
  for (const MeasuredFamily& one : measurement.families)
    for (const Entry& entry : one.entries) {
      if (entry.precision != "double" || entry.errors.empty()) continue;
      const std::pair key(one.family.quantity, entry.evaluator);
      if (!summaries.contains(key)) order.push_back(key);
      Summary& summary = summaries[key];
      if (!summary.hardest || entry.worst().max_ulp > summary.hardest->worst().max_ulp) {
        summary.hardest = &entry;
        summary.hardest_family = &one.family;
      }
      summary.easiest = &entry;
      for (const report::ErrorRow& error : entry.errors) {
        summary.wrong += error.quantity == "counts" ? error.wrong : error.wrong_signs;
        summary.asked += error.samples;
      }
    }
  std::string text =
      head({"quantity", "evaluator", "worst on", "ulp there", "ns there", "wrong signs or counts",
            "everyday ulp", "everyday ns", "ratio to naive (95 %)"},
           3);
  for (const auto& key : order) {
    const Summary& one = summaries[key];
    text += row({key.first, key.second, one.hardest_family->name,
                 ulp(*one.hardest, one.hardest->worst().max_ulp),
                 ns(one.hardest->time, &report::TimeRow::ns_median),
                 fmt::format("{} of {}", one.wrong, one.asked),
                 ulp(*one.easiest, one.easiest->worst().max_ulp),
                 ns(one.easiest->time, &report::TimeRow::ns_median), ratio(one.easiest->time)});
  }
  return text;
}

std::string with_headline(const std::string& text, const std::string& headline) {
  const std::size_t begin = text.find(headline_begin);
  const std::size_t end =
      begin == std::string::npos ? begin : text.find(headline_end, begin + headline_begin.size());
  if (end == std::string::npos)
    throw InvalidInput("no place for the headline: the file needs the line \"" +
                       std::string(headline_begin.substr(0, headline_begin.size() - 1)) +
                       "\" and after it \"<!-- end -->\"");
  return text.substr(0, begin + headline_begin.size()) + headline + text.substr(end);
}

}  // namespace magicmass::command
