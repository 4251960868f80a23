// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "command/report/report_tables.hpp"
#include "render/wrapping.hpp"

namespace magicmass::command {
namespace {

using report::TargetResult;

constexpr const char* target_explanation =
    "What the tiers and the simulator are to reach, and what this run saw on the easiest family "
    "unless it says "
    "where; met: yes, no, or even the aim. Speeds are of this machine, and steady only where it "
    "is.";

std::string limit(const report::Target& target, double value) {
  if (std::isnan(value)) return "-";
  return fmt::format("{} {}{}", target.is_at_least ? ">=" : "<=", value, target.unit);
}

std::string interval(const report::Seen& seen) {
  if (std::isnan(seen.low)) return "-";
  return short_number(seen.low) + "-" + short_number(seen.high);
}

std::string shown(const TargetResult& one) {
  return short_number(one.seen.value) + one.target.unit;
}

}  // namespace

std::string targets_text(const std::vector<TargetResult>& results) {
  if (results.empty()) return "";
  constexpr const char* line = "{:<37}{:>9}{:>9}{:>9}{:>11}{:>5}\n";
  std::string text = "\ntargets\n" + render::wrapped(target_explanation, "");
  text += fmt::format(line, "", "must", "aim", "seen", "95 %", "met");
  for (const TargetResult& one : results) {
    std::string name = one.target.name;
    if (name.size() > 36) {
      text += name + "\n";
      name.clear();
    }
    text += fmt::format(line, name, limit(one.target, one.target.must),
                        limit(one.target, one.target.aim), shown(one), interval(one.seen),
                        report::name(one.verdict));
    if (!one.seen.where.empty()) text += render::wrapped(one.seen.where, "    ");
  }
  return text;
}

std::string targets_markdown(const std::vector<TargetResult>& results) {
  if (results.empty()) return "";
  std::string text = fmt::format("\n## Targets\n\n{}\n\n", target_explanation);
  text += markdown_head({"target", "where", "must", "aim", "seen", "95 %", "met"}, 2);
  for (const TargetResult& one : results)
    text += markdown_row({one.target.name, one.seen.where, limit(one.target, one.target.must),
                          limit(one.target, one.target.aim), shown(one), interval(one.seen),
                          report::name(one.verdict)});
  return text;
}

std::vector<Record> targets_records(const std::vector<TargetResult>& results) {
  std::vector<Record> records;
  for (const TargetResult& one : results) {
    Record record;
    record["target"] = text_cell(one.target.name);
    record["must"] = number_cell(one.target.must);
    record["aim"] = number_cell(one.target.aim);
    record["seen"] = number_cell(one.seen.value);
    record["seen_low"] = number_cell(one.seen.low);
    record["seen_high"] = number_cell(one.seen.high);
    record["unit"] = text_cell(one.target.unit);
    record["where"] = text_cell(one.seen.where);
    record["verdict"] = text_cell(report::name(one.verdict));
    records.push_back(std::move(record));
  }
  return records;
}

}  // namespace magicmass::command
