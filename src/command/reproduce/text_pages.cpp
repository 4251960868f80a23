// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "command/records.hpp"
#include "command/report/report_tables.hpp"
#include "command/reproduce/pages.hpp"

namespace magicmass::command {

std::string reproduction_markdown(const std::vector<ComparisonSection>& sections,
                                  const std::vector<ShownFigure>& figures) {
  std::string text =
      "# The paper's numbers and figures, reproduced\n\n" + tally_text(tally(sections)) + ".\n";
  for (const ComparisonSection& section : sections) {
    text += fmt::format("\n## {}\n\n{}\n\n", section.title, section.words);
    text += markdown_head({"quantity", "paper", "ours", "verdict", "label in the paper"}, 5);
    for (const Comparison& row : section.rows) {
      const std::string why = reason(row);
      text += markdown_row({row.quantity, row.paper.empty() ? "–" : row.paper, row.ours,
                            verdict(row) + (why.empty() ? "" : ": " + why), "`" + row.place + "`"});
    }
  }
  text += "\n## Figures\n";
  for (const ShownFigure& shown : figures)
    text += fmt::format(
        "\n### {0}\n\n![{1}]({2}.svg)\n\n{1} [PNG]({2}.png), [PDF]({2}.pdf), [data]({2}.csv){3}\n",
        shown.title, shown.description, shown.name,
        shown.name == "cradle" ? ", [in motion](cradle.html)" : "");
  return text;
}

std::string comparison_csv(const std::vector<ComparisonSection>& sections) {
  std::string text = "section,place,quantity,paper,ours,verdict,reason\n";
  for (const ComparisonSection& section : sections)
    for (const Comparison& row : section.rows)
      text += csv_line({text_cell(section.title), text_cell(row.place), text_cell(row.quantity),
                        text_cell(row.paper), text_cell(row.ours), text_cell(verdict(row)),
                        text_cell(reason(row))});
  return text;
}

}  // namespace magicmass::command
