// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>

#include <fmt/format.h>

#include "command/demo/demo_report.hpp"
#include "command/demo/paper_table_two.hpp"
#include "magicmass/ratios_product.hpp"

namespace magicmass::command {
namespace {

std::size_t decimals(std::string_view printed) {
  const std::size_t point = printed.find('.');
  return point == std::string_view::npos ? 0 : printed.size() - point - 1;
}

/// "rounded" or "cut" where the paper's digits are ours, rounded to as many decimals or cut off there; else "NO".
std::string match(std::string_view printed, long double value) {
  if (fmt::format("{:.{}f}", value, decimals(printed)) == printed) return "rounded";
  const std::string digits = fmt::format("{:.17f}", value);
  return digits.substr(0, printed.size()) == printed ? "cut" : "NO";
}

}  // namespace

void show_ratios(DemoReport& report) {
  report.heading("The paper's Table II, magic and deficient mass ratios");
  report.print("The paper's digits against ours: rounded to as many decimals, or cut off there.\n");
  const auto line = [&](const auto& k, const auto&... cells) {
    report.print(fmt::format("{:>2}  {:<9}{:<21}{:<9}{:<9}{:<21}{}\n", k, cells...));
  };
  line("k", "paper", "alpha_k, generated", "match", "paper", "beta_k, generated", "match");
  for (const PaperRatios& paper : paper_table_two) {
    const auto ours = generated::ratios_product<long double>(paper.k);
    const std::string magic = match(paper.magic, ours.magic);
    const std::string deficient = match(paper.deficient, ours.deficient);
    report.count_in(magic != "NO" && deficient != "NO");
    line(paper.k, paper.magic, static_cast<double>(ours.magic), magic, paper.deficient,
         static_cast<double>(ours.deficient), deficient);
  }
}

}  // namespace magicmass::command
