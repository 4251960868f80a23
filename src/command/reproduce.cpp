// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/reproduce.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>

#include "answers/errors.hpp"
#include "answers/shown_text.hpp"
#include "answers/velocities.hpp"
#include "command/comparison.hpp"
#include "command/embedded.hpp"
#include "command/figure.hpp"
#include "generate/tree.hpp"
#include "report/report.hpp"

namespace command {
namespace {

using namespace answers;

std::string verdict(const Comparison& one) {
  return one.agrees ? "agrees" : one.is_fine ? "explained" : "differs";
}

Table table_of(const std::vector<Comparison>& all) {
  Table table{reproduce_columns(), {}};
  for (const Comparison& one : all) {
    table.rows.push_back({text_cell(one.label), text_cell(one.number), text_cell(one.printed),
                          text_cell(one.ours), text_cell(verdict(one)),
                          one.reason.empty() ? missing_cell() : text_cell(one.reason)});
  }
  return table;
}

std::string summary_of(const std::vector<Comparison>& all) {
  const auto count = [&](const std::string& wanted) {
    return std::to_string(std::count_if(all.begin(), all.end(),
                                        [&](const auto& one) { return verdict(one) == wanted; }));
  };
  return std::to_string(all.size()) + " numbers of the paper: " + count("agrees") + " agree, " +
         count("explained") + " differ for the reason given, " + count("differs") +
         " differ without one\n";
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
    text += (is_markdown ? "\n## " : "\n") + table.rows[0][0].text + "\n\n";
    const auto narrow = [](auto& row) {
      row.erase(row.begin());
      row.pop_back();
    };
    narrow(table.columns);
    std::for_each(table.rows.begin(), table.rows.end(), narrow);
    text += is_markdown ? markdown(table) : written(table, Format::text);
    for (const std::string& reason : reasons) text += "\n" + reason + "\n";
  }
  return text;
}

/// The figures of the paper and of errors in four formats, and the tables.
std::map<std::string, std::string> files_of(const std::vector<Comparison>& all) {
  std::map<std::string, std::string> files{{"reproduce.md", document_of(all, true)},
                                           {"reproduce.csv", written(table_of(all), Format::csv)},
                                           {"ratios.csv", written(ratios({}).table, Format::csv)}};
  std::vector<Figure> wanted = figures();
  std::copy_if(report::figures().begin(), report::figures().end(), std::back_inserter(wanted),
               [](const Figure& figure) { return figure.name != "speed"; });  // it is measured
  for (const Figure& figure : wanted) {
    const Table data = figure.data();
    for (const std::string format : {"svg", "png", "pdf", "csv"})
      files[figure.name + "." + format] = picture(figure, data, format);
  }
  return files;
}

/// All files or none; a folder that was not there either.
void write(const std::string& folder, const std::vector<Comparison>& all) {
  std::error_code error;
  const bool is_new = std::filesystem::create_directories(folder, error);
  if (error)
    throw InvalidInput("reproduce: --out " + shown_text(folder) + ": " + error.message() +
                       "; allowed: a folder to write to");
  try {
    generate::write(folder, files_of(all));
  } catch (...) {
    if (is_new) std::filesystem::remove(folder, error);
    throw;
  }
}

}  // namespace

std::vector<Column> reproduce_columns() {
  return {{"label", Type::text, "", "of the paper's equation, table or figure"},
          {"number", Type::text, "", "what it is"},
          {"printed", Type::text, "", "in the paper"},
          {"ours", Type::text, "", "all digits"},
          {"verdict", Type::text, "", "agrees, explained (differs for a reason), differs"},
          {"reason", Type::text, "", "why it differs"}};
}

Answer reproduce(const Request& request) {
  const std::vector<Comparison> all = comparisons(embedded("paper_numbers.csv"));
  Answer answer{table_of(all), ""};
  if (request.format == "text" || request.format == "markdown")
    answer.document = document_of(all, request.format == "markdown");
  if (request.has("out")) write(request.text("out"), all);
  answer.check_failed =
      !std::all_of(all.begin(), all.end(), [](const Comparison& one) { return one.is_fine; });
  return answer;
}

}  // namespace command
