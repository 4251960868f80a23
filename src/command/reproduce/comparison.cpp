// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/reproduce/comparison.hpp"

#include <cstdlib>

#include <fmt/format.h>

namespace magicmass::command {
namespace {

std::optional<double> number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') return std::nullopt;
  return value;
}

std::size_t decimals(const std::string& printed) {
  const std::size_t point = printed.find('.');
  return point == std::string::npos ? 0 : printed.size() - point - 1;
}

std::string rounded(double value, std::size_t to) { return fmt::format("{:.{}f}", value, to); }

}  // namespace

Match match(const Comparison& row) {
  if (row.paper.empty()) return Match::not_printed;
  if (row.is_equal) return *row.is_equal ? Match::agrees : Match::differs;
  if (row.paper == row.ours) return Match::agrees;
  const std::optional<double> printed = number(row.paper), ours = number(row.ours);
  if (!printed || !ours) return Match::differs;
  const std::size_t digits = decimals(row.paper);
  if (digits == 0) return *printed == *ours ? Match::agrees : Match::differs;
  if (rounded(*ours, digits) == row.paper) return Match::agrees;
  const std::string long_text = rounded(*ours, digits + 8);
  return long_text.substr(0, row.paper.size()) == row.paper ? Match::cut_off : Match::differs;
}

std::string verdict(const Comparison& row) {
  switch (match(row)) {
    case Match::agrees:
      return "agrees";
    case Match::cut_off:
      return "agrees, cut off";
    case Match::differs:
      return "differs";
    case Match::not_printed:
      return "not in the paper";
  }
  return "";
}

std::string reason(const Comparison& row) {
  if (match(row) == Match::cut_off)
    return "printed digits are cut off; rounded they would be " +
           rounded(*number(row.ours), decimals(row.paper));
  if (match(row) == Match::differs)
    return row.reason.empty() ? "not explained: one of the two is wrong" : row.reason;
  return match(row) == Match::not_printed ? row.reason : "";
}

Tally tally(const std::vector<ComparisonSection>& sections) {
  Tally sum;
  for (const ComparisonSection& section : sections)
    for (const Comparison& row : section.rows) {
      const Match found = match(row);
      if (found == Match::not_printed)
        ++sum.not_printed;
      else if (found != Match::differs)
        ++sum.agree;
      else
        ++(row.reason.empty() ? sum.unexplained : sum.explained);
    }
  return sum;
}

std::string tally_text(const Tally& tally) {
  return fmt::format(
      "{} quoted numbers: {} agree, {} differ for the reason given, {} differ without one; {} more "
      "of "
      "ours that the paper does not print",
      tally.agree + tally.explained + tally.unexplained, tally.agree, tally.explained,
      tally.unexplained, tally.not_printed);
}

}  // namespace magicmass::command
