// SPDX-License-Identifier: GPL-2.0-or-later
// A number of the paper beside ours, and whether they agree.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace magicmass::command {

struct Comparison {
  std::string place;                  ///< the paper's label of the table, figure or equation
  std::string quantity;               ///< "alpha_3"
  std::string paper;                  ///< as it is printed there; empty where it is not
  std::string ours;                   ///< all digits that are worth something
  std::string reason;                 ///< why the two differ, where that is known
  std::optional<bool> is_equal = {};  ///< where a proof decided it: expressions
};

struct ComparisonSection {
  std::string title;
  std::string words;
  std::vector<Comparison> rows;
};

enum class Match {
  agrees,       ///< ours has the paper's digits when rounded to as many
  cut_off,      ///< it has them when cut off there
  differs,      ///< neither
  not_printed,  ///< the paper has no such number
};

/// Whole numbers are compared as they are, decimals to the digits printed. What is no number agrees if it is the same
/// text, or if a proof said so.
Match match(const Comparison& row);

/// "agrees", "agrees, cut off", "differs", "not in the paper".
std::string verdict(const Comparison& row);
/// Of a difference; of one that nobody explains, too.
std::string reason(const Comparison& row);

struct Tally {
  int agree = 0;        ///< cut off or not
  int explained = 0;    ///< differ, with a reason
  int unexplained = 0;  ///< differ
  int not_printed = 0;
};
Tally tally(const std::vector<ComparisonSection>& sections);
/// "92 quoted numbers: 90 agree, 2 differ for the reason given, 0 differ without one; ..."
std::string tally_text(const Tally& tally);

}  // namespace magicmass::command
