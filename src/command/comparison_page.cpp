// SPDX-License-Identifier: GPL-2.0-or-later
// Comparisons as tables and pages.
#include <algorithm>

#include "command/comparison.hpp"

namespace command {
namespace {

using namespace answers;

std::string verdict(const Comparison& one) {
  return one.agrees ? "agrees" : one.is_fine ? "explained" : "differs";
}

Table table_of(const std::vector<Comparison>& all) {
  Table table{{"label", "number", "printed", "ours", "verdict", "reason"}, {}};
  for (const Comparison& one : all) {
    table.rows.push_back({text_cell(one.label), text_cell(one.number), text_cell(one.printed),
                          text_cell(one.ours), text_cell(verdict(one)),
                          one.reason.empty() ? missing_cell() : text_cell(one.reason)});
  }
  return table;
}

std::string summary_of(const std::vector<Comparison>& all) {
  const auto count = [&](const std::string& wanted) {
    return std::to_string(std::ranges::count(all, wanted, verdict));
  };
  return std::to_string(all.size()) + " numbers of the paper: " + count("agrees") + " agree, " +
         count("explained") + " differ for the reason given, " + count("differs") +
         " without one\nHeadings are labels of its LaTeX source.\n";
}

/// What a label of the paper stands at.
std::string kind_of(const std::string& label) {
  return label[0] == 't' ? "Table " : label[0] == 'f' ? "Figure " : "Equation ";
}

/// A heading and a narrow table for each label, and under it why numbers differ.
std::string document_of(const std::vector<Comparison>& all, bool is_markdown) {
  std::string text = summary_of(all);
  for (auto first = all.begin(); first != all.end();) {
    const auto last = std::find_if(
        first, all.end(), [&](const Comparison& one) { return one.label != first->label; });
    Table table = table_of({first, last});
    std::vector<std::string> reasons;
    for (; first != last; ++first)
      if (!first->reason.empty() && std::count(reasons.begin(), reasons.end(), first->reason) == 0)
        reasons.push_back(first->reason);
    const std::string label = table.rows[0][0].text;
    text += (is_markdown ? "\n## " : "\n") + kind_of(label) + label + "\n\n";
    const auto narrow = [](auto& row) {
      row.erase(row.begin());
      row.pop_back();
    };
    narrow(table.columns);
    std::ranges::for_each(table.rows, narrow);
    text += is_markdown ? markdown(table) : written(table, Format::text);
    for (const std::string& reason : reasons) text += "\n" + reason + "\n";
  }
  return text;
}

}  // namespace

Answer page_of(const std::vector<Comparison>& all, const std::string& format) {
  Answer answer{table_of(all), ""};
  if (format == "text" || format == "markdown")
    answer.document = document_of(all, format == "markdown");
  answer.check_failed = !std::ranges::all_of(all, &Comparison::is_fine);
  return answer;
}

}  // namespace command
