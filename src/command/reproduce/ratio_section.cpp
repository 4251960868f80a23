// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "command/demo/paper_table_two.hpp"
#include "command/ratio_forms.hpp"
#include "command/reproduce/sections.hpp"
#include "equality/bounded.hpp"
#include "magicmass/accurate.hpp"

namespace magicmass::command {
namespace {

Comparison exact_form(const std::string& quantity, const std::string& paper,
                      const std::string& ours) {
  const equality::Verdict decided = equality::answer_within({paper, ours, {}});
  return {"exact:bk", quantity, paper, ours, "", decided.answer == equality::Answer::equal};
}

}  // namespace

ComparisonSection ratio_section() {
  ComparisonSection section{"Magic and deficient mass ratios",
                            "Table II of the paper, and the values below eq. exact:bk. Exact forms "
                            "are compared by the equality kernel, decimals by their digits.",
                            {}};
  for (const PaperRatios& paper : paper_table_two) {
    const auto ours = accurate::ratios(paper.k);
    section.rows.push_back({"table:akbk", fmt::format("alpha_{}", paper.k),
                            std::string(paper.magic), fmt::format("{}", ours.magic), ""});
    section.rows.push_back({"table:akbk", fmt::format("beta_{}", paper.k),
                            std::string(paper.deficient), fmt::format("{}", ours.deficient), ""});
  }
  const auto first = accurate::ratios(1), second = accurate::ratios(2);
  section.rows.push_back(exact_form("beta_1", "sqrt(2)-1", *deficient_forms(1, false).radicals));
  section.rows.push_back(exact_form("alpha_2", "sqrt(5)-2", *magic_forms(2, false).radicals));
  section.rows.push_back(
      exact_form("beta_2", "(2-sqrt(3))/sqrt(3)", *deficient_forms(2, false).radicals));
  section.rows.push_back({"exact:bk", "beta_1", "0.414", fmt::format("{}", first.deficient), ""});
  section.rows.push_back({"exact:bk", "alpha_2", "0.236", fmt::format("{}", second.magic), ""});
  section.rows.push_back({"exact:bk", "beta_2", "0.155", fmt::format("{}", second.deficient), ""});
  section.rows.push_back(
      {"fig:trajectories", "alpha_3", "0.11", fmt::format("{}", accurate::ratios(3).magic), ""});
  return section;
}

}  // namespace magicmass::command
