// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/comparison.hpp"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

constexpr std::array error_columns = {"samples",           "climbed",     "max_ulp", "worst_alpha",
                                      "worst_index",       "worst_e",     "ulp_999", "ulp_median",
                                      "correctly_rounded", "wrong_signs", "max_eps", "wrong",
                                      "over_envelope",     "promise_kept"};
constexpr std::array conditions = {"machine", "compiler", "flags", "libraries"};
constexpr std::size_t most_shown = 20;
constexpr double widest_gap = 1.1;

std::string text_of(const Record& record, const std::string& column) {
  const auto found = record.find(column);
  return found == record.end() ? "" : found->second.text;
}

std::optional<double> number_of(const Record& record, const std::string& column) {
  const std::string text = text_of(record, column);
  if (text.empty()) return std::nullopt;
  return std::strtod(text.c_str(), nullptr);
}

/// 1e20 and 1e+20 are the same number.
bool is_same(const std::string& one, const std::string& other) {
  if (one == other) return true;
  char* one_end = nullptr;
  char* other_end = nullptr;
  const double one_value = std::strtod(one.c_str(), &one_end);
  const double other_value = std::strtod(other.c_str(), &other_end);
  return one_end == one.c_str() + one.size() && other_end == other.c_str() + other.size() &&
         !one.empty() && !other.empty() && one_value == other_value;
}

std::string words(const Record& record, const std::vector<std::string>& columns) {
  std::string text;
  for (const std::string& column : columns)
    if (const std::string value = text_of(record, column); !value.empty())
      text += (text.empty() ? "" : ", ") + value;
  return text;
}

using Rows = std::map<std::string, const Record*>;
Rows rows_by(const KnownReport& report, const std::vector<std::string>& columns) {
  Rows rows;
  for (const Record& record : report.records)
    if (record.contains("evaluator")) rows.emplace(words(record, columns), &record);
  return rows;
}

/// What differs, row by row; and how many were compared.
struct Findings {
  std::size_t compared = 0;
  std::vector<std::string> lines;

  std::string text() const {
    std::string all;
    for (std::size_t i = 0; i < lines.size() && i < most_shown; ++i)
      all += "  " + shown_text(lines[i], 400) + "\n";
    if (lines.size() > most_shown) all += fmt::format("  and {} more\n", lines.size() - most_shown);
    return all;
  }
};

Findings compare_errors(const Rows& old_rows, const Rows& new_rows) {
  Findings findings;
  for (const auto& [key, record] : new_rows) {
    const auto found = old_rows.find(key);
    if (found == old_rows.end() || text_of(*record, "reproducible") != "true") continue;
    ++findings.compared;
    for (const char* column : error_columns) {
      const std::string was = text_of(*found->second, column);
      const std::string is = text_of(*record, column);
      if (!is_same(was, is))
        findings.lines.push_back(fmt::format("{}: {} was {}, is {}", key, column, was, is));
    }
  }
  return findings;
}

bool has_ratio(const Record& record) {
  return number_of(record, "ratio") && number_of(record, "ratio_low") &&
         number_of(record, "ratio_high");
}

/// By how much two intervals miss each other: 1.05 is 5 %; 1 or less where they meet.
double gap(const Record& one, const Record& other) {
  const double low = *number_of(one, "ratio_low");
  const double high = *number_of(one, "ratio_high");
  return std::max(low / *number_of(other, "ratio_high"), *number_of(other, "ratio_low") / high);
}

Findings compare_ratios(const Rows& old_rows, const Rows& new_rows, double& widest) {
  Findings findings;
  for (const auto& [key, record] : new_rows) {
    const auto found = old_rows.find(key);
    if (found == old_rows.end() || !has_ratio(*record) || !has_ratio(*found->second)) continue;
    ++findings.compared;
    const double miss = gap(*record, *found->second);
    if (miss <= 1.0) continue;
    widest = std::max(widest, miss);
    const auto interval = [](const Record& one) {
      return fmt::format("{:.4g} ({:.4g} to {:.4g})", *number_of(one, "ratio"),
                         *number_of(one, "ratio_low"), *number_of(one, "ratio_high"));
    };
    findings.lines.push_back(
        fmt::format("{}: ratio was {}, is {}", key, interval(*found->second), interval(*record)));
  }
  return findings;
}

std::string different_conditions(const Record& one, const Record& other) {
  std::string names;
  for (const char* column : conditions)
    if (text_of(one, column) != text_of(other, column))
      names += (names.empty() ? "" : ", ") + std::string(column);
  return names;
}

std::size_t only_in(const Rows& rows, const Rows& other) {
  std::size_t count = 0;
  for (const auto& [key, record] : rows) count += other.contains(key) ? 0 : 1;
  return count;
}

}  // namespace

KnownReport read_report(const std::string& path) {
  const auto refuse = [&](const std::string& why) {
    throw InvalidInput(shown_text(path, 200) + why);
  };
  std::ifstream file(path, std::ios::binary);
  std::error_code error;
  if (!file || std::filesystem::is_directory(path, error)) refuse(" cannot be read");
  const nlohmann::json all = nlohmann::json::parse(file, nullptr, false);
  KnownReport report{shown_text(path, 200), {}};
  if (all.is_array())
    for (const auto& object : all) {
      Record record;
      if (object.is_object())
        for (const auto& [name, value] : object.items())
          if (value.is_primitive() && !value.is_null())
            record[name] = {value.is_string() ? value.get<std::string>() : value.dump(), false};
      if (record.contains("evaluator") && record.contains("family"))
        report.records.push_back(std::move(record));
    }
  if (report.records.empty()) refuse(" is no report as `magicmass report --format json` writes it");
  return report;
}

Comparison compare_reports(const KnownReport& old_report, const KnownReport& new_report) {
  const std::vector<std::string> row = {"evaluator", "precision", "quantity",
                                        "family",    "member",    "x"};
  const std::vector<std::string> whole(row.begin(), row.begin() + 4);
  const Rows old_rows = rows_by(old_report, row);
  const Rows new_rows = rows_by(new_report, row);
  const std::size_t only_old = only_in(old_rows, new_rows);
  if (only_old == old_rows.size())
    throw InvalidInput(old_report.name + " and " + new_report.name + " have no row in common");
  Comparison result;
  const Findings errors = compare_errors(old_rows, new_rows);
  result.agrees = errors.lines.empty();
  result.text =
      fmt::format("errors: {} rows, {}\n", errors.compared,
                  errors.lines.empty() ? std::string("all the same")
                                       : fmt::format("{} figures differ", errors.lines.size())) +
      errors.text();
  const std::string different =
      different_conditions(old_report.records.front(), new_report.records.front());
  if (!different.empty()) {
    result.text += "ratios: not compared, another " + different + "\n";
  } else {
    double widest = 1.0;
    const Findings ratios =
        compare_ratios(rows_by(old_report, whole), rows_by(new_report, whole), widest);
    const std::size_t allowed = ratios.compared / 100 + 1;
    const bool agree = ratios.lines.size() <= allowed && widest <= widest_gap;
    result.agrees = result.agrees && agree;
    result.text += fmt::format(
        "ratios: {} rows, the intervals of {} meet; {} may miss by chance, by a tenth at most: "
        "{}\n",
        ratios.compared, ratios.compared - ratios.lines.size(), allowed,
        agree ? "they agree" : "they do not agree");
    result.text += ratios.text();
  }
  result.text += fmt::format("rows in one alone: {} in {}, {} in {}\n", only_old, old_report.name,
                             only_in(new_rows, old_rows), new_report.name);
  return result;
}

}  // namespace magicmass::command
