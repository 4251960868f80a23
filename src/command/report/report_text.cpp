// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "command/report/report_tables.hpp"
#include "render/wrapping.hpp"

namespace magicmass::command {
namespace {

std::string row(const std::string& name, const std::string& type, const auto&... cells) {
  constexpr std::size_t name_width = 19;
  // a long name has a line of its own
  std::string line = name.size() < name_width ? fmt::format("{:<{}}", name, name_width)
                                              : name + "\n" + std::string(name_width, ' ');
  line += fmt::format("{:<3}", type);
  const std::vector<std::string> texts = {cells...};
  constexpr std::size_t widths[] = {7, 7, 6, 7, 7, 7, 6, 11};
  for (std::size_t i = 0; i < texts.size(); ++i) line += fmt::format("{:>{}}", texts[i], widths[i]);
  return line + "\n";
}

std::string interval(const report::TimeRow& time) {
  const std::string low = short_number(time.ratio_low);
  return low == "-" ? low : low + "-" + short_number(time.ratio_high);
}

std::string line_of(const Entry& entry) {
  if (entry.errors.empty()) {  // timed alone
    if (!entry.time) return "";
    return row(entry.evaluator, short_precision(entry.precision), "-", "-", "-",
               short_number(entry.time->ns_median), "-", "-", shown_ratio(*entry.time),
               interval(*entry.time));
  }
  const report::ErrorRow& worst = entry.worst();
  double eps = 0.0;
  std::size_t wrong = 0;
  for (const report::ErrorRow& error : entry.errors) {
    eps = std::max(eps, error.max_eps);
    wrong += error.wrong + error.wrong_signs;
  }
  const std::string type = short_precision(entry.precision);
  const std::string ulp = (entry.is_reproducible ? "" : "~") + short_number(worst.max_ulp);
  if (!entry.time)
    return row(entry.evaluator, type, ulp, short_number(eps), std::to_string(wrong), "-", "-", "-",
               "-", "-");
  const report::TimeRow& time = *entry.time;
  return row(entry.evaluator, type, ulp, short_number(eps), std::to_string(wrong),
             short_number(time.ns_median), short_number(time.latency_ns),
             short_number(time.slowest_call_ns), shown_ratio(time), interval(time));
}

std::string growth_text(const std::vector<report::Growth>& growths) {
  std::string text;
  std::string words;
  for (const report::Growth& growth : growths) {
    if (growth.words != words) {
      words = growth.words;
      text += fmt::format("\n{}, against {}\n", growth.quantity, words);
    }
    const report::GrowthPoint& first = growth.points.front();
    const report::GrowthPoint& last = growth.points.back();
    text += fmt::format("{:<20}{:<6}{:>6} to {:>6} ns\n", growth.contestant,
                        short_precision(growth.precision), short_number(first.ns),
                        short_number(last.ns));
    if (const std::string exponents = shown_exponents(growth); !exponents.empty())
      text += "  " + exponents + "\n";
  }
  return text;
}

}  // namespace

std::string report_text(const Measurement& measurement) {
  std::string text = "Speed against error\n===================\n";
  for (const auto& [name, value] : measurement.provenance)
    text += render::wrapped(value, fmt::format("{:<11}", name));
  text += "\n" + render::wrapped(report_legend(measurement), "");
  for (const std::string& remark : measurement.remarks) text += render::wrapped(remark, "");
  for (const MeasuredFamily& one : measurement.families) {
    text += fmt::format("\n{}, {}\n", one.family.quantity, one.family.name) +
            render::wrapped(one.family.description, "");
    text += row("evaluator", "", "ulp", "eps", "wrong", "ns", "late", "slow", "ratio", "95 %");
    for (const Entry& entry : one.entries) text += line_of(entry);
  }
  text += targets_text(measurement.targets);
  text += growth_text(measurement.growths);
  return text;
}

}  // namespace magicmass::command
