// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "command/report/report_tables.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

constexpr std::string_view headline_begin = "<!-- written by `magicmass report --headline`: -->\n";
constexpr std::string_view headline_end = "<!-- end -->\n";

/// What a quantity's rows are, in their order; each has the same name and the same errors on every machine.
std::vector<std::string> shown_evaluators(const std::string& quantity) {
  if (quantity == "counts")
    return {"naive", "stepping", "digits_50", "count_collisions", "batch_count"};
  return {"naive",          "stepping",           "digits_50",
          "exact_rational", quantity + "_closed", quantity + "_product",
          "fast",           "batch_fast",         "accurate",
          "batch_accurate"};
}

std::string ns(const Entry& entry) {
  return entry.time ? short_number(entry.time->ns_median) : "-";
}

std::string ulp(const Entry& entry) {
  return (entry.is_reproducible ? "" : "~") + short_number(entry.worst().max_ulp);
}

/// Where an evaluator did worst, and how it did on the last, easiest family.
struct Summary {
  const Entry* hardest = nullptr;
  const report::Family* hardest_family = nullptr;
  const Entry* easiest = nullptr;
  double over_envelope = 0.0;
  std::size_t wrong = 0, asked = 0;
};

using Key = std::pair<std::string, std::string>;

std::string row_of(const Key& key, const Summary& one) {
  return markdown_row({key.first, key.second, one.hardest_family->name, ulp(*one.hardest),
                       ns(*one.hardest), short_number(one.over_envelope),
                       fmt::format("{} of {}", one.wrong, one.asked), ulp(*one.easiest),
                       ns(*one.easiest), shown_ratio_with_interval(one.easiest->time)});
}

}  // namespace

std::string report_headline(const Measurement& measurement) {
  std::vector<std::string> quantities;
  std::map<Key, Summary> summaries;
  for (const MeasuredFamily& one : measurement.families) {
    if (quantities.empty() || quantities.back() != one.family.quantity)
      quantities.push_back(one.family.quantity);
    for (const Entry& entry : one.entries) {
      if (entry.precision != "double" || entry.errors.empty()) continue;
      Summary& summary = summaries[{one.family.quantity, entry.evaluator}];
      if (!summary.hardest || entry.worst().max_ulp > summary.hardest->worst().max_ulp) {
        summary.hardest = &entry;
        summary.hardest_family = &one.family;
      }
      summary.easiest = &entry;
      for (const report::ErrorRow& error : entry.errors) {
        summary.wrong += error.wrong + error.wrong_signs;
        summary.asked += error.samples;
        summary.over_envelope = std::max(summary.over_envelope, error.over_envelope);
      }
    }
  }
  std::string text = markdown_head(
      {"quantity", "evaluator", "worst on", "ulp there", "ns there", "error / envelope",
       "wrong signs or counts", "everyday ulp", "everyday ns", "ratio to naive (95 %)"},
      3);
  for (const std::string& quantity : quantities)
    for (const std::string& evaluator : shown_evaluators(quantity))
      if (const auto found = summaries.find({quantity, evaluator}); found != summaries.end())
        text += row_of(found->first, found->second);
  return text;
}

std::string with_headline(const std::string& text, const std::string& headline,
                          const std::string& path) {
  const std::size_t begin = text.find(headline_begin);
  const std::size_t end =
      begin == std::string::npos ? begin : text.find(headline_end, begin + headline_begin.size());
  if (end == std::string::npos)
    throw InvalidInput(shown_text(path, 200) + ": no place for the headline: it needs the line \"" +
                       std::string(headline_begin.substr(0, headline_begin.size() - 1)) +
                       "\" and after it \"<!-- end -->\"");
  return text.substr(0, begin + headline_begin.size()) + headline + text.substr(end);
}

}  // namespace magicmass::command
